// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/lattice_point.h"

#include <cmath>

namespace trivar {
namespace {

using On = LatticePoint::On;

} // namespace

LatticePoint lattice_point(const SlitSkin& skin, std::uint32_t triangle, glm::ivec2 weights)
{
    const glm::ivec3 w(lattice_steps - weights.x - weights.y, weights.x, weights.y);
    for (std::uint32_t i = 0; i < 3; ++i)
        if (w[static_cast<int>(i)] == lattice_steps)
            return {On::point, skin.triangle(triangle)[static_cast<int>(i)], 0, 0};
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (w[static_cast<int>((i + 2) % 3)] != 0) continue;
        const std::uint32_t side = 3 * triangle + i;
        const int at_end = w[static_cast<int>((i + 1) % 3)];
        const bool upward = skin.from(side) < skin.to(side);
        return {On::edge, skin.edge(side), upward ? at_end : lattice_steps - at_end, 0};
    }
    return {On::triangle, triangle, w.y, w.z};
}

LatticePoint nearest_lattice_point(const SlitSkin& skin, const SkinPlace& place)
{
    const int b = static_cast<int>(std::lround(place.weights.y * lattice_steps));
    const int c = static_cast<int>(std::lround(place.weights.z * lattice_steps));
    const int over = std::max(0, b + c - lattice_steps);
    return b > c ? lattice_point(skin, place.triangle, {b - over, c})
                 : lattice_point(skin, place.triangle, {b, c - over});
}

std::optional<glm::ivec2> weights_in(const SlitSkin& skin, const LatticePoint& p,
                                     std::uint32_t triangle)
{
    glm::ivec3 w(0);
    switch (p.on) {
    case On::point: {
        const glm::uvec3& corners = skin.triangle(triangle);
        for (int i = 0; i < 3; ++i)
            if (corners[i] == p.index) {
                w[i] = lattice_steps;
                return glm::ivec2(w.y, w.z);
            }
        return std::nullopt;
    }
    case On::edge:
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t side = 3 * triangle + i;
            if (side != p.index && skin.across(side) != p.index) continue;
            const bool upward = skin.from(side) < skin.to(side);
            const int at_end = upward ? p.b : lattice_steps - p.b;
            w[static_cast<int>(i)] = lattice_steps - at_end;
            w[static_cast<int>((i + 1) % 3)] = at_end;
            return glm::ivec2(w.y, w.z);
        }
        return std::nullopt;
    case On::triangle:
        if (p.index != triangle) return std::nullopt;
        return glm::ivec2(p.b, p.c);
    }
    return std::nullopt;
}

std::vector<std::uint32_t> triangles_round(const SlitSkin& skin, const LatticePoint& p)
{
    std::vector<std::uint32_t> out;
    switch (p.on) {
    case On::point:
        skin.around(p.index, [&](std::uint32_t side) { out.push_back(side / 3); });
        break;
    case On::edge:
        out.push_back(p.index / 3);
        if (skin.across(p.index) != SlitSkin::none) out.push_back(skin.across(p.index) / 3);
        break;
    case On::triangle: out.push_back(p.index); break;
    }
    return out;
}

std::uint64_t key_of(const LatticePoint& p)
{
    static_assert(lattice_steps < 1 << 14);
    return std::uint64_t{static_cast<std::uint8_t>(p.on)} << 62 | std::uint64_t{p.index} << 28 |
           static_cast<std::uint64_t>(p.b) << 14 | static_cast<std::uint64_t>(p.c);
}

Blend blend_of(const SlitSkin& skin, const LatticePoint& p)
{
    constexpr double n = lattice_steps;
    if (p.on == On::point) return {glm::uvec3(p.index), {1, 0, 0}};
    if (p.on == On::edge) {
        std::uint32_t lo = skin.from(p.index), hi = skin.to(p.index);
        if (lo > hi) std::swap(lo, hi);
        return {{lo, hi, hi}, {1 - p.b / n, p.b / n, 0}};
    }
    return {skin.triangle(p.index), {(lattice_steps - p.b - p.c) / n, p.b / n, p.c / n}};
}

glm::dvec3 position(const SlitSkin& skin, const LatticePoint& p)
{
    return blend_of(skin, p)([&](std::uint32_t point) { return skin.position(point); });
}

} // namespace trivar
