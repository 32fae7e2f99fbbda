// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/kept_clip.h"

#include "core/certificate/keys.h"
#include "core/document/parameters.h"
#include "core/steps/moving/posing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

using Values = std::vector<double>;
constexpr float for_ever = std::numeric_limits<float>::infinity();

// A Span is the time from one moment of the film to another, in which one formula gives the values
// of the channel.
struct Span {
    double from_s, to_s;
    Values a, b, slope_a, slope_b; // at both ends; slopes by seconds of the film, of cubics
};

bool same(const Values& a, const Values& b)
{
    constexpr double near_enough = 1e-6; // of single precision
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(std::abs(a[i] - b[i]) <= near_enough * (1 + std::abs(a[i])))) return false;
    return true;
}

double distance(const Values& a, const Values& b)
{
    double out = 0;
    for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, std::abs(a[i] - b[i]));
    return out;
}

// A CubicPiece is the cubic between two keys of a channel; rotations are not normalised.
class CubicPiece {
public:
    CubicPiece(const Channel& channel, std::size_t key) : channel_(channel), key_(key) {}
    double from() const { return double{channel_.times_s[key_]}; }
    double to() const { return double{channel_.times_s[key_ + 1]}; }
    bool unit() const
    {
        constexpr double near_enough = 1e-6;
        return std::abs(length(value(key_, 1)) - 1) < near_enough &&
               std::abs(length(value(key_ + 1, 1)) - 1) < near_enough;
    }
    // Returns value and derivative at a time of the clip, or those of the rotation that they give.
    std::pair<Values, Values> at(double time_s, bool as_rotation) const
    {
        const double span = to() - from(), t = (time_s - from()) / span, t2 = t * t, t3 = t2 * t;
        const Values p = value(key_, 1), m = value(key_, 2), q = value(key_ + 1, 1),
                     n = value(key_ + 1, 0);
        Values out(p.size()), slope(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            out[i] = (2 * t3 - 3 * t2 + 1) * p[i] + span * (t3 - 2 * t2 + t) * m[i] +
                     (3 * t2 - 2 * t3) * q[i] + span * (t3 - t2) * n[i];
            slope[i] = (6 * t2 - 6 * t) / span * (p[i] - q[i]) + (3 * t2 - 4 * t + 1) * m[i] +
                       (3 * t2 - 2 * t) * n[i];
        }
        if (const double size = length(out); as_rotation && size > 0) {
            double along = 0; // the rotation is out / size
            for (std::size_t i = 0; i < p.size(); ++i) along += out[i] * slope[i] / size;
            for (std::size_t i = 0; i < p.size(); ++i) {
                out[i] /= size;
                slope[i] = (slope[i] - along * out[i]) / size;
            }
        }
        return {out, slope};
    }

private:
    static double length(const Values& v)
    {
        double sum = 0;
        for (const double x : v) sum += x * x;
        return std::sqrt(sum);
    }
    Values value(std::size_t key, std::size_t which) const
    {
        const std::size_t n = channel_.components;
        const auto first =
            channel_.values.begin() + static_cast<std::ptrdiff_t>((3 * key + which) * n);
        return {first, first + static_cast<std::ptrdiff_t>(n)};
    }
    const Channel& channel_;
    std::size_t key_;
};

class Spans {
public:
    Spans(const Channel& channel, const PlayedTime& time) : channel_(channel), time_(time)
    {
        for (const PlayedTime::Piece& piece : time.pieces) add(piece);
    }
    std::vector<Span> all;

private:
    // Adds the spans of a piece, which is cut at the keys of the channel.
    void add(const PlayedTime::Piece& piece)
    {
        const double lo = std::min(piece.clip_from_s, piece.clip_to_s),
                     hi = std::max(piece.clip_from_s, piece.clip_to_s);
        Values cuts{lo, hi};
        if (!time_.by_moments)
            for (const float key : channel_.times_s)
                if (double{key} > lo && double{key} < hi) cuts.push_back(double{key});
        std::ranges::sort(cuts);
        if (piece.clip_to_s < piece.clip_from_s) std::ranges::reverse(cuts);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add(piece, cuts[i], cuts[i + 1]);
    }

    void add(const PlayedTime::Piece& piece, double from, double to)
    {
        const double whole = piece.clip_to_s - piece.clip_from_s,
                     rate = whole == 0 ? 0 : whole / (piece.to_s - piece.from_s);
        const auto film_time = [&](double clip_s) {
            return rate == 0 ? piece.from_s : piece.from_s + (clip_s - piece.clip_from_s) / rate;
        };
        const double end = to == piece.clip_to_s ? piece.to_s : film_time(to);
        const Values none(channel_.components, 0);
        const double middle = (from + to) / 2;
        if (channel_.interpolation == Channel::Interpolation::step) {
            const Values v = value_at(channel_, time_.by_moments ? from : middle);
            all.push_back({film_time(from), end, v, v, none, none});
            return;
        }
        const auto after = std::ranges::upper_bound(channel_.times_s, middle, {},
                                                    [](float t) { return double{t}; });
        const bool held = after == channel_.times_s.begin() || after == channel_.times_s.end();
        if (channel_.interpolation == Channel::Interpolation::linear || held || time_.by_moments ||
            rate == 0) {
            all.push_back({film_time(from), end, value_at(channel_, from), value_at(channel_, to),
                           none, none});
            return;
        }
        const CubicPiece cubic(channel_,
                               static_cast<std::size_t>(after - channel_.times_s.begin()) - 1);
        const bool cut = std::min(from, to) != cubic.from() || std::max(from, to) != cubic.to();
        const bool by_parts = channel_.of == Channel::Of::rotation && (cut || !cubic.unit());
        constexpr int enough = 32; // the error falls with the fourth power
        const int parts = by_parts ? enough : 1;
        for (int k = 0; k < parts; ++k) {
            const double s = from + (to - from) * k / parts,
                         t = k + 1 == parts ? to : from + (to - from) * (k + 1) / parts;
            auto [a, slope_a] = cubic.at(s, by_parts);
            auto [b, slope_b] = cubic.at(t, by_parts);
            for (double& x : slope_a) x *= rate;
            for (double& x : slope_b) x *= rate;
            all.push_back(
                {film_time(s), k + 1 == parts ? end : film_time(t), a, b, slope_a, slope_b});
        }
    }

    const Channel& channel_;
    const PlayedTime& time_;
};

// KeysInOrder adds keys to a channel, each later than the one before.
class KeysInOrder {
public:
    explicit KeysInOrder(Channel& to) : to_(to) {}
    void add(float at_s, const Values& in, const Values& value, const Values& out)
    {
        const bool cubic = to_.interpolation == Channel::Interpolation::cubic;
        const std::size_t n = to_.components;
        if (!to_.times_s.empty() && at_s <= to_.times_s.back()) // equal in single precision
            to_.values.resize(to_.values.size() - (cubic ? 2 * n : n));
        else {
            to_.times_s.push_back(at_s);
            if (cubic) put(in);
        }
        put(value);
        if (cubic) put(out);
    }

private:
    void put(const Values& values)
    {
        for (const double value : values) to_.values.push_back(static_cast<float>(value));
    }
    Channel& to_;
};

} // namespace

PlayedTime played_time(const Document& document, Id id, const Clip& clip,
                       const std::vector<double>& moments)
{
    const Object& played = object(document, id);
    const Playing& playing = played.playing;
    const double per_second = document.time.frames_per_second, first = moments.front(),
                 end = (moments.back() - first) / per_second,
                 start = (playing.start_frame - first) / per_second,
                 length = clip.end_s - clip.begin_s;
    const auto clip_at = [clip, per_second](double frame, const Playing& p) {
        return clip_time_s(clip, p, (frame - p.start_frame) / per_second);
    };
    // Returns the laps since the clip began, in either direction.
    const auto laps_at = [&](double film_s) {
        return (playing.offset + playing.speed * std::max(0.0, film_s - start)) / length;
    };
    PlayedTime out;
    if (end == 0 || !(length > 0)) {
        const double there = clip_at(first, playing);
        out.pieces = {{0, end, there, there}};
        return out;
    }
    const double from = std::min(laps_at(0), laps_at(end)), to = std::max(laps_at(0), laps_at(end));
    const auto many = static_cast<double>(moments.size());
    constexpr double furthest_lap = 1e9; // beyond, laps and where they begin are not told apart
    const bool counted =
        to - from <= many && std::max(std::abs(from), std::abs(to)) <= furthest_lap;
    out.by_moments = (playing.repeat != Repeat::once && !counted) ||
                     std::ranges::any_of(played.tracks, [](const Track& track) {
                         return track.parameter.starts_with("playing.");
                     });
    if (out.by_moments) {
        std::vector<double> there;
        for (const double moment : moments)
            there.push_back(clip_at(moment, object(document_at(document, moment), id).playing));
        for (std::size_t i = 0; i + 1 < moments.size(); ++i)
            out.pieces.push_back({(moments[i] - first) / per_second,
                                  (moments[i + 1] - first) / per_second, there[i], there[i + 1]});
        return out;
    }
    out.seen = [=](double film_s) -> std::optional<PlayedTime::SeenTime> {
        constexpr double looked_at = 80, // tenths and sixteenths
            near_enough = 1e-4, of_a_frame = 0x1p-20;
        const double frame = film_s * per_second,
                     near = std::round((first + frame) * looked_at) / looked_at;
        if (std::abs(near - first - frame) > near_enough + of_a_frame * frame) return {};
        return PlayedTime::SeenTime{(near - first) / per_second, clip_at(near, playing)};
    };
    std::vector<double> cuts{0, end};
    const auto cut = [&](double at) {
        if (at > 0 && at < end) cuts.push_back(at);
    };
    cut(start);
    if (playing.speed != 0) {
        const bool once = playing.repeat == Repeat::once;
        for (double lap = once ? 0 : std::ceil(from); lap <= (once ? 1 : to); ++lap)
            if (const double at = start + (lap * length - playing.offset) / playing.speed;
                at > start)
                cut(at);
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double middle = laps_at((cuts[i] + cuts[i + 1]) / 2);
        const double lap = playing.repeat == Repeat::once ? 0 : std::floor(middle);
        const bool back = playing.repeat == Repeat::back_and_forth && std::fmod(lap, 2) != 0;
        const auto in_clip = [&](double film_s) {
            double share = laps_at(film_s) - lap;
            constexpr double rounding = 1e-9;
            if (share < rounding) share = 0;
            if (share > 1 - rounding) share = 1;
            return back ? clip.end_s - share * length
                        : (share == 1 ? clip.end_s : clip.begin_s + share * length);
        };
        out.pieces.push_back({cuts[i], cuts[i + 1], in_clip(cuts[i]), in_clip(cuts[i + 1])});
    }
    return out;
}

Channel played(const Channel& channel, const PlayedTime& time)
{
    Channel out = channel;
    out.times_s.clear();
    out.values.clear();
    const bool steps = channel.interpolation == Channel::Interpolation::step;
    if (time.by_moments && !steps) out.interpolation = Channel::Interpolation::linear;
    const std::vector<Span> spans = Spans(channel, time).all;
    KeysInOrder keys(out);
    const Values none(channel.components, 0);
    keys.add(0, none, spans.front().a, spans.front().slope_a);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        const Span &last = spans[i - 1], &span = spans[i];
        if (same(last.b, span.a)) {
            if (!steps)
                keys.add(static_cast<float>(span.from_s), last.slope_b, span.a, span.slope_a);
            continue;
        }
        float there = not_after(span.from_s);
        if (const auto seen = time.seen ? time.seen(span.from_s) : std::nullopt) {
            const std::vector<double> shown = value_at(channel, seen->clip_s);
            const bool still = distance(shown, last.b) < distance(shown, span.a);
            there = still
                        ? std::nextafter(not_before(std::max(span.from_s, seen->film_s)), for_ever)
                        : not_after(std::min(span.from_s, seen->film_s));
        }
        if (!steps) keys.add(std::nextafter(there, -for_ever), last.slope_b, last.b, none);
        keys.add(there, none, span.a, span.slope_a);
    }
    const Span& last = spans.back();
    if (last.to_s > 0)
        keys.add(static_cast<float>(last.to_s), last.slope_b,
                 steps ? value_at(channel, time.pieces.back().clip_to_s) : last.b, none);
    return out;
}

} // namespace trivar
