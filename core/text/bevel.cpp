// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/letter_front.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

// Ratio of the edges of rings to the longest edge; Triangulation::refine needs it.
constexpr double short_edge = 0.7;
constexpr int most_rings = 64;

} // namespace

double bevel_of(const Extrusion& extrusion)
{
    return std::min(extrusion.bevel, 0.45 * extrusion.depth);
}

std::vector<BevelRing> bevel_rings(const Region& region, const Extrusion& extrusion)
{
    constexpr double least_step = 8; // units between rings, far above rounding
    constexpr double quarter = std::numbers::pi / 2;
    const double longest = short_edge * extrusion.max_edge, bevel = bevel_of(extrusion);
    const bool round = extrusion.bevel_steps > 1;
    std::vector<BevelRing> rings{
        {.region = with_short_edges(region, longest * em_units), .slope = round ? 0 : quarter / 2}};
    if (bevel <= 0) return rings;
    const double length = bevel * (round ? quarter : std::numbers::sqrt2);
    const int steps = std::min(
        std::max(extrusion.bevel_steps, static_cast<int>(std::ceil(length / longest))), most_rings);
    double last = 0;
    for (int i = 1; i <= steps; ++i) {
        const double part = double(i) / steps, angle = part * quarter;
        const double in = bevel * em_units * (round ? 1 - std::cos(angle) : part);
        if (in - last < least_step) continue;
        Region inner = inset(region, in);
        if (inner.empty()) break;
        rings.push_back({with_short_edges(inner, longest * em_units), in,
                         bevel * (round ? std::sin(angle) : part), round ? angle : quarter / 2});
        last = in;
    }
    return rings;
}

std::vector<EdgeNormals> edge_normals(const Loop& loop)
{
    const double smooth = std::cos(40 * std::numbers::pi / 180);
    const std::size_t n = loop.size();
    std::vector<glm::dvec2> across(n); // by edge: its normal, as long as the edge
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 along = glm::dvec2(loop[(i + 1) % n]) - glm::dvec2(loop[i]);
        across[i] = {along.y, -along.x};
    }
    std::vector<EdgeNormals> normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 a = across[(i + n - 1) % n], b = across[i];
        normals[i] = {glm::normalize(a), glm::normalize(b)};
        if (glm::dot(normals[i].before, normals[i].behind) > smooth)
            normals[i].before = normals[i].behind = glm::normalize(a + b);
    }
    return normals;
}

} // namespace trivar
