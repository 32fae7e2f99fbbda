// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace trivar {

// The transfer function of IEC 61966-2-1.
inline float linear_from_srgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}
inline float srgb_from_linear(float value)
{
    return value <= 0.0031308f ? value * 12.92f : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}
inline glm::vec3 linear_from_srgb(const glm::vec3& color)
{
    return {linear_from_srgb(color.x), linear_from_srgb(color.y), linear_from_srgb(color.z)};
}
inline glm::vec3 srgb_from_linear(const glm::vec3& color)
{
    return {srgb_from_linear(color.x), srgb_from_linear(color.y), srgb_from_linear(color.z)};
}

} // namespace trivar
