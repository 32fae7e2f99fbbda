// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/look.h"

#include <cmath>
#include <cstdint>

namespace trivar::gpu {
namespace {

constexpr float degrees = 0.017453293f;

// An sRGB colour as 0xRRGGBB, made linear.
glm::vec3 srgb(std::uint32_t hex)
{
    glm::vec3 c(static_cast<float>(hex >> 16), static_cast<float>(hex >> 8 & 255),
                static_cast<float>(hex & 255));
    for (int i = 0; i < 3; ++i) {
        const float x = c[i] / 255;
        c[i] = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    }
    return c;
}

Look studio()
{
    Look look;
    look.boxes[0] = {0, 0, {0.15f, 0.15f}, glm::vec3(1, 0.965f, 0.91f) * 37.0f, 0.02f};
    // Large, cool and low on the other side; a tall strip behind for the edges.
    look.boxes[1] = {
        104 * degrees, 22 * degrees, {0.34f, 0.62f}, glm::vec3(0.86f, 0.93f, 1) * 0.55f, 0.06f};
    look.boxes[2] = {
        200 * degrees, 30 * degrees, {0.16f, 0.75f}, glm::vec3(1, 0.98f, 0.95f) * 3.8f, 0.03f};
    look.zenith = glm::vec3(0.50f, 0.54f, 0.60f) * 0.52f;
    look.horizon = glm::vec3(0.22f, 0.215f, 0.21f) * 0.52f;
    look.floor = glm::vec3(0.66f, 0.63f, 0.60f) * 0.46f;
    look.backdrop = {.top = srgb(0x98A1AB), .middle = srgb(0xE0E3E5), .bottom = srgb(0xBFC1C3)};
    return look;
}

Look dark()
{
    Look look = studio();
    look.boxes[0].radiance *= 0.86f;
    look.boxes[1].radiance *= 1.1f;
    look.boxes[2].radiance *= 1.7f;
    look.zenith *= 0.66f;
    look.horizon *= 0.6f;
    look.floor *= 0.45f;
    look.backdrop = {.top = srgb(0x16181B), .middle = srgb(0x34383D), .bottom = srgb(0x1F2225)};
    return look;
}

// An even ground, of the white of paper or black, under the light of another look.
Look on_ground(Look look, glm::vec3 ground)
{
    look.backdrop = {.top = ground, .middle = ground, .bottom = ground, .corners = 0};
    return look;
}

} // namespace

Look look_named(std::string_view name)
{
    if (name == "dark") return dark();
    if (name == "paper") return on_ground(studio(), glm::vec3(1));
    if (name == "black") return on_ground(dark(), glm::vec3(0));
    Look look = studio();
    if (name == "clay") look.clay = glm::vec3(0.56f, 0.385f, 0.30f);
    return look;
}

bool is_dark(std::string_view name)
{
    return name == "dark" || name == "black";
}

} // namespace trivar::gpu
