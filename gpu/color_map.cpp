// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/color_map.h"

#include <cmath>

namespace trivar::gpu {
namespace {

// Converts lightness, chroma and hue of OKLab to linear Rec. 709, clipped to the gamut of a screen.
glm::vec3 from_oklch(float lightness, float chroma, float hue_deg)
{
    const float h = glm::radians(hue_deg), a = chroma * std::cos(h), b = chroma * std::sin(h);
    const glm::vec3 t(lightness + 0.3963377774f * a + 0.2158037573f * b,
                      lightness - 0.1055613458f * a - 0.0638541728f * b,
                      lightness - 0.0894841775f * a - 1.2914855480f * b);
    const glm::vec3 lms = t * t * t;
    return glm::clamp(
        glm::vec3(glm::dot(lms, glm::vec3(4.0767416621f, -3.3077115913f, 0.2309699292f)),
                  glm::dot(lms, glm::vec3(-1.2684380046f, 2.6097574011f, -0.3413193965f)),
                  glm::dot(lms, glm::vec3(-0.0041960863f, -0.7034186147f, 1.7076147010f))),
        0.0f, 1.0f);
}

} // namespace

glm::vec3 sequential_color(float t)
{
    t = glm::clamp(t, 0.0f, 1.0f);
    const float chroma = 0.085f + 0.07f * t - 0.03f * std::sin(3.14159265f * t);
    return from_oklch(glm::mix(0.30f, 0.93f, t), chroma, glm::mix(292.0f, 98.0f, t));
}

glm::vec3 diverging_color(float t)
{
    const float away = std::min(std::abs(t), 1.0f);
    return from_oklch(glm::mix(0.94f, 0.44f, away), 0.135f * std::pow(away, 0.75f),
                      t < 0 ? 252.0f : 48.0f);
}

glm::vec3 folded_color(bool stripe)
{
    return stripe ? glm::vec3(0.90f, 0.35f, 0.70f) : glm::vec3(0.60f, 0, 0.33f);
}

std::array<glm::vec4, map_steps + 1> map_colors(const ValueColors& colors)
{
    std::array<glm::vec4, map_steps + 1> out;
    for (int i = 0; i <= map_steps; ++i) {
        const float t = static_cast<float>(i) / map_steps;
        out[static_cast<std::size_t>(i)] =
            glm::vec4(colors.diverging ? diverging_color(2 * t - 1) : sequential_color(t), 1);
    }
    return out;
}

} // namespace trivar::gpu
