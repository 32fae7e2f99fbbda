// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/track.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double swing = 0.16; // each half period of what settles, as a share of the one before
constexpr int half_periods = 3;

double slope_between(const Key& a, const Key& b)
{
    return (b.value - a.value) / (b.frame - a.frame);
}

double smooth_slope(const std::vector<Key>& keys, std::size_t k)
{
    if (k == 0 || k + 1 == keys.size()) return 0;
    if (keys[k - 1].tween == Tween::settle || keys[k].tween == Tween::settle) return 0;
    const double left = slope_between(keys[k - 1], keys[k]),
                 right = slope_between(keys[k], keys[k + 1]);
    if (left * right <= 0) return 0;
    const double h = keys[k].frame - keys[k - 1].frame, next = keys[k + 1].frame - keys[k].frame;
    const double share = (1 + next / (h + next)) / 3;
    return left * right / (share * right + (1 - share) * left);
}

glm::dvec2 handle(const std::vector<Key>& keys, std::size_t k, glm::dvec2 own, double way)
{
    if (own.x == 0) return {way / 3, smooth_slope(keys, k) * way / 3};
    if (own.x * way < 0) return {0, own.y}; // the handle points away
    return std::abs(own.x) > std::abs(way) ? own * (way / own.x) : own;
}

double bezier(double a, double b, double c, double d, double t)
{
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

double on(const TweenCurve& curve, double frame)
{
    double lo = 0, hi = 1; // the frame rises monotonically along the curve
    constexpr int halvings = 52;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (lo + hi) / 2;
        (bezier(curve.p0.x, curve.p1.x, curve.p2.x, curve.p3.x, middle) <= frame ? lo : hi) =
            middle;
    }
    return bezier(curve.p0.y, curve.p1.y, curve.p2.y, curve.p3.y, lo);
}

double within(const Track& track, double frame)
{
    const double first = track.keys.front().frame, length = track.keys.back().frame - first;
    if (track.repeat == Repeat::once || frame <= first + length || length == 0) return frame;
    return first + folded(track.repeat, frame - first, length);
}

} // namespace

double folded(Repeat repeat, double time, double length)
{
    if (repeat == Repeat::once) return std::clamp(time, 0.0, length);
    const double round = repeat == Repeat::loop ? length : 2 * length;
    const double rest = std::max(0.0, time - std::floor(time / round) * round);
    if (repeat == Repeat::loop) return std::min(rest, length);
    return rest > length ? std::max(0.0, round - rest) : rest;
}

TweenCurve curve_between(const Track& track, std::size_t key)
{
    const Key &a = track.keys[key], &b = track.keys[key + 1];
    const double way = b.frame - a.frame;
    const glm::dvec2 p0(a.frame, a.value), p3(b.frame, b.value);
    return {p0, p0 + handle(track.keys, key, a.after, way),
            p3 + handle(track.keys, key + 1, b.before, -way), p3};
}

namespace {

// Returns the curve from one point to another that is level at both.
TweenCurve level_curve(glm::dvec2 from, glm::dvec2 to)
{
    const double way = to.x - from.x;
    return {from, from + glm::dvec2(way / 3, 0), to - glm::dvec2(way / 3, 0), to};
}

} // namespace

std::vector<TweenCurve> curves_between(const Track& track, std::size_t key)
{
    const Key &a = track.keys[key], &b = track.keys[key + 1];
    const glm::dvec2 from(a.frame, a.value), to(b.frame, b.value);
    const auto line = [](glm::dvec2 p, glm::dvec2 q) {
        return TweenCurve{p, glm::mix(p, q, 1.0 / 3), glm::mix(p, q, 2.0 / 3), q};
    };
    if (a.tween == Tween::cubic) return {curve_between(track, key)};
    if (a.tween == Tween::linear) return {line(from, to)};
    if (a.tween == Tween::step) {
        const glm::dvec2 corner(to.x, from.y);
        return {line(from, corner), line(corner, to)};
    }
    std::vector<TweenCurve> out;
    glm::dvec2 at = from;
    double past = -1; // the way that is left, as a share of the whole
    for (int k = 1; k <= half_periods; ++k) {
        past *= -swing;
        const glm::dvec2 next(from.x + (to.x - from.x) * k / half_periods,
                              to.y + past * (to.y - from.y));
        out.push_back(level_curve(at, k == half_periods ? to : next));
        at = next;
    }
    return out;
}

double value_at(const Track& track, double frame)
{
    const std::vector<Key>& keys = track.keys;
    frame = within(track, frame);
    const auto next = std::ranges::upper_bound(keys, frame, {}, &Key::frame);
    if (next == keys.begin()) return keys.front().value;
    const Key& key = *(next - 1);
    if (next == keys.end() || key.frame == frame || key.tween == Tween::step) return key.value;
    if (key.tween == Tween::linear)
        return std::lerp(key.value, next->value, (frame - key.frame) / (next->frame - key.frame));
    const auto number = static_cast<std::size_t>(next - keys.begin()) - 1;
    if (key.tween == Tween::cubic) return on(curve_between(track, number), frame);
    for (const TweenCurve& curve : curves_between(track, number))
        if (frame < curve.p3.x) return on(curve, frame);
    return next->value;
}

Track with_key(Track track, double frame, double value)
{
    auto at = std::ranges::lower_bound(track.keys, frame, {}, &Key::frame);
    if (at != track.keys.end() && at->frame == frame) {
        at->value = value;
        return track;
    }
    Key key{frame, value};
    if (at != track.keys.begin()) key.tween = (at - 1)->tween;
    track.keys.insert(at, key);
    return track;
}

} // namespace trivar
