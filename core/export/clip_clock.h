// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/animation/track.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace trivar {

// The time of a clip, as it would go on without an end, and where that is in the clip.
struct ClipClock {
    double begin = 0, length = 0;
    Repeat repeat = Repeat::loop;
    double folded(double t) const
    {
        const double x = t - begin;
        if (!(length > 0)) return begin;
        if (repeat == Repeat::once) return begin + std::clamp(x, 0.0, length);
        if (repeat == Repeat::loop) return begin + x - std::floor(x / length) * length;
        const double y = x - std::floor(x / (2 * length)) * 2 * length;
        return begin + (y > length ? 2 * length - y : y);
    }
    // Whether laps are told apart there; much further on a step of the time is more than one.
    bool counts(double t) const
    {
        constexpr double furthest_lap = 1e9;
        return repeat == Repeat::once || !(length > 0) ||
               std::abs(t - begin) < furthest_lap * length;
    }
    // The moments between two at which the clip goes on otherwise, ascending, with the two; nothing
    // where they are very many.
    std::optional<std::vector<double>> cuts(double from, double to,
                                            const std::vector<double>& breaks) const
    {
        std::vector<double> out{from, to};
        const auto add = [&](double t) {
            if (t > from && t < to) out.push_back(t);
        };
        const double lap = repeat == Repeat::back_and_forth ? 2 * length : length;
        const bool once = repeat == Repeat::once || !(length > 0);
        const double first = once ? 0 : std::floor((from - begin) / lap),
                     last = once ? 0 : std::floor((to - begin) / lap);
        constexpr double most_laps = 64;
        if (!(last - first < most_laps)) return {};
        for (double k = first; k <= last; ++k)
            for (const double b : breaks) {
                add(b + k * lap);
                if (repeat == Repeat::back_and_forth) add(2 * (begin + length) - b + k * lap);
            }
        std::ranges::sort(out);
        return out;
    }
};

} // namespace trivar
