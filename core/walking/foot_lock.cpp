// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/foot_lock.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

glm::dvec3 origin(const Stance& stance, int node)
{
    return glm::dvec3(stance.to_model[static_cast<std::size_t>(node)][3]);
}

// Returns the offset that is added to a foot.
glm::dvec3 shift_at(const Gait& gait, const Foot& foot, double time_s)
{
    const double t = (time_s - gait.begin_s) / gait.period_s - foot.begin;
    const auto count = foot.shift.size();
    const double step = (t - std::floor(t)) * static_cast<double>(count);
    const auto i = std::min(static_cast<std::size_t>(step), count - 1);
    return glm::mix(foot.shift[i], foot.shift[(i + 1) % count], step - static_cast<double>(i));
}

Stance moved(const Model& model, Stance stance, const Foot& foot, const glm::dvec3& d)
{
    const std::vector<Shear> shear = shears(foot, stance);
    const std::vector<int> by = bones_of_nodes(model, foot);
    for (std::size_t n = 0; n < model.nodes.size(); ++n)
        if (by[n] >= 0)
            stance.to_model[n] =
                shear[static_cast<std::size_t>(by[n])].matrix(d) * stance.to_model[n];
    return stance;
}

} // namespace

glm::dmat4 Shear::matrix(const glm::dvec3& d) const
{
    glm::dmat4 out(1);
    for (int column = 0; column < 3; ++column) out[column] += glm::dvec4(d * b[column], 0);
    out[3] += glm::dvec4(d * a, 0);
    return out;
}

std::vector<double> bone_lengths(const Foot& foot, const Stance& stance)
{
    std::vector<double> out;
    double whole = 0, reach = 0;
    for (std::size_t i = 0; i + 1 < foot.leg.size(); ++i) {
        const glm::dvec3 a = origin(stance, foot.leg[i]), b = origin(stance, foot.leg[i + 1]);
        out.push_back(glm::distance(a, b));
        whole += out.back();
        reach = std::max({reach, glm::length(a), glm::length(b)});
    }
    if (whole <= no_length * reach) out.assign(out.size(), 0);
    for (double& length : out)
        if (length <= no_length * whole) length = 0;
    return out;
}

std::vector<Shear> shears(const Foot& foot, const Stance& stance)
{
    const std::vector<double> lengths = bone_lengths(foot, stance);
    double whole = 0, above = 0;
    for (const double length : lengths) whole += length;
    std::vector<Shear> out(foot.leg.size());
    for (std::size_t i = 0; whole > 0 && i < lengths.size(); ++i) {
        out[i].a = above / whole;
        above += lengths[i];
        if (lengths[i] == 0) continue;
        const glm::dvec3 o = origin(stance, foot.leg[i]), e = origin(stance, foot.leg[i + 1]) - o;
        out[i].b = e / (lengths[i] * whole);
        out[i].a -= glm::dot(out[i].b, o);
    }
    return out;
}

std::vector<int> bones_of_nodes(const Model& model, const Foot& foot)
{
    std::vector<int> out(model.nodes.size(), -1);
    for (std::size_t i = 0; i < foot.leg.size(); ++i)
        out[static_cast<std::size_t>(foot.leg[i])] = static_cast<int>(i);
    for (std::size_t n = 0; n < out.size(); ++n)
        if (out[n] < 0 && model.nodes[n].parent >= 0)
            out[n] = out[static_cast<std::size_t>(model.nodes[n].parent)];
    return out;
}

double share_of_sole(const Model& model, const Foot& foot, const Stance& stance)
{
    const std::vector<Shear> shear = shears(foot, stance);
    const std::vector<int> by = bones_of_nodes(model, foot);
    double out = 0;
    for (const ModelVertex& v : foot.sole) {
        const Node& node = model.nodes[static_cast<std::size_t>(v.node)];
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(node.mesh)];
        glm::dvec3 p(mesh.positions[v.vertex]);
        const auto& weights = stance.morph_weights[static_cast<std::size_t>(v.node)];
        for (std::size_t t = 0; t < std::min(weights.size(), mesh.morph_targets.size()); ++t)
            if (!mesh.morph_targets[t].positions.empty())
                p += double{weights[t]} * glm::dvec3(mesh.morph_targets[t].positions[v.vertex]);
        for (const VertexMover& mover : movers_of(model, v)) {
            const auto n = static_cast<std::size_t>(mover.node);
            if (by[n] < 0) continue;
            const Shear& bone = shear[static_cast<std::size_t>(by[n])];
            const glm::dvec3 q(stance.to_model[n] * mover.before * glm::dvec4(p, 1));
            out += mover.weight * (bone.a + glm::dot(bone.b, q));
        }
    }
    return out / static_cast<double>(foot.sole.size());
}

Stance planted(const Model& model, const Clip& clip, const Gait& gait, double time_s)
{
    Stance out = stance_at(model, &clip, time_s);
    if (!gait.trouble.empty()) return out;
    for (const Foot& foot : gait.feet) {
        if (foot.leg.empty()) continue;
        const glm::dvec3 d = shift_at(gait, foot, time_s);
        if (d == glm::dvec3(0)) continue;
        const double share = share_of_sole(model, foot, out);
        out = moved(model, std::move(out), foot, share > least_share_of_sole ? d / share : d);
    }
    return out;
}

double largest_correction(const Gait& gait)
{
    double most = 0;
    for (const Foot& foot : gait.feet)
        if (!foot.leg.empty())
            for (const glm::dvec3& each : foot.shift) most = std::max(most, glm::length(each));
    return gait.stride > 0 ? most / gait.stride : 0;
}

} // namespace trivar
