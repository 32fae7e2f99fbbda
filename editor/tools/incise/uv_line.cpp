// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/uv_line.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

constexpr std::size_t most_places = 20'000;

// Returns how far a coordinate at the corners of a triangle is above that of the line; nothing: the
// mesh has no coordinates.
std::optional<glm::dvec3> above_line(const TileBase& base, std::uint32_t t, int coordinate,
                                     double level)
{
    const Mesh& mesh = base.pieces()[base.piece_of(t)].mesh->mesh();
    if (mesh.uvs.empty() || mesh.uvs.front().empty()) return {};
    const glm::uvec3 v = base.vertices(t);
    glm::dvec3 out(0);
    for (int i = 0; i < 3; ++i)
        out[i] = static_cast<double>(mesh.uvs.front()[v[i]][coordinate]) - level;
    return out;
}

// Walks from a triangle through its side `out`, as long as the line goes on.
void walk_on(const TileBase& base, std::uint32_t t, int out, int coordinate, double level,
             std::vector<SurfacePlace>& places)
{
    const std::uint32_t first = t;
    while (places.size() < most_places) {
        const std::optional<glm::dvec3> f = above_line(base, t, coordinate, level);
        if (!f) return;
        const int a = out, b = (out + 1) % 3;
        const double share = (*f)[a] / ((*f)[a] - (*f)[b]);
        SurfacePlace place{t, glm::dvec3(0)};
        place.weights[a] = 1 - share;
        place.weights[b] = share;
        places.push_back(place);
        const std::uint32_t beyond = base.across(t, out);
        if (beyond == TileBase::none) return;
        const std::uint32_t next = beyond / 3;
        if (next == first || base.piece_of(next) != base.piece_of(t)) return;
        const int in = static_cast<int>(beyond % 3);
        const std::optional<glm::dvec3> g = above_line(base, next, coordinate, level);
        // At a seam the same edge has other coordinates
        const double spread = std::abs((*f)[a] - (*f)[b]);
        if (!g || std::abs((*g)[in] - (*f)[b]) > 1e-4 * spread ||
            std::abs((*g)[(in + 1) % 3] - (*f)[a]) > 1e-4 * spread)
            return;
        // It leaves by that of the two other sides at whose ends it is above and below
        const int apex = (in + 2) % 3;
        const bool up = (*g)[apex] >= 0;
        if (up == ((*g)[in] >= 0) && up == ((*g)[(in + 1) % 3] >= 0)) return;
        out = up == ((*g)[in] >= 0) ? (in + 1) % 3 : apex;
        t = next;
    }
}

} // namespace

UvLine uv_line(const TileBase& base, const SurfacePlace& from, int coordinate)
{
    UvLine line;
    const std::optional<glm::dvec3> zero = above_line(base, from.triangle, coordinate, 0);
    if (!zero) return line;
    const double level = glm::dot(from.weights, *zero);
    const glm::dvec3 f = *zero - level;
    std::vector<int> sides; // by which it leaves the triangle
    for (int e = 0; e < 3; ++e)
        if ((f[e] >= 0) != (f[(e + 1) % 3] >= 0)) sides.push_back(e);
    if (sides.size() != 2) return line; // the coordinate is the same everywhere in the triangle
    walk_on(base, from.triangle, sides[0], coordinate, level, line.places);
    std::ranges::reverse(line.places);
    line.start = line.places.size();
    line.places.push_back(from);
    walk_on(base, from.triangle, sides[1], coordinate, level, line.places);
    return line;
}

} // namespace trivar
