// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/target_keys.h"

#include "core/certificate/keys.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

struct MomentVertices {
    std::vector<glm::vec3> positions, normals;
};

MomentVertices seen_at(const CommonMesh& common, const Part& part)
{
    Mesh mesh = part.bent
                    ? deform(before_volume(common, part), part.bent->embedding, *part.bent->volume)
                    : mesh_in_world(part);
    return {std::move(mesh.positions), std::move(mesh.normals)};
}

std::vector<glm::vec3> differences(const std::vector<glm::vec3>& from,
                                   const std::vector<glm::vec3>& to)
{
    std::vector<glm::vec3> out(to.size());
    for (std::size_t v = 0; v < to.size(); ++v) out[v] = to[v] - from[v];
    return out;
}

// Places are the positions in the file: those of the base plus a difference in single precision.
class Places {
public:
    Places(const std::vector<MomentVertices>& all, const std::vector<const MomentVertices*>& at,
           const std::vector<float>& times_s)
        : base_(all.front().positions),
          at_(at),
          times_s_(times_s)
    {
    }
    glm::dvec3 in_file(std::size_t moment, std::size_t v) const
    {
        const glm::vec3 difference = at_[moment]->positions[v] - base_[v];
        return glm::dvec3(base_[v]) + glm::dvec3(difference);
    }
    // Bounds how far vertices are off at a moment if two other moments are keys, including the
    // rounding of times.
    double off(std::size_t from, std::size_t to, std::size_t moment) const
    {
        const double share = from == to ? 0
                                        : (double{times_s_[moment]} - double{times_s_[from]}) /
                                              (double{times_s_[to]} - double{times_s_[from]});
        const std::vector<glm::vec3>& there = at_[moment]->positions;
        double most = 0, longest = 0;
        for (std::size_t v = 0; v < there.size(); ++v) {
            const glm::dvec3 p = in_file(from, v), q = in_file(to, v);
            const glm::dvec3 d = p + share * (q - p) - glm::dvec3(there[v]);
            most = std::max(most, glm::dot(d, d));
            longest = std::max(longest, glm::dot(q - p, q - p));
        }
        const double span = double{times_s_[to]} - double{times_s_[from]};
        const double late = span > 0 ? 0x1p-23 * double{times_s_[to]} / span : 0;
        return std::sqrt(most) + late * std::sqrt(longest);
    }

private:
    const std::vector<glm::vec3>& base_;
    const std::vector<const MomentVertices*>& at_;
    const std::vector<float>& times_s_;
};

} // namespace

TargetKeys target_keys(const Film& film, const FilmStrip& strip, const CommonMesh& common,
                       const std::vector<double>& allowed, const std::vector<float>& times_s)
{
    const std::size_t count = film.moments.size();
    std::vector<MomentVertices> all;
    all.reserve(count);
    std::vector<const MomentVertices*> at(count, nullptr);
    const Part* last = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        const Part* part = strip.shown[i];
        const bool same = part && last && part->rest == last->rest && part->posed == last->posed &&
                          part->to_world == last->to_world && part->bent && last->bent &&
                          part->bent->volume == last->bent->volume &&
                          part->bent->embedding == last->bent->embedding;
        if (part && !same) all.push_back(seen_at(common, *part));
        if (part) last = part;
        at[i] = all.empty() ? nullptr : &all.back();
    }
    for (std::size_t i = count; i-- > 0;) // before its first appearance it has its first positions
        if (!at[i]) at[i] = &all.front();
    const Places places(all, at, times_s);
    const auto holds = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from + 1; i < to; ++i)
            if (strip.shown[i] && !(places.off(from, to, i) <= allowed[i])) return false;
        return true;
    };
    TargetKeys out;
    out.off.assign(count, 0);
    if (all.size() == 1)
        out.keys = {0};
    else
        out.keys = chosen_keys(count, holds);
    for (std::size_t k = 0; k + 1 < out.keys.size(); ++k)
        for (std::size_t i = out.keys[k]; i <= out.keys[k + 1]; ++i)
            if (strip.shown[i])
                out.off[i] = std::max(out.off[i], places.off(out.keys[k], out.keys[k + 1], i));

    out.mesh = before_volume(common, strip.first());
    out.mesh.tangents.clear(); // a viewer computes them again if there are keys
    out.mesh.positions = at.front()->positions;
    out.mesh.normals = at.front()->normals;
    const std::size_t targets = out.keys.size() - 1;
    if (targets == 0) return out;
    out.weights.of = Channel::Of::morph_weights;
    out.weights.components = targets;
    for (std::size_t k = 0; k <= targets; ++k) {
        out.weights.times_s.push_back(times_s[out.keys[k]]);
        for (std::size_t t = 1; t <= targets; ++t)
            out.weights.values.push_back(t == k ? 1.0f : 0.0f);
        if (k == 0) continue;
        const MomentVertices& there = *at[out.keys[k]];
        out.mesh.morph_targets.push_back({differences(out.mesh.positions, there.positions),
                                          differences(out.mesh.normals, there.normals),
                                          {}});
    }
    return out;
}

} // namespace trivar
