// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/walk.h"

#include "assets/make/field.h"

#include <algorithm>
#include <cmath>

namespace make {

Step step_at(float phase, float travel, float duty, float lift)
{ // phase in 0..1; stance first
    phase -= std::floor(phase);
    if (phase < duty) return {travel * (.5f - phase / duty), 0};
    float t = (phase - duty) / (1 - duty),
          v = -travel * (1 - duty) / duty; // swing leaves and lands with the ground's speed
    float h = 2 * t * t * t - 3 * t * t + 1, a = t * t * t - 2 * t * t + t, c = t * t * t - t * t;
    return {h * -.5f * travel + (1 - h) * .5f * travel + (a + c) * v,
            lift * std::pow(std::sin(pi * t), 1.3f)};
}

Bend reach(float x, float y, float l1, float l2, float side)
{ // two links from the origin to (x, y)
    float D = std::min(std::sqrt(x * x + y * y), (l1 + l2) * .9995f),
          a = std::acos(std::clamp((l1 * l1 + D * D - l2 * l2) / (2 * l1 * D), -1.f, 1.f)),
          k = std::acos(std::clamp((l1 * l1 + l2 * l2 - D * D) / (2 * l1 * l2), -1.f, 1.f));
    return {std::atan2(y, x) + side * a, -side * (pi - k)};
}

Influence along_x(const std::vector<float>& x, vec3 p)
{
    std::size_t k = 0;
    while (k + 1 < x.size() && x[k + 1] > p.x) ++k;
    const bool between = k + 1 < x.size() && p.x < x[k];
    const float t = between ? (x[k] - p.x) / (x[k] - x[k + 1]) : 0;
    const float share = t * t * (3 - 2 * t);
    return {{std::uint8_t(k), std::uint8_t(share > 0 ? k + 1 : 0)}, {1 - share, share, 0, 0}};
}

} // namespace make
