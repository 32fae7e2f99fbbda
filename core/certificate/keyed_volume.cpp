// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/keyed_volume.h"

#include "core/certificate/volume_bends.h"
#include "core/document/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr double not_known = std::numeric_limits<double>::infinity();

// A Round maps a frame to the frames of one round of the track, and back.
struct Round {
    double number = 0, first = 0, length = 0;
    bool back = false;
    double in_track(double frame) const
    {
        const double rest = frame - number * length;
        return back ? 2 * first + length - rest : rest;
    }
    double in_film(double frame) const
    {
        return (back ? 2 * first + length - frame : frame) + number * length;
    }
};

Round round_at(const Track& track, double frame)
{
    Round out{.first = track.keys.front().frame};
    out.length = track.keys.back().frame - out.first;
    if (track.repeat == Repeat::once || frame <= out.first + out.length || !(out.length > 0))
        return out;
    out.number = std::floor((frame - out.first) / out.length);
    out.back = track.repeat == Repeat::back_and_forth && std::fmod(out.number, 2) != 0;
    return out;
}

// Returns the control points of the curve from one of its frames to another.
std::array<glm::dvec2, 4> piece(const TweenCurve& curve, double from, double to)
{
    const auto at = [&](double a, double b, double c) { // its blossom
        const glm::dvec2 p = glm::mix(curve.p0, curve.p1, a), q = glm::mix(curve.p1, curve.p2, a),
                         r = glm::mix(curve.p2, curve.p3, a);
        return glm::mix(glm::mix(p, q, b), glm::mix(q, r, b), c);
    };
    const auto parameter = [&](double frame) {
        double lo = 0, hi = 1;
        for (int i = 0; i < 52; ++i) { // as value_at() finds it
            const double middle = (lo + hi) / 2;
            (at(middle, middle, middle).x <= frame ? lo : hi) = middle;
        }
        return lo;
    };
    const double s = parameter(from), t = to < curve.p3.x ? parameter(to) : 1;
    return {at(s, s, s), at(s, s, t), at(s, t, t), at(t, t, t)};
}

// Returns the control points of the track between two of its frames, with no key between them.
std::array<glm::dvec2, 4> control_points(const Track& track, double from, double to)
{
    const auto next = std::ranges::upper_bound(track.keys, (from + to) / 2, {}, &Key::frame);
    const auto line = [&](double a, double b) {
        return std::array{glm::dvec2(from, a), glm::dvec2(from, a), glm::dvec2(to, b),
                          glm::dvec2(to, b)};
    };
    if (next == track.keys.begin()) return line(next->value, next->value);
    const Key& key = *(next - 1);
    if (next == track.keys.end() || key.tween == Tween::step) return line(key.value, key.value);
    const double way = next->frame - key.frame;
    if (key.tween == Tween::linear)
        return line(std::lerp(key.value, next->value, (from - key.frame) / way),
                    std::lerp(key.value, next->value, (to - key.frame) / way));
    const std::vector<TweenCurve> curves =
        curves_between(track, static_cast<std::size_t>(next - track.keys.begin()) - 1);
    const auto of = std::ranges::find_if(
        curves, [&](const TweenCurve& curve) { return (from + to) / 2 < curve.p3.x; });
    return piece(of == curves.end() ? curves.back() : *of, from, to);
}

// Bounds the change of the derivatives of a lattice if its control points move by at most `by`.
glm::dvec3 steeper_by(const std::array<Knots, 3>& axes, double by)
{
    glm::dvec3 out(0);
    for (int a = 0; a < 3; ++a) {
        const Knots& axis = axes[static_cast<std::size_t>(a)];
        const std::vector<double>& t = axis.values();
        double least = not_known;
        for (std::size_t i = 0; i + static_cast<std::size_t>(axis.degree()) < t.size(); ++i)
            if (const double width = t[i + static_cast<std::size_t>(axis.degree())] - t[i];
                width > 0)
                least = std::min(least, width);
        out[a] = 2 * by * axis.degree() / least;
    }
    return out;
}

// Says whether the coefficients of det J keep their sign from one volume to the other, so that all
// volumes between are proven good and the guard allows them. On the even way each coefficient is a
// cubic, at most 1/8 of its second derivative below its chord; `turn` bounds that way, `steeper`
// the deviation from it.
bool stays_good(const ShapedVolume& from, const ShapedVolume& to, const glm::dvec3& slopes,
                const glm::dvec3& turn, const glm::dvec3& steeper)
{
    for (const Shaping& step : {from.steps.back(), to.steps.back()})
        if (step.would_fold || !step.notice.empty()) return false;
    const auto product = [](const glm::dvec3& v) { return v.x * v.y * v.z; };
    const double second = 2 * (turn.x * turn.y * slopes.z + turn.y * turn.z * slopes.x +
                               turn.z * turn.x * slopes.y),
                 beside = product(slopes + steeper) - product(slopes);
    constexpr double rounding = 1e-9;
    const double needed = second / 8 + beside + rounding * product(slopes + steeper);
    const CellVerdicts &a = *from.volume->verdicts, &b = *to.volume->verdicts;
    for (std::size_t cell = 0; cell < a.of.size(); ++cell)
        if (a.of[cell] != Verdict::excepted && !(std::min(a.least[cell], b.least[cell]) > needed))
            return false;
    return true;
}

} // namespace

double off_chord(const Track& track, double from_frame, double to_frame, double lo, double hi)
{
    const double v0 = value_at(track, from_frame), v1 = value_at(track, to_frame);
    const auto chord = [&](double frame) {
        return v0 + (v1 - v0) * (frame - from_frame) / (to_frame - from_frame);
    };
    const double first = round_at(track, from_frame).number,
                 last = round_at(track, to_frame).number;
    constexpr double most_rounds = 64, furthest_round = 1e9; // where rounds are told apart
    if (!(last - first <= most_rounds && last < furthest_round)) return not_known;
    std::vector<double> cuts{from_frame, to_frame};
    for (double round = first; round <= last; ++round) {
        Round r{round, track.keys.front().frame};
        r.length = track.keys.back().frame - r.first;
        r.back = track.repeat == Repeat::back_and_forth && std::fmod(round, 2) != 0;
        const auto cut = [&](double frame) {
            if (const double at = r.in_film(frame); at > from_frame && at < to_frame)
                cuts.push_back(at);
        };
        for (std::size_t k = 0; k < track.keys.size(); ++k) {
            cut(track.keys[k].frame);
            if (k + 1 < track.keys.size() && track.keys[k].tween == Tween::settle)
                for (const TweenCurve& curve : curves_between(track, k)) cut(curve.p3.x);
        }
    }
    std::ranges::sort(cuts);
    double most = 0, largest = 0;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        if (!(cuts[c + 1] > cuts[c])) continue;
        const Round round = round_at(track, (cuts[c] + cuts[c + 1]) / 2);
        const double a = round.in_track(cuts[c]), b = round.in_track(cuts[c + 1]);
        const std::array<glm::dvec2, 4> p = control_points(track, std::min(a, b), std::max(a, b));
        std::array<double, 4> off;
        for (std::size_t i = 0; i < 4; ++i) {
            if (!(p[i].y >= lo && p[i].y <= hi)) return not_known;
            off[i] = std::abs(p[i].y - chord(round.in_film(p[i].x)));
            largest = std::max(largest, std::abs(p[i].y));
        }
        // The inner two add at most three quarters of a cubic.
        const double ends = std::max(off[0], off[3]), inner = std::max(off[1], off[2]);
        most = std::max(most, ends + 0.75 * std::max(0.0, inner - ends));
    }
    constexpr double rounding = 1e-12;
    return most + rounding * largest;
}

bool KeyedVolume::is_of_it(const Object& object, const Track& track)
{
    if (!object.stroke || object.travel.speed != 0 || object.travel.followers != 0) return false;
    if (object.shaping.empty() || !object.shaping.back()->shift) return false;
    const std::string by = "shaping." + std::to_string(object.shaping.size() - 1) + ".shift.by.";
    return track.parameter.starts_with(by);
}

std::optional<KeyedVolume> KeyedVolume::of(const Object& object)
{
    KeyedVolume out;
    const std::vector<Parameter> all = parameters(object);
    for (const Track& track : object.tracks) {
        if (!is_of_it(object, track)) continue;
        const auto found = std::ranges::find(all, track.parameter, &Parameter::name);
        if (found != all.end()) out.moving_.push_back({track, found->lo, found->hi});
    }
    if (out.moving_.empty()) return {};
    out.guarded_ = object.shaping.back()->shift->guard;
    return out;
}

std::optional<KeyedVolume::Change> KeyedVolume::change(const EvaluatedObject& from,
                                                       double from_frame, const EvaluatedObject& to,
                                                       double to_frame, const glm::dvec3& slopes)
{
    if (!from.shaped || !to.shaped) return {};
    return changes_({from.shaped, to.shaped, from_frame}, [&] {
        return changed(*from.shaped, from_frame, *to.shaped, to_frame, slopes);
    });
}

std::optional<KeyedVolume::Change> KeyedVolume::changed(const ShapedVolume& from, double from_frame,
                                                        const ShapedVolume& to, double to_frame,
                                                        const glm::dvec3& slopes) const
{
    const Lattice &p = *from.volume->volume, &q = *to.volume->volume;
    if (p.rest != q.rest || p.displacement.axes != q.displacement.axes) return {};
    Lattice difference = q;
    difference.rest = glm::dmat4(0);
    for (std::size_t i = 0; i < difference.displacement.points.size(); ++i)
        difference.displacement.points[i] -= p.displacement.points[i];
    Change out{0, VolumeBends(difference).slopes()};
    glm::dvec3 uneven(0);
    for (const Moving& m : moving_) {
        const int axis = m.track.parameter.back() - 'x';
        uneven[axis] = off_chord(m.track, from_frame, to_frame, m.lo, m.hi);
    }
    out.uneven = glm::length(uneven);
    if (guarded_ &&
        !stays_good(from, to, slopes, out.turn, steeper_by(p.displacement.axes, out.uneven)))
        return {};
    return out;
}

} // namespace trivar
