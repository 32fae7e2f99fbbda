// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/checker.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int squares = 16, square_px = 64;

// A bright colour, as sRGB, for a place on the circle of hues.
glm::vec3 hue(float turn)
{
    const auto part = [&](float shift) {
        return 0.5f + 0.5f * std::cos(6.2831853f * (turn - shift));
    };
    return {part(0), part(1.0f / 3), part(2.0f / 3)};
}

// In a square, x to the right and y up from its middle, -0.5 to 0.5: an arrow up with a flag to its
// right, which is to its left where the texture is mirrored.
bool is_arrow(glm::vec2 p)
{
    const bool stem = std::abs(p.x) < 0.03f && std::abs(p.y) < 0.25f;
    const bool head = p.y > 0.08f && p.y < 0.3f && p.x >= 0 && p.x < (0.3f - p.y) * 0.8f;
    return stem || head;
}

Ref<Image> checker_image()
{
    Image out;
    out.name = "checker";
    constexpr int size = squares * square_px;
    out.size_px = {size, size};
    out.rgba.reserve(static_cast<std::size_t>(4 * size * size));
    for (int y = size - 1; y >= 0; --y) // rows from the top
        for (int x = 0; x < size; ++x) {
            const int i = x / square_px, j = y / square_px;
            const glm::vec2 p((static_cast<float>(x % square_px) + 0.5f) / square_px - 0.5f,
                              (static_cast<float>(y % square_px) + 0.5f) / square_px - 0.5f);
            const bool dark = (i + j) % 2 == 0;
            glm::vec3 color = glm::mix(glm::vec3(dark ? 0.36f : 0.88f),
                                       hue(static_cast<float>(i) / squares) *
                                           (0.45f + 0.55f * static_cast<float>(j) / squares),
                                       dark ? 0.35f : 0.3f);
            if (is_arrow(p)) color = dark ? color + 0.28f : color * 0.6f;
            for (int c = 0; c < 3; ++c)
                out.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0f, 1.0f))));
            out.rgba.push_back(255);
        }
    return make_ref(std::move(out));
}

} // namespace

Material checker_material()
{
    Material out;
    out.name = "checker";
    out.base_color = glm::vec4(1);
    out.roughness = 0.8f;
    out.base_color_texture.image = checker_image();
    return out;
}

} // namespace trivar
