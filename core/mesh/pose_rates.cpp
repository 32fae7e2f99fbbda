// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/pose_rates.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

double length_of(const std::vector<double>& v)
{
    return glm::length(glm::dvec3(v[0], v[1], v[2]));
}

// Of the three numbers of a channel, or of the angle of a rotation.
struct ChannelRates {
    double most = 0, first = 0, second = 0;
    bool known = true;
};

std::vector<double> part_of_key(const Channel& c, std::size_t key, std::size_t which)
{
    const std::size_t n = c.components;
    const bool cubic = c.between == Channel::Between::cubic;
    const std::size_t at = (cubic ? 3 * key + which : key) * n; // 0 tangent in, 1 value, 2 out
    return {c.values.begin() + static_cast<std::ptrdiff_t>(at),
            c.values.begin() + static_cast<std::ptrdiff_t>(at + n)};
}

// A cubic's second derivative is linear, so its ends bound it; the first is bounded by the chord's
// slope and by how much it can change.
ChannelRates cubic_rates(const Channel& c, std::size_t key, double span)
{
    const std::vector<double> p0 = part_of_key(c, key, 1), m0 = part_of_key(c, key, 2),
                              p1 = part_of_key(c, key + 1, 1), m1 = part_of_key(c, key + 1, 0);
    glm::dvec3 begin(0), end(0), chord(0);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double d = (p1[n] - p0[n]) / span;
        chord[i] = d;
        begin[i] = (6 * d - 4 * m0[n] - 2 * m1[n]) / span;
        end[i] = (-6 * d + 2 * m0[n] + 4 * m1[n]) / span;
    }
    ChannelRates out;
    out.second = std::max(glm::length(begin), glm::length(end));
    out.first = glm::length(chord) + out.second * span;
    out.most = std::max(length_of(p0), length_of(p1)) + out.first * span;
    return out;
}

ChannelRates rates_of(const Channel& c, double from_s, double to_s)
{
    ChannelRates out;
    const bool turns = c.of == Channel::Of::rotation;
    const std::vector<double> begin = value_at(c, from_s), end = value_at(c, to_s);
    out.most = turns ? 1 : std::max(length_of(begin), length_of(end));
    const auto after = std::upper_bound(c.times_s.begin(), c.times_s.end(), (from_s + to_s) / 2);
    if (after == c.times_s.begin() || after == c.times_s.end() ||
        c.between == Channel::Between::step)
        return out;
    const auto key = static_cast<std::size_t>(after - c.times_s.begin()) - 1;
    const double span = double{c.times_s[key + 1]} - double{c.times_s[key]};
    if (c.between == Channel::Between::cubic) {
        out.known = !turns;
        return turns ? out : cubic_rates(c, key, span);
    }
    const std::vector<double> a = part_of_key(c, key, 0), b = part_of_key(c, key + 1, 0);
    if (turns) {
        const glm::dquat p = glm::normalize(glm::dquat(a[3], a[0], a[1], a[2])),
                         q = glm::normalize(glm::dquat(b[3], b[0], b[1], b[2]));
        out.first = 2 * std::acos(std::min(1.0, std::abs(glm::dot(p, q)))) / span;
        out.known = std::isfinite(out.first);
    } else {
        out.first =
            glm::distance(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(b[0], b[1], b[2])) / span;
    }
    return out;
}

bool stays(const Channel& c)
{
    const std::size_t keys = c.times_s.size();
    for (std::size_t key = 1; key < keys; ++key)
        if (part_of_key(c, key, 1) != part_of_key(c, 0, 1)) return false;
    return c.between != Channel::Between::cubic;
}

double norm_of(const glm::dmat3& m) // no less than its operator norm
{
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

// A rotation times a number has that norm; others are bounded by all of their entries.
double tight_norm_of(const glm::dmat3& m)
{
    const glm::dmat3 square = glm::transpose(m) * m;
    const double scale = square[0][0];
    const glm::dmat3 rest = square - glm::dmat3(scale);
    return std::min(norm_of(m), std::sqrt(scale + norm_of(rest)));
}

} // namespace

std::optional<std::vector<NodeRates>> node_rates(const Model& model, const Clip& clip,
                                                 double from_s, double to_s)
{
    struct Local {
        ChannelRates translation, rotation, scale;
        bool moved = false;
    };
    std::vector<Local> local(model.nodes.size());
    for (std::size_t n = 0; n < local.size(); ++n) {
        const Placed& rest = model.nodes[n].rest;
        local[n].translation.most = glm::length(rest.translation);
        local[n].scale.most =
            std::max({std::abs(rest.scale.x), std::abs(rest.scale.y), std::abs(rest.scale.z)});
    }
    for (const Channel& channel : clip.channels) {
        if (channel.of == Channel::Of::morph_weights) continue;
        const ChannelRates rates = rates_of(channel, from_s, to_s);
        if (!rates.known) return {};
        Local& at = local[static_cast<std::size_t>(channel.node)];
        at.moved = true;
        if (channel.of == Channel::Of::translation) at.translation = rates;
        if (channel.of == Channel::Of::rotation) at.rotation = rates;
        if (channel.of == Channel::Of::scale) at.scale = rates;
    }
    std::vector<NodeRates> out(model.nodes.size());
    for (std::size_t n = 0; n < out.size(); ++n) {
        const Node& node = model.nodes[n];
        const Local& l = local[n];
        const glm::dmat4& fixed = l.moved ? node.outer : node.to_parent;
        const double outer = tight_norm_of(glm::dmat3(fixed));
        NodeRates own{outer, 0, 0, 0, 0};
        double origin = glm::length(glm::dvec3(fixed[3])); // at most, in the parent
        if (l.moved) {
            const double turn = l.rotation.first;
            own.size = outer * l.scale.most;
            own.turn = outer * (turn * l.scale.most + l.scale.first);
            own.bend =
                outer * (turn * turn * l.scale.most + 2 * turn * l.scale.first + l.scale.second);
            own.shift = outer * l.translation.first;
            own.swing = outer * l.translation.second;
            origin += outer * l.translation.most;
        }
        if (node.parent < 0) {
            out[n] = own;
            continue;
        }
        const NodeRates& p = out[static_cast<std::size_t>(node.parent)];
        out[n].size = p.size * own.size;
        out[n].turn = p.turn * own.size + p.size * own.turn;
        out[n].bend = p.bend * own.size + 2 * p.turn * own.turn + p.size * own.bend;
        out[n].shift = p.shift + p.turn * origin + p.size * own.shift;
        out[n].swing = p.swing + p.bend * origin + 2 * p.turn * own.shift + p.size * own.swing;
    }
    return out;
}

std::vector<WeightRates> weight_rates(const Model& model, const Clip& clip, int index,
                                      double from_s, double to_s)
{
    const Node& node = model.nodes[static_cast<std::size_t>(index)];
    std::vector<WeightRates> out;
    if (node.mesh < 0) return out;
    out.resize(model.meshes[static_cast<std::size_t>(node.mesh)]->morph_targets.size());
    for (std::size_t t = 0; t < std::min(out.size(), node.morph_weights.size()); ++t)
        out[t].most = std::abs(double{node.morph_weights[t]});
    for (const Channel& c : clip.channels) {
        if (c.node != index || c.of != Channel::Of::morph_weights) continue;
        const std::vector<double> begin = value_at(c, from_s), end = value_at(c, to_s);
        const auto after =
            std::upper_bound(c.times_s.begin(), c.times_s.end(), (from_s + to_s) / 2);
        const bool held = after == c.times_s.begin() || after == c.times_s.end() ||
                          c.between == Channel::Between::step;
        const auto key = held ? 0 : static_cast<std::size_t>(after - c.times_s.begin()) - 1;
        const double span = held ? 1 : double{c.times_s[key + 1]} - double{c.times_s[key]};
        for (std::size_t t = 0; t < std::min(out.size(), c.components); ++t) {
            WeightRates& rates = out[t];
            rates = {std::max(std::abs(begin[t]), std::abs(end[t])), 0, 0};
            if (held) continue;
            const double p = part_of_key(c, key, 1)[t], q = part_of_key(c, key + 1, 1)[t],
                         chord = (q - p) / span;
            rates.first = std::abs(chord);
            if (c.between != Channel::Between::cubic) continue;
            // As cubic_rates.
            const double m = part_of_key(c, key, 2)[t], n = part_of_key(c, key + 1, 0)[t];
            rates.second = std::max(std::abs(6 * chord - 4 * m - 2 * n),
                                    std::abs(-6 * chord + 2 * m + 4 * n)) /
                           span;
            rates.first += rates.second * span;
            rates.most = std::max(std::abs(p), std::abs(q)) + rates.first * span;
        }
    }
    return out;
}

std::vector<int> legs_of_nodes(const Model& model, const Gait& gait)
{
    std::vector<int> out(model.nodes.size(), -1);
    for (std::size_t f = 0; f < gait.feet.size(); ++f)
        for (const int node : gait.feet[f].leg)
            out[static_cast<std::size_t>(node)] = static_cast<int>(f);
    for (std::size_t n = 0; n < out.size(); ++n)
        if (out[n] < 0 && model.nodes[n].parent >= 0)
            out[n] = out[static_cast<std::size_t>(model.nodes[n].parent)];
    return out;
}

std::optional<std::vector<double>> planting_speeds(const Model& model, const Clip& clip,
                                                   const Gait& gait, double from_s, double to_s)
{
    std::vector<double> out(gait.feet.size(), 0);
    if (!gait.trouble.empty()) return out;
    const std::vector<int> leg = legs_of_nodes(model, gait);
    // Where nothing of a leg but its hip's own place changes otherwise than by turning, each of its
    // points takes the same share of the displacement at all times.
    for (const Channel& c : clip.channels) {
        if (stays(c)) continue;
        if (c.of == Channel::Of::scale) return {};
        const int foot = leg[static_cast<std::size_t>(c.node)];
        if (foot < 0 || c.node == gait.feet[static_cast<std::size_t>(foot)].leg.front()) continue;
        const std::vector<int>& joints = gait.feet[static_cast<std::size_t>(foot)].leg;
        const bool turns = c.of == Channel::Of::rotation;
        if (!turns || std::ranges::find(joints, c.node) == joints.end()) return {};
    }
    for (std::size_t f = 0; f < out.size(); ++f) {
        const Foot& foot = gait.feet[f];
        if (foot.leg.empty()) continue;
        const auto count = static_cast<double>(foot.shift.size());
        const double phase = ((from_s + to_s) / 2 - gait.begin_s) / gait.period_s - foot.begin;
        const auto i = std::min(static_cast<std::size_t>((phase - std::floor(phase)) * count),
                                foot.shift.size() - 1);
        out[f] = glm::distance(foot.shift[i], foot.shift[(i + 1) % foot.shift.size()]) * count /
                 gait.period_s;
    }
    return out;
}

std::vector<double> breaks_of(const Clip& clip, const Gait* gait)
{
    std::vector<double> out{clip.begin_s, clip.end_s};
    for (const Channel& channel : clip.channels)
        for (const float time : channel.times_s) out.push_back(time);
    if (gait && gait->trouble.empty() && gait->period_s > 0)
        for (const Foot& foot : gait->feet)
            for (std::size_t i = 0; i < foot.shift.size(); ++i) {
                const double phase =
                    foot.begin + static_cast<double>(i) / static_cast<double>(foot.shift.size());
                out.push_back(gait->begin_s + gait->period_s * (phase - std::floor(phase)));
            }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    std::erase_if(out, [&](double t) { return t < clip.begin_s || t > clip.end_s; });
    return out;
}

} // namespace trivar
