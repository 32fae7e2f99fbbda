// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/pose_rates.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

double length_of(const std::vector<double>& v)
{
    double square = 0;
    for (const double x : v) square += x * x;
    return std::sqrt(square);
}

// Bounds the derivatives of a channel's value; for a rotation those of its angle.
struct ChannelRates : Rates {
    bool known = true;
};

std::vector<double> part_of_key(const Channel& c, std::size_t key, std::size_t which)
{
    const std::size_t n = c.components;
    const bool cubic = c.interpolation == Channel::Interpolation::cubic;
    const std::size_t at = (cubic ? 3 * key + which : key) * n; // 0 in-tangent, 1 value, 2 out
    return {c.values.begin() + static_cast<std::ptrdiff_t>(at),
            c.values.begin() + static_cast<std::ptrdiff_t>(at + n)};
}

struct Jet {
    std::vector<double> value, first, second;
};

// Evaluates a cubic between two keys, not normalised, and its derivatives.
Jet cubic_at(const Channel& c, std::size_t key, double time_s)
{
    const std::vector<double> p0 = part_of_key(c, key, 1), m0 = part_of_key(c, key, 2),
                              p1 = part_of_key(c, key + 1, 1), m1 = part_of_key(c, key + 1, 0);
    const double span = double{c.times_s[key + 1]} - double{c.times_s[key]},
                 t = (time_s - double{c.times_s[key]}) / span, t2 = t * t, t3 = t2 * t;
    Jet out;
    for (std::size_t i = 0; i < p0.size(); ++i) {
        const double d = p1[i] - p0[i], a = span * m0[i], b = span * m1[i];
        out.value.push_back(p0[i] + (3 * t2 - 2 * t3) * d + (t3 - 2 * t2 + t) * a + (t3 - t2) * b);
        out.first.push_back(
            ((6 * t - 6 * t2) * d + (3 * t2 - 4 * t + 1) * a + (3 * t2 - 2 * t) * b) / span);
        out.second.push_back(((6 - 12 * t) * d + (6 * t - 4) * a + (6 * t - 2) * b) /
                             (span * span));
    }
    return out;
}

// Bounds the rates of a cubic: its second derivative is linear, so that it is largest at an end;
// this and the middle bound the others.
Rates cubic_rates(const Channel& c, std::size_t key, double from_s, double to_s,
                  const auto& size_of)
{
    const Jet middle = cubic_at(c, key, (from_s + to_s) / 2);
    const double half = (to_s - from_s) / 2;
    Rates out;
    out.second =
        std::max(size_of(cubic_at(c, key, from_s).second), size_of(cubic_at(c, key, to_s).second));
    out.first = size_of(middle.first) + out.second * half;
    out.most = size_of(middle.value) + out.first * half;
    return out;
}

// Finds the key before a time from which the channel moves to the next; none if it holds its value.
std::optional<std::size_t> key_before(const Channel& c, double time_s)
{
    const auto after = std::upper_bound(c.times_s.begin(), c.times_s.end(), time_s);
    if (after == c.times_s.begin() || after == c.times_s.end() ||
        c.interpolation == Channel::Interpolation::step)
        return {};
    return static_cast<std::size_t>(after - c.times_s.begin()) - 1;
}

ChannelRates rates_of(const Channel& c, double from_s, double to_s)
{
    const bool turns = c.of == Channel::Of::rotation;
    const auto size_of = [&](const std::vector<double>& v) {
        if (c.of != Channel::Of::scale) return length_of(v);
        return std::max({std::abs(v.at(0)), std::abs(v.at(1)), std::abs(v.at(2))});
    };
    const double middle_s = (from_s + to_s) / 2;
    const auto key = key_before(c, middle_s);
    if (!key) return {{size_of(value_at(c, middle_s)), 0, 0}};
    if (c.interpolation == Channel::Interpolation::cubic) {
        const Rates rates = cubic_rates(c, *key, from_s, to_s, size_of);
        if (!turns) return {rates};
        const double least =
            length_of(cubic_at(c, *key, middle_s).value) - rates.first * (to_s - from_s) / 2;
        if (!(least > least_rotation)) return {{}, false};
        const Rates half_angle = direction_of(rates, least);
        return {{1, 2 * half_angle.first, 2 * half_angle.second}};
    }
    const double begin_s = c.times_s[*key], span = double{c.times_s[*key + 1]} - begin_s;
    const std::vector<double> a = value_at(c, begin_s), b = value_at(c, c.times_s[*key + 1]);
    std::vector<double> way, other; // a quaternion and its opposite are one rotation
    for (std::size_t i = 0; i < a.size(); ++i) {
        way.push_back(b[i] - a[i]);
        other.push_back(b[i] + a[i]);
    }
    double gone = size_of(way);
    if (turns) gone = 4 * std::asin(std::min(1.0, std::min(gone, size_of(other)) / 2));
    return {{std::max(size_of(a), size_of(b)), gone / span, 0}};
}

double norm_of(const glm::dmat3& m) // at least its operator norm
{
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

// Bounds the operator norm: tight for a rotation times a number, by all entries for others.
double tight_norm_of(const glm::dmat3& m)
{
    const glm::dmat3 square = glm::transpose(m) * m;
    const double scale = square[0][0];
    const glm::dmat3 rest = square - glm::dmat3(scale);
    return std::min(norm_of(m), std::sqrt(scale + norm_of(rest)));
}

// Says whether a matrix is a rotation or reflection with uniform scale, up to single precision.
bool keeps_angles(const glm::dmat3& m)
{
    constexpr double rounding = 1e-6;
    const glm::dmat3 square = glm::transpose(m) * m;
    const double scale = square[0][0];
    return scale > 0 && norm_of(square - glm::dmat3(scale)) <= rounding * scale;
}

} // namespace

void Rates::add(const Rates& other, double times)
{
    most += times * other.most;
    first += times * other.first;
    second += times * other.second;
}

Rates direction_of(const Rates& vector, double least)
{
    const double turn = vector.first / least;
    return {1, turn, vector.second / least + 2 / std::sqrt(3.0) * turn * turn};
}

Rates NodeRates::of(const Rates& x) const
{
    return {size * x.most, turn * x.most + shift + size * x.first,
            bend * x.most + swing + 2 * turn * x.first + size * x.second};
}

std::optional<std::vector<LocalRates>> local_rates(const Model& model, const Clip& clip,
                                                   double from_s, double to_s)
{
    struct Moving {
        ChannelRates translation, rotation, scale;
        bool moved = false, even = false; // even: uniform scale
    };
    const auto alike = [](double x, double y, double z) { return x == y && y == z; };
    std::vector<Moving> moving(model.nodes.size());
    for (std::size_t n = 0; n < moving.size(); ++n) {
        const NodeTransform& rest = model.nodes[n].rest;
        moving[n].translation.most = glm::length(rest.translation);
        moving[n].scale.most =
            std::max({std::abs(rest.scale.x), std::abs(rest.scale.y), std::abs(rest.scale.z)});
        moving[n].even = alike(rest.scale.x, rest.scale.y, rest.scale.z);
    }
    for (const Channel& channel : clip.channels) {
        if (channel.of == Channel::Of::morph_weights) continue;
        const ChannelRates rates = rates_of(channel, from_s, to_s);
        if (!rates.known) return {};
        Moving& at = moving[static_cast<std::size_t>(channel.node)];
        at.moved = true;
        if (channel.of == Channel::Of::translation) at.translation = rates;
        if (channel.of == Channel::Of::rotation) at.rotation = rates;
        if (channel.of == Channel::Of::scale) {
            at.scale = rates;
            const std::vector<double> is = value_at(channel, (from_s + to_s) / 2);
            at.even = rates.first == 0 && rates.second == 0 && alike(is.at(0), is.at(1), is.at(2));
        }
    }
    std::vector<LocalRates> out(model.nodes.size());
    for (std::size_t n = 0; n < out.size(); ++n) {
        const Node& node = model.nodes[n];
        const Moving& m = moving[n];
        const glm::dmat4& fixed = m.moved ? node.outer : node.to_parent;
        const double outer = tight_norm_of(glm::dmat3(fixed));
        LocalRates& own = out[n];
        own.rigid = keeps_angles(glm::dmat3(fixed)) && (!m.moved || m.even);
        own.size = outer;
        own.origin = glm::length(glm::dvec3(fixed[3]));
        if (!m.moved) continue;
        const double turn = m.rotation.first;
        own.size = outer * m.scale.most;
        own.turn = outer * (turn * m.scale.most + m.scale.first);
        own.bend = outer * ((turn * turn + m.rotation.second) * m.scale.most +
                            2 * turn * m.scale.first + m.scale.second);
        own.shift = outer * m.translation.first;
        own.swing = outer * m.translation.second;
        own.origin += outer * m.translation.most;
    }
    return out;
}

std::vector<NodeRates> node_rates(const Model& model, const std::vector<LocalRates>& local,
                                  int within)
{
    std::vector<NodeRates> out(local.begin(), local.end());
    if (within >= 0) out[static_cast<std::size_t>(within)] = {};
    for (auto n = static_cast<std::size_t>(within + 1); n < out.size(); ++n) {
        if (model.nodes[n].parent < 0) continue;
        const NodeRates& p = out[static_cast<std::size_t>(model.nodes[n].parent)];
        const LocalRates& own = local[n];
        out[n].size = p.size * own.size;
        out[n].turn = p.turn * own.size + p.size * own.turn;
        out[n].bend = p.bend * own.size + 2 * p.turn * own.turn + p.size * own.bend;
        out[n].shift = p.shift + p.turn * own.origin + p.size * own.shift;
        out[n].swing = p.swing + p.bend * own.origin + 2 * p.turn * own.shift + p.size * own.swing;
    }
    return out;
}

std::vector<Rates> weight_rates(const Model& model, const Clip& clip, int index, double from_s,
                                double to_s)
{
    const Node& node = model.nodes[static_cast<std::size_t>(index)];
    std::vector<Rates> out;
    if (node.mesh < 0) return out;
    out.resize(model.meshes[static_cast<std::size_t>(node.mesh)]->morph_targets.size());
    for (std::size_t t = 0; t < std::min(out.size(), node.morph_weights.size()); ++t)
        out[t].most = std::abs(double{node.morph_weights[t]});
    for (const Channel& c : clip.channels) {
        if (c.node != index || c.of != Channel::Of::morph_weights) continue;
        const double middle_s = (from_s + to_s) / 2;
        const auto key = key_before(c, middle_s);
        const std::vector<double> held = value_at(c, middle_s);
        for (std::size_t t = 0; t < std::min(out.size(), c.components); ++t) {
            const auto one = [&](const std::vector<double>& all) { return std::abs(all[t]); };
            if (!key) {
                out[t] = {one(held), 0, 0};
            } else if (c.interpolation == Channel::Interpolation::cubic) {
                out[t] = cubic_rates(c, *key, from_s, to_s, one);
            } else {
                const double p = part_of_key(c, *key, 1)[t], q = part_of_key(c, *key + 1, 1)[t],
                             span = double{c.times_s[*key + 1]} - double{c.times_s[*key]};
                out[t] = {std::max(one(value_at(c, from_s)), one(value_at(c, to_s))),
                          std::abs(q - p) / span, 0};
            }
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
