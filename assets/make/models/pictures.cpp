// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/pictures.h"

#include "assets/make/field.h"

#include <filesystem>
#include <fstream>

namespace make {

namespace {

constexpr int side_px = 256;

GreyPicture picture_of(const std::function<float(vec2)>& value) // u to the right, v up
{
    GreyPicture out{glm::ivec2(side_px), {}};
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x)
            out.values.push_back(
                value({(float(x) + .5f) / side_px, 1 - (float(y) + .5f) / side_px}));
    return out;
}

float hash(int x, int y, int what)
{
    unsigned h = unsigned(x) * 374761393u + unsigned(y) * 668265263u + unsigned(what) * 2246822519u;
    h = (h ^ (h >> 13)) * 1274126177u;
    return float((h ^ (h >> 16)) & 0xffff) / 65535.f;
}

// Smooth noise that repeats in both directions, of so many cells on a side; -1..1.
float round_noise(vec2 uv, int cells, int what)
{
    const vec2 p = float(cells) * uv, low = glm::floor(p);
    const vec2 f = p - low, t = f * f * (3.f - 2.f * f);
    const auto at = [&](int dx, int dy) {
        const auto wrapped = [&](float k, int d) { return ((int(k) + d) % cells + cells) % cells; };
        return 2 * hash(wrapped(low.x, dx), wrapped(low.y, dy), what) - 1;
    };
    return mix(mix(at(0, 0), at(1, 0), t.x), mix(at(0, 1), at(1, 1), t.x), t.y);
}

// Blotches with ragged rims, as moss has them.
float patches(vec2 uv)
{
    const float n = round_noise(uv, 5, 3) + .6f * round_noise(uv, 11, 4) +
                    .35f * round_noise(uv, 23, 5) + .2f * round_noise(uv, 47, 6);
    return smooth_step(-.25f, .35f, n);
}

// Pebbles side by side: distances to the nearest and the second nearest of scattered points.
float pebbles(vec2 uv)
{
    constexpr int cells = 6;
    const vec2 p = float(cells) * uv;
    float first = 9, second = 9, tall = 1;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int x = int(std::floor(p.x)) + dx, y = int(std::floor(p.y)) + dy;
            const int cx = (x + cells) % cells, cy = (y + cells) % cells;
            const vec2 at = vec2(float(x), float(y)) + .5f +
                            .8f * (vec2(hash(cx, cy, 1), hash(cx, cy, 2)) - .5f);
            const float away = glm::length(p - at);
            if (away < first) {
                second = first;
                first = away;
                tall = .7f + .3f * hash(cx, cy, 3);
            } else
                second = std::min(second, away);
        }
    const float inside = saturate((second - first) / .55f); // 0 in the joints
    return tall * std::sqrt(1 - (1 - inside) * (1 - inside)) * (1 + .05f * round_noise(uv, 40, 7));
}

// A wall that has lost its middle: black where bricks are missing.
float breach(vec2 uv)
{
    const vec2 q = (uv - vec2(.62f, .63f)) / vec2(.2f, .27f);
    const float rag =
        .3f * noise(vec3(9 * uv.x, 9 * uv.y, 2)) + .2f * noise(vec3(23 * uv.x, 23 * uv.y, 7));
    const float hole = smooth_step(.8f, 1.05f, glm::length(q) + rag);
    const float top = smooth_step(
        .98f, .93f, uv.y + .16f * noise(vec3(5 * uv.x, 1, 4)) + .22f * uv.x * uv.x - .06f);
    return std::min(hole, top);
}

} // namespace

std::vector<NamedPicture> pictures()
{
    return {{"patches", picture_of(patches)},
            {"pebbles", picture_of(pebbles)},
            {"breach", picture_of(breach)}};
}

void write_pictures(const std::string& folder)
{
    std::filesystem::create_directories(folder);
    for (const NamedPicture& each : pictures())
        std::ofstream(folder + "/" + each.name + ".png", std::ios::binary) << png(each.picture);
}

} // namespace make
