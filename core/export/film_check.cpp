// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/film_check.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

const Channel* weights_of_node(const Model& model, int node)
{
    if (model.clips.empty()) return nullptr;
    for (const Channel& channel : model.clips.front().channels)
        if (channel.node == node && channel.of == Channel::Of::morph_weights) return &channel;
    return nullptr;
}

// What the file shows of a part: its vertices in the world.
std::vector<glm::dvec3> shown_by_file(const Model& model, int node, const Stance& stance,
                                      const Channel* weights, double time_s)
{
    const Node& at = model.nodes[static_cast<std::size_t>(node)];
    const Mesh& mesh = *model.meshes[static_cast<std::size_t>(at.mesh)];
    std::vector<glm::dvec3> out(mesh.positions.begin(), mesh.positions.end());
    if (weights && !mesh.morph_targets.empty()) {
        const std::vector<double> w = value_at(*weights, time_s);
        for (std::size_t t = 0; t < w.size(); ++t)
            if (w[t] != 0)
                for (std::size_t v = 0; v < out.size(); ++v)
                    out[v] += w[t] * glm::dvec3(mesh.morph_targets[t].positions[v]);
    }
    if (at.skin < 0) {
        const glm::dmat4& to_world = stance.to_model[static_cast<std::size_t>(node)];
        for (glm::dvec3& p : out) p = glm::dvec3(to_world * glm::dvec4(p, 1));
        return out;
    }
    const Skin& skin = model.skins[static_cast<std::size_t>(at.skin)];
    std::vector<glm::dmat4> joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
        joints.push_back(stance.to_model[static_cast<std::size_t>(skin.joints[j])] *
                         skin.mesh_to_joint[j]);
    for (std::size_t v = 0; v < out.size(); ++v) {
        const Mesh::Influences& by = mesh.influences[v];
        glm::dvec4 sum(0);
        for (int k = 0; k < 4; ++k)
            if (by.weights[k] > 0)
                sum += double{by.weights[k]} *
                       (joints[by.joints[static_cast<std::size_t>(k)]] * glm::dvec4(out[v], 1));
        out[v] = glm::dvec3(sum);
    }
    return out;
}

// The part as it is then, if it has the triangles that it has in the file; else null.
const Part* shown_in(const EvaluatedObject& object, const FilmStrip& strip)
{
    const Ref<Mesh>& rest = strip.first().rest;
    for (const Part& part : object.parts)
        if (part.slot == strip.slot)
            return part.rest == rest || same_faces(*part.rest, *rest) ? &part : nullptr;
    return nullptr;
}

void compare(FilmSample& sample, const CommonMesh& common, const Part& truth,
             const std::vector<glm::dvec3>& file, double frame)
{
    const auto add = [&](const glm::dvec3& shown, const glm::dvec3& true_place) {
        ++sample.samples;
        const double off = glm::distance(shown, true_place);
        if (off <= sample.furthest) return;
        sample.furthest = std::isfinite(off) ? off : std::numeric_limits<double>::infinity();
        sample.at_frame = frame;
    };
    if (!truth.bent) {
        const Mesh mesh = truth.posed ? posed(*truth.rest, truth.posed->pose) : *truth.rest;
        for (std::size_t v = 0; v < file.size(); ++v)
            add(file[v], glm::dvec3(truth.to_world * glm::dvec4(mesh.positions[v], 1)));
        return;
    }
    const Mesh flat = before_volume(common, truth);
    const auto there = [&](const glm::dvec3& p) {
        return deform(p, truth.bent->embedding, *truth.bent->volume).position_world;
    };
    for (std::size_t v = 0; v < file.size(); ++v)
        add(file[v], there(glm::dvec3(flat.positions[v])));
    for (std::size_t c = 0; c + 2 < flat.corners.size(); c += 3) {
        glm::dvec3 shown(0), middle(0);
        for (std::size_t k = 0; k < 3; ++k) {
            shown += file[flat.corners[c + k]] / 3.0;
            middle += glm::dvec3(flat.positions[flat.corners[c + k]]) / 3.0;
        }
        add(shown, there(middle));
    }
}

} // namespace

std::vector<FilmSample> sampled_film(const AnimatedExport& exported, const Document& document,
                                     const Ref<AssetStore>& assets, int per_frame,
                                     const Progress& progress)
{
    const FilmCertificate& claims = exported.certificate;
    const Document plain = unrefined(document);
    Evaluator evaluator(assets);
    const std::vector<double> frames =
        moments_of({claims.first_frame, claims.last_frame}, per_frame);
    const Model& model = exported.model;
    const Clip* clip = model.clips.empty() ? nullptr : &model.clips.front();
    std::vector<FilmSample> out(claims.parts.size());
    std::vector<const Channel*> weights;
    for (const FilmCertificate::PartClaim& claim : claims.parts)
        weights.push_back(weights_of_node(model, claim.node));
    const std::vector<double>& moments = exported.film.moments;
    // What was compared last of each part, and how many samples that was: what rests in the file
    // and in the scene is found once.
    struct Compared {
        Ref<EvaluatedObject> object;
        const Part* part = nullptr;
        std::size_t samples = 0;
    };
    std::vector<Compared> last(out.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double frame = frames[i];
        report(progress, static_cast<double>(i) / static_cast<double>(frames.size()), "comparing");
        const Evaluated now = evaluator(plain, frame);
        const double time_s = (frame - claims.first_frame) / claims.frames_per_second;
        const Stance stance = stance_at(model, clip, time_s);
        const auto after = std::ranges::lower_bound(moments, frame);
        const auto next = static_cast<std::size_t>(after - moments.begin());
        const std::size_t before = *after == frame ? next : next - 1;
        parallel_blocks(out.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                const FilmStrip& strip = exported.film.strips[p];
                if (!strip.shown[before] || !strip.shown[next]) continue;
                const auto object = now.objects.find(strip.object);
                if (object == now.objects.end()) continue;
                const Part* truth = shown_in(*object->second, strip);
                if (!truth) continue;
                if (claims.parts[p].way == "still" && last[p].part == truth) {
                    out[p].samples += last[p].samples;
                    continue;
                }
                last[p] = {object->second, truth, out[p].samples};
                compare(out[p], exported.common[p], *truth,
                        shown_by_file(model, claims.parts[p].node, stance, weights[p], time_s),
                        frame);
                last[p].samples = out[p].samples - last[p].samples;
            }
        });
    }
    return out;
}

} // namespace trivar
