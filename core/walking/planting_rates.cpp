// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/planting_rates.h"

#include "core/walking/foot_lock.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivar {
namespace {

std::size_t index_of(int n)
{
    return static_cast<std::size_t>(n);
}

Rates product(const Rates& a, const Rates& b)
{
    return {a.most * b.most, a.first * b.most + a.most * b.first,
            a.second * b.most + 2 * a.first * b.first + a.most * b.second};
}

// Bounds the rates of 1 / x, where x is at least `least`.
Rates inverse_of(const Rates& x, double least)
{
    const double w = 1 / least;
    return {w, x.first * w * w, (x.second + 2 * x.first * x.first * w) * w * w};
}

} // namespace

// Bounds the share of the point at any moment, from its value at the middle one.
Rates PlantingRates::share(int node, const Rates& point) const
{
    const int which = bone_of_node_[index_of(node)];
    if (which < 0) return {};
    if (index_of(which) >= bones_.size()) return {1, 0, 0}; // the foot
    const Bone& bone = bones_[index_of(which)];
    Rates way = bone.rates[index_of(node)].of(point); // from the joint
    way.first = bone.scale * (way.first + bone.own.shift);
    way.second = bone.scale * (way.second + bone.own.swing);
    way.most = glm::distance(origins_[index_of(node)], bone.joint) +
               sizes_[index_of(node)] * point.most + way.first * half_s_;
    Rates along = bone.above;
    along.add(product(bone.direction, way), 1);
    return product(along, inverse_length_);
}

Rates PlantingRates::at(int node, const Rates& point) const
{
    if (displacement_.most == 0) return {};
    return product(product(share(node, point), inverse_share_), displacement_);
}

// Adds the bones of a leg; false if no bound is known.
bool PlantingRates::add_bones(const Model& model, const Foot& foot, const Stance& middle,
                              const std::vector<LocalRates>& local)
{
    bone_of_node_ = bones_of_nodes(model, foot);
    for (const glm::dmat4& m : middle.to_model) origins_.emplace_back(m[3]);
    const std::vector<NodeRates> in_model = node_rates(model, local);
    for (const NodeRates& r : in_model) sizes_.push_back(r.size);
    bool rigid = true; // down to a joint
    for (int n = model.nodes[index_of(foot.leg.front())].parent; n >= 0;
         n = model.nodes[index_of(n)].parent)
        rigid = rigid && local[index_of(n)].rigid;
    double reach = 0, whole = 0; // bounds
    for (std::size_t i = 0; i + 1 < foot.leg.size(); ++i) {
        const int joint = foot.leg[i], next = foot.leg[i + 1];
        Bone bone;
        bone.joint = origins_[index_of(joint)];
        rigid = rigid && local[index_of(joint)].rigid;
        bone.rates = rigid ? node_rates(model, local, joint) : in_model;
        if (rigid) bone.scale = glm::length(glm::dvec3(middle.to_model[index_of(joint)][0]));
        bone.own = bone.rates[index_of(joint)];
        const NodeRates& end = bone.rates[index_of(next)];
        bone.way = {glm::distance(bone.joint, origins_[index_of(next)]),
                    bone.scale * (bone.own.shift + end.shift),
                    bone.scale * (bone.own.swing + end.swing)};
        whole += bone.way.most + bone.way.first * half_s_;
        for (const int n : {joint, next})
            reach = std::max(reach, glm::length(origins_[index_of(n)]) +
                                        in_model[index_of(n)].shift * half_s_);
        bones_.push_back(std::move(bone));
    }
    Rates length; // of the leg down to the joint, at the middle moment
    for (Bone& bone : bones_) {
        const Rates& way = bone.way;
        bone.above = {length.most + length.first * half_s_, length.first, length.second};
        bone.direction = {1, 0, 0};
        if (way.most == 0 && way.first == 0 && way.second == 0) continue;
        constexpr double clearly = 1e-6; // so that it is above no_length at all times
        const double least = way.most - way.first * half_s_;
        if (!(least > clearly * std::max(reach, whole))) return false;
        bone.direction = direction_of(way, least);
        length.add({way.most, way.first, way.second + way.first * bone.direction.first}, 1);
    }
    const double least = length.most - length.first * half_s_;
    if (length.most == 0) bones_.clear();
    inverse_length_ = inverse_of(length, least);
    return true;
}

// Adds the sole of a foot; false if no bound is known.
bool PlantingRates::add_sole(const Model& model, const Clip& clip, const Foot& foot,
                             const Stance& middle, double middle_s)
{
    Rates sole;                                // its share
    std::map<int, std::vector<Rates>> weights; // of the targets, by node
    for (const ModelVertex& v : foot.sole) {
        const Mesh& mesh = *model.meshes[index_of(model.nodes[index_of(v.node)].mesh)];
        if (!weights.contains(v.node))
            weights[v.node] =
                weight_rates(model, clip, v.node, middle_s - half_s_, middle_s + half_s_);
        for (const VertexMover& mover : movers_of(model, v)) {
            const auto length = [&](const glm::vec3& p, double w) {
                return glm::length(glm::dvec3(mover.before * glm::dvec4(glm::dvec3(p), w)));
            };
            Rates point{length(mesh.positions[v.vertex], 1), 0, 0};
            for (std::size_t t = 0; t < mesh.morph_targets.size(); ++t)
                if (!mesh.morph_targets[t].positions.empty())
                    point.add(weights[v.node][t],
                              length(mesh.morph_targets[t].positions[v.vertex], 0));
            sole.add(share(mover.node, point),
                     mover.weight / static_cast<double>(foot.sole.size()));
        }
    }
    constexpr double clearly = 1e-6;
    const double is = share_of_sole(model, foot, middle), change = sole.first * half_s_ + clearly;
    if (is - change > least_share_of_sole)
        inverse_share_ = inverse_of(sole, is - change);
    else if (!(is + change < least_share_of_sole))
        return false;
    return true;
}

std::optional<PlantingRates> PlantingRates::of(const Model& model, const Clip& clip,
                                               const Gait& gait, std::size_t which,
                                               const std::vector<LocalRates>& local, double from_s,
                                               double to_s)
{
    const Foot& foot = gait.feet[which];
    PlantingRates out;
    if (!gait.trouble.empty() || foot.leg.empty() || foot.shift.empty()) return out;
    const double middle_s = (from_s + to_s) / 2;
    const auto count = static_cast<double>(foot.shift.size());
    const double phase = (middle_s - gait.begin_s) / gait.period_s - foot.begin;
    const auto step = std::min(static_cast<std::size_t>((phase - std::floor(phase)) * count),
                               foot.shift.size() - 1);
    const glm::dvec3 &a = foot.shift[step], &b = foot.shift[(step + 1) % foot.shift.size()];
    out.displacement_ = {std::max(glm::length(a), glm::length(b)),
                         glm::distance(a, b) * count / gait.period_s, 0};
    if (out.displacement_.most == 0) return out;
    out.half_s_ = (to_s - from_s) / 2;
    const Stance middle = stance_at(model, &clip, middle_s);
    if (!out.add_bones(model, foot, middle, local)) return {};
    if (!out.add_sole(model, clip, foot, middle, middle_s)) return {};
    return out;
}

} // namespace trivar
