// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/narrowing.h"

#include "core/base/smooth_step.h"

#include <algorithm>
#include <cmath>

namespace trivar {

double Narrowing::at(double x) const
{
    const double scaled = std::clamp(x, 0.0, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(scaled), steps - 1);
    const double t = scaled - static_cast<double>(i);
    return (1 - t) * share_[i] + t * share_[i + 1];
}

double Narrowing::least() const
{
    return *std::ranges::min_element(share_);
}

void Narrowing::narrow(double x, double most, double radius, bool round)
{
    const double near = radius + 2.0 / steps;
    const auto step_at = [](double place) { // a little beyond what is near
        return static_cast<std::size_t>(std::clamp(place, 0.0, 1.0) * steps);
    };
    const std::size_t last = round ? steps : std::min(step_at(x + near) + 1, steps);
    for (std::size_t i = round ? 0 : step_at(x - near); i <= last; ++i) {
        const double here = static_cast<double>(i) / steps;
        double way = std::abs(here - x);
        if (round) way = std::min(way, 1 - way);
        const double away = std::max(0.0, way - 1.0 / steps) / radius;
        if (away >= 1) continue;
        const double rise = smooth_step(away);
        share_[i] = std::min(share_[i], most + (1 - most) * rise);
    }
}

void Narrowing::lower_where_narrowed(const Narrowing& other, double factor)
{
    for (std::size_t i = 0; i <= steps; ++i)
        share_[i] *= 1 - (1 - factor) * std::min(1.0, 2 * (1 - other.share_[i]));
}

double Narrowing::widest(const IncisionProfile& profile, double from, double to) const
{
    double before = 0, after = 0;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps, value = value_at(profile, x);
        before = std::max(before, value);
        after = std::max(after, value * at(from + (to - from) * x));
    }
    return before > 0 ? after / before : 0;
}

} // namespace trivar
