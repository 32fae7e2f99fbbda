// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

constexpr float height = .40f; // of the middle
constexpr int ribs = 11;

// Returns 0 in the furrows to 1 on the ribs, which are not all as wide.
float rib(float angle)
{
    const float uneven = angle + .10f * std::sin(2 * angle + 1) + .05f * std::sin(3 * angle);
    const float wave = std::sin(ribs * .5f * (uneven + pi / ribs));
    return std::sqrt(wave * wave + .012f);
}

// A profile from the lower dimple to the upper one, as a lathe takes it.
std::vector<vec2> profile(vec2 radii, int rows, vec2 dimples)
{
    std::vector<vec2> out;
    for (int i = 0; i <= rows; ++i) {
        const float t = pi * (float(i) / float(rows) - .5f);
        const float r = radii.x * std::pow(std::max(0.f, std::cos(t)), .82f);
        const float dimple = std::exp(-(r * r) / (.17f * .17f));
        out.push_back({i == 0 || i == rows ? 0 : r,
                       height + radii.y * std::sin(t) + (t < 0 ? dimples.x : -dimples.y) * dimple});
    }
    return out;
}

// Furrows run in, deepest where the skin is steep.
vec3 ribbed(vec3 p, float depth)
{
    const float r = glm::length(vec2(p.x, p.z)), angle = std::atan2(p.x, p.z);
    const float in = depth * (1 - rib(angle)) * smooth_step(.02f, .2f, r);
    const float lower = .35f * in * (p.y - height) / .4f;
    return {p.x * (1 - in), p.y - lower, p.z * (1 - in)};
}

vec3 rind(vec3 p)
{
    const float angle = std::atan2(p.x, p.z), up = (p.y - height) / .36f;
    const vec3 orange = srgb(0xd9700f), pale = srgb(0xe8922c), furrow = srgb(0x8e3f08),
               green = srgb(0x5d6b22);
    const float streaks =
        noise({angle * 26, p.y * 3, 2}) * .5f + noise({angle * 61, p.y * 5, 7}) * .3f;
    vec3 c = glm::mix(orange, pale, saturate(.45f + .6f * streaks));
    c = glm::mix(furrow, c, smooth_step(.05f, .55f, rib(angle)));
    const float speck = noise(p * 90.f);
    c = glm::mix(c, srgb(0xf0bd6a), .3f * smooth_step(.6f, .8f, speck));
    const float r = glm::length(vec2(p.x, p.z));
    const float to_stem =
        up > 0 ? smooth_step(.16f, .05f, r + .03f * noise({angle * 9, r * 20, 0})) : 0;
    c = glm::mix(c, green, .7f * to_stem);
    return c * (1 + .04f * noise(p * 23.f));
}

// Returns the colour of a place inside, lit by a candle on the ground.
vec3 lit_inside(vec3 p)
{
    const float away = glm::distance(p, vec3(0, .22f, 0));
    const float light = 1 / (1 + 9 * away * away) * (1 + .06f * noise(p * 40.f));
    return glm::mix(srgb(0x7a1f02), srgb(0xffd257), saturate(1.65f * light - .25f));
}

Mesh stem()
{
    Mesh m = tube(curve({{0, .675f, 0, .07f},
                         {0, .73f, 0, .046f},
                         {.01f, .78f, .005f, .041f},
                         {.045f, .86f, .015f, .040f},
                         {.095f, .905f, .03f, .047f}},
                        8),
                  30);
    return m.warp([](vec3 p) {
        const float t = saturate((p.y - .6f) / .3f);
        const vec3 middle{.09f * t * t, p.y, .03f * t * t};
        const vec3 d = p - middle;
        const float angle = std::atan2(d.z, d.x) + 1.2f * t;
        const float ridge = 1 + .16f * std::cos(6 * angle);
        return vec3(middle.x + ridge * d.x, p.y, middle.z + ridge * d.z);
    });
}

} // namespace

// A hollow one in two skins, whose furrows are in both, with a wall of a tenth of its radius.
Model pumpkin()
{
    Model m;
    const int outside = m.material("rind", vec3(1), .42f),
              inside = m.material("inside", vec3(1), .8f),
              wood = m.material("stem", srgb(0x6b6a35), .8f);
    Mesh outer = lathe(profile({.5f, .37f}, 84, {.06f, .11f}), 176);
    outer.warp([](vec3 p) { return ribbed(p, .12f); }).turn(180, {0, 1, 0});
    Mesh inner = lathe(profile({.43f, .305f}, 60, {.06f, .11f}), 120);
    inner.warp([](vec3 p) { return ribbed(p, .09f); }).turn(180, {0, 1, 0});
    m.materials[std::size_t(outside)].texture = bake(outer, {1536, 768}, rind);
    m.materials[std::size_t(inside)].texture = bake(inner, {256, 128}, lit_inside);
    m.materials[std::size_t(inside)].glow = 9;
    for (std::size_t f = 0; f < inner.faces.size(); ++f) { // it is seen from within
        Face& face = inner.faces[f];
        const std::size_t last = corner_count(face) - 1;
        std::swap(face[0], face[last]);
        std::swap(inner.uvs[f][0], inner.uvs[f][last]);
        if (last == 3) {
            std::swap(face[1], face[2]);
            std::swap(inner.uvs[f][1], inner.uvs[f][2]);
        }
    }
    float foot = outer.points[0].y;
    for (const vec3& p : outer.points) foot = std::min(foot, p.y);
    auto& parts = m.root().parts;
    parts.push_back(outer.mat(outside));
    parts.push_back(inner.mat(inside));
    parts.push_back(stem().mat(wood));
    for (Mesh& part : parts) part.move({0, -foot, 0});
    return m;
}

} // namespace make
