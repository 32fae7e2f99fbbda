// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/planting_rates.h"

#include "core/mesh/foot_lock.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivar {
namespace {

std::size_t index_of(int n)
{
    return static_cast<std::size_t>(n);
}

} // namespace

// At any moment, from what it is at the middle one.
PlantingRates::Bound PlantingRates::share(int node, const Bound& point) const
{
    int above = node;
    auto at = leg_.end();
    while (above >= 0 && (at = std::ranges::find(leg_, above)) == leg_.end())
        above = model_->nodes[index_of(above)].parent;
    if (above < 0) return {0, 0, 0};
    const auto i = static_cast<std::size_t>(at - leg_.begin());
    if (bones_.empty() || i + 1 == leg_.size()) return {1, 0, 0};
    const Bone& bone = bones_[i];
    const NodeRates& r = bone.rates[index_of(node)];
    const double first = bone.scale *
                         (r.turn * point.most + r.shift + bone.own.shift + r.size * point.first),
                 second = bone.scale * (r.bend * point.most + r.swing + bone.own.swing +
                                        2 * r.turn * point.first + r.size * point.second),
                 reach = glm::distance(origins_[index_of(node)], bone.joint) +
                         sizes_[index_of(node)] * point.most + first * half_s_;
    const Bound &l = bone.before, &e = bone.direction;
    const Bound n{l.most + reach, l.first + e.first * reach + first,
                  l.second + e.second * reach + 2 * e.first * first + second};
    const double w = 1 / least_length_;
    return {n.most * w, n.first * w + n.most * length_.first * w * w,
            n.second * w + 2 * n.first * length_.first * w * w +
                n.most * (length_.second + 2 * length_.first * length_.first * w) * w * w};
}

PlantingRates::Bound PlantingRates::at(int node, const Bound& point) const
{
    const Bound f = share(node, point);
    const double fm = f.most * more_.most, first = f.first * more_.most + f.most * more_.first,
                 second = f.second * more_.most + 2 * f.first * more_.first + f.most * more_.second;
    return {fm * distance_, first * distance_ + fm * speed_,
            second * distance_ + 2 * first * speed_};
}

std::optional<PlantingRates> PlantingRates::of(const Model& model, const Clip& clip,
                                               const Gait& gait, std::size_t which,
                                               const std::vector<LocalRates>& local, double from_s,
                                               double to_s)
{
    const Foot& foot = gait.feet[which];
    PlantingRates out;
    out.model_ = &model;
    if (!gait.trouble.empty() || foot.leg.empty()) return out;
    const double middle = (from_s + to_s) / 2;
    const auto count = static_cast<double>(foot.shift.size());
    const double phase = (middle - gait.begin_s) / gait.period_s - foot.begin;
    const auto step = std::min(static_cast<std::size_t>((phase - std::floor(phase)) * count),
                               foot.shift.size() - 1);
    const glm::dvec3 &d0 = foot.shift[step], &d1 = foot.shift[(step + 1) % foot.shift.size()];
    out.distance_ = std::max(glm::length(d0), glm::length(d1));
    out.speed_ = glm::distance(d0, d1) * count / gait.period_s;

    if (out.distance_ == 0) return out;

    const Stance stance = stance_at(model, &clip, middle);
    out.leg_ = foot.leg;
    out.half_s_ = (to_s - from_s) / 2;
    for (const glm::dmat4& m : stance.to_model) out.origins_.emplace_back(m[3]);
    const std::vector<NodeRates> in_model = node_rates(model, local);
    for (const NodeRates& r : in_model) out.sizes_.push_back(r.size);

    Bound length{0, 0, 0}; // of the leg down to a joint, at the middle moment
    bool rigid = true;     // down to that
    for (int n = model.nodes[index_of(foot.leg.front())].parent; n >= 0;
         n = model.nodes[index_of(n)].parent)
        rigid = rigid && local[index_of(n)].rigid;
    for (std::size_t i = 0; i + 1 < foot.leg.size(); ++i) {
        const int joint = foot.leg[i], next = foot.leg[i + 1];
        Bone bone;
        bone.joint = out.origins_[index_of(joint)];
        rigid = rigid && local[index_of(joint)].rigid;
        bone.rates = rigid ? node_rates(model, local, joint) : in_model;
        if (rigid) bone.scale = glm::length(glm::dvec3(stance.to_model[index_of(joint)][0]));
        bone.own = bone.rates[index_of(joint)];
        const NodeRates& end = bone.rates[index_of(next)];
        const double r = glm::distance(bone.joint, out.origins_[index_of(next)]),
                     first = bone.scale * (bone.own.shift + end.shift),
                     second = bone.scale * (bone.own.swing + end.swing),
                     least = r - first * out.half_s_;
        bone.before = {length.most + length.first * out.half_s_, length.first, length.second};
        if (first > 0 || second > 0) {
            if (!(least > 0)) return {};
            const double turn = first / least;
            bone.direction = {1, turn, second / least + 2 / std::sqrt(3.0) * turn * turn};
            length.first += first;
            length.second += second + first * turn;
        }
        length.most += r;
        out.bones_.push_back(std::move(bone));
    }
    out.length_ = length;
    out.least_length_ = length.most - length.first * out.half_s_;
    if (length.most == 0 && length.first == 0) out.bones_.clear();
    if (!out.bones_.empty() && !(out.least_length_ > 0)) return {};

    Bound sole;
    std::map<int, std::vector<WeightRates>> weights; // of the targets, by node
    for (const ModelVertex& v : foot.sole) {
        const Node& node = model.nodes[index_of(v.node)];
        const Mesh& mesh = *model.meshes[index_of(node.mesh)];
        if (!weights.contains(v.node))
            weights[v.node] = weight_rates(model, clip, v.node, from_s, to_s);
        const auto add = [&](int mover, const glm::dmat4& before, double weight) {
            const auto length_of = [&](const glm::vec3& p, double w) {
                return glm::length(glm::dvec3(before * glm::dvec4(glm::dvec3(p), w)));
            };
            Bound point{length_of(mesh.positions[v.vertex], 1), 0, 0};
            for (std::size_t t = 0; t < mesh.morph_targets.size(); ++t) {
                if (mesh.morph_targets[t].positions.empty()) continue;
                const double by = length_of(mesh.morph_targets[t].positions[v.vertex], 0);
                const WeightRates& w = weights[v.node][t];
                point.most += w.most * by;
                point.first += w.first * by;
                point.second += w.second * by;
            }
            const Bound f = out.share(mover, point);
            sole.first += weight * f.first / static_cast<double>(foot.sole.size());
            sole.second += weight * f.second / static_cast<double>(foot.sole.size());
        };
        if (node.skin < 0 || mesh.influences.empty()) {
            add(v.node, glm::dmat4(1), 1);
            continue;
        }
        const Skin& skin = model.skins[index_of(node.skin)];
        const Mesh::Influences& by = mesh.influences[v.vertex];
        for (int k = 0; k < 4; ++k) {
            const auto j = by.joints[index_of(k)];
            if (by.weights[k] > 0) add(skin.joints[j], skin.mesh_to_joint[j], by.weights[k]);
        }
    }
    const double share = share_of_sole(model, foot, stance), change = sole.first * out.half_s_;
    if (share > least_share_of_sole) {
        const double w = 1 / (share - change);
        if (!(share - change > least_share_of_sole)) return {};
        out.more_ = {w, sole.first * w * w,
                     (sole.second + 2 * sole.first * sole.first * w) * w * w};
    } else if (share + change > least_share_of_sole) {
        return {};
    }
    return out;
}

} // namespace trivar
