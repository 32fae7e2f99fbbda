// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline/curve_scale.h"

#include "core/commands/words/number_words.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// A ValueReach is the range of the values told to it.
struct ValueReach {
    double lo = 1e300, hi = -1e300;
    void add(double value)
    {
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
    glm::dvec2 values() const
    {
        if (lo > hi) return {0, 1};
        const double least = std::max(1e-6, 1e-3 * std::max(std::abs(lo), std::abs(hi)));
        if (hi - lo < least) { // a value that stays stands in the middle
            const double half = std::max(std::abs(lo) / 4, 0.5);
            return {lo - half, hi + half};
        }
        return {lo, hi};
    }
};

} // namespace

float CurveScale::y(double value) const
{
    return bottom + static_cast<float>((value - values.x) / (values.y - values.x)) * (top - bottom);
}

double CurveScale::share_at(float y_px) const
{
    return static_cast<double>((y_px - bottom) / std::min(-1.0f, top - bottom));
}

double CurveScale::value_at(float y_px) const
{
    return values.x + share_at(y_px) * (values.y - values.x);
}

glm::dvec2 values_of_curves(const Document& document, const std::vector<TrackName>& tracks)
{
    ValueReach values;
    for (const TrackName& name : tracks) {
        const Track* track = track_of(document, name);
        if (!track) continue;
        const double factor = words_of_number(name.parameter).factor;
        for (std::size_t i = 0; i < track->keys.size(); ++i) {
            values.add(track->keys[i].value * factor);
            if (i + 1 == track->keys.size()) continue;
            for (const TweenCurve& curve : curves_between(*track, i)) {
                values.add(curve.p1.y * factor);
                values.add(curve.p2.y * factor);
            }
        }
    }
    return values.values();
}

glm::dvec2 values_of_keys(const Document& document, const ChosenKeys& keys,
                          const CurveScales& scales)
{
    ValueReach values;
    for (const KeyName& name : keys) {
        const Key* key = key_of(document, name);
        if (!key) continue;
        const double shown = key->value * words_of_number(name.track.parameter).factor;
        const auto own = scales.own.find(name.track);
        values.add(own == scales.own.end()
                       ? shown
                       : (shown - own->second.x) / (own->second.y - own->second.x));
    }
    return values.values();
}

CurveScale CurveScales::of(const TrackName& track) const
{
    CurveScale out = all;
    if (const auto reach = own.find(track); reach != own.end())
        out.values = reach->second.x + all.values * (reach->second.y - reach->second.x);
    return out;
}

bool units_differ(const std::vector<TrackName>& tracks)
{
    return std::ranges::any_of(tracks, [&](const TrackName& track) {
        return words_of_number(track.parameter).unit !=
               words_of_number(tracks.front().parameter).unit;
    });
}

glm::dvec2 zoomed_values(glm::dvec2 shown, double value, double notches)
{
    constexpr double least = 1e-9, most = 1e12;
    const double width = shown.y - shown.x;
    const double wanted = std::clamp(width * std::pow(0.8, notches), least, most);
    const double share = (value - shown.x) / width;
    return {value - share * wanted, value + (1 - share) * wanted};
}

std::vector<glm::vec2> curve_path(const Track& track, const CurveScale& scale, double factor,
                                  bool inside)
{
    constexpr int pieces = 24; // of a cubic
    const std::vector<Key>& keys = track.keys;
    std::vector<glm::vec2> path;
    const auto add = [&](double frame, double value) {
        path.push_back(scale.at(frame, value * factor));
    };
    if (!inside) {
        const double last = keys.back().frame, end = scale.frames.last;
        add(last, keys.back().value);
        if (track.repeat == Repeat::once || keys.size() < 2) {
            if (end > last) add(end, keys.back().value);
            return path;
        }
        const double step = std::max(0.05, (end - scale.frames.first) /
                                               std::max(1.0f, scale.frames.hi - scale.frames.lo));
        for (double f = last + step; f <= end; f += step) add(f, value_at(track, f));
        return path;
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
        add(keys[i].frame, keys[i].value);
        if (i + 1 == keys.size()) break;
        if (keys[i].tween == Tween::step) add(keys[i + 1].frame, keys[i].value);
        if (keys[i].tween == Tween::step || keys[i].tween == Tween::linear) continue;
        for (const TweenCurve& c : curves_between(track, i))
            for (int k = 1; k <= pieces; ++k) {
                const double t = static_cast<double>(k) / pieces, s = 1 - t;
                const glm::dvec2 p = s * s * s * c.p0 + 3 * s * s * t * c.p1 +
                                     3 * s * t * t * c.p2 + t * t * t * c.p3;
                add(p.x, p.y);
            }
    }
    return path;
}

ValueTicks value_ticks(const CurveScale& scale, float least_px)
{
    const double per_px = (scale.values.y - scale.values.x) /
                          static_cast<double>(std::max(1.0f, scale.bottom - scale.top));
    const double least = per_px * static_cast<double>(least_px);
    double unit = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1, 2, 5, 10})
        if (unit * factor >= least) {
            unit *= factor;
            break;
        }
    return {std::ceil(scale.values.x / unit) * unit, unit};
}

} // namespace trivar
