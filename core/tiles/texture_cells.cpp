// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/texture_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace trivar {
namespace {

double turn_from(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Whether p is to the left of a - b. Of the two directions of an edge exactly one has a point to
// its left, whatever is rounded: numbers are computed for one of them.
bool to_the_left(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
    const bool ordered = std::pair(a.x, a.y) < std::pair(b.x, b.y);
    return ordered ? turn_from(a, b, p) >= 0 : turn_from(b, a, p) < 0;
}

bool is_number(const glm::vec2& uv)
{
    return std::isfinite(uv.x) && std::isfinite(uv.y);
}

// A triangle of texture coordinates in cells, counter-clockwise.
struct FlatCorners {
    std::array<glm::dvec2, 3> at;
    double area = 0; // twice

    bool holds(const glm::dvec2& p) const
    {
        return to_the_left(at[0], at[1], p) && to_the_left(at[1], at[2], p) &&
               to_the_left(at[2], at[0], p);
    }
    // Where the line at that height enters and leaves it.
    std::pair<double, double> range(double y) const
    {
        double lo = 1e300, hi = -1e300;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 &a = at[k], &b = at[(k + 1) % 3];
            if ((a.y < y && b.y < y) || (a.y > y && b.y > y)) continue;
            const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            lo = std::min({lo, x, a.y == b.y ? b.x : x});
            hi = std::max({hi, x, a.y == b.y ? b.x : x});
        }
        return {lo, hi};
    }
};

} // namespace

std::optional<TextureSpots> texture_spots(const Mesh& mesh, const glm::dmat4& to_model, int columns,
                                          int rows, std::size_t most)
{
    if (mesh.uvs.empty()) return {};
    constexpr double farthest = 1e6;       // from the first square, in squares
    constexpr int most_lines = 20'000'000; // of cells that triangles meet, for all of them
    int lines = 0;
    TextureSpots out;
    std::set<std::pair<std::int64_t, std::int64_t>> taken;
    const std::vector<glm::uvec3> all = triangles(mesh);
    for (std::uint32_t t = 0; t < all.size(); ++t) {
        std::array<glm::dvec3, 3> p;
        FlatCorners flat;
        bool numbers = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = all[t][static_cast<int>(k)];
            p[k] = glm::dvec3(to_model * glm::dvec4(mesh.positions[v], 1));
            const glm::vec2 uv = mesh.uvs[0][v];
            numbers &= is_number(uv) && std::abs(uv.x) < farthest && std::abs(uv.y) < farthest;
            flat.at[k] = glm::dvec2(uv) * glm::dvec2(columns, rows);
        }
        if (numbers) flat.area = turn_from(flat.at[0], flat.at[1], flat.at[2]);
        if (!numbers || flat.area == 0) {
            ++out.flat;
            continue;
        }
        const glm::dvec2 b = flat.at[1] - flat.at[0], c = flat.at[2] - flat.at[0];
        const glm::dvec3 along_u = (c.y * (p[1] - p[0]) - b.y * (p[2] - p[0])) / flat.area,
                         along_v = (b.x * (p[2] - p[0]) - c.x * (p[1] - p[0])) / flat.area;
        const glm::dvec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double side = std::sqrt(glm::length(glm::cross(along_u, along_v)));
        if (!(side > 0) || !(glm::length(across) > 0)) continue;
        const auto weights = [&, at = flat.at](const glm::dvec2& q) {
            const double v = (c.y * (q.x - at[0].x) - c.x * (q.y - at[0].y)) / flat.area,
                         w = (b.x * (q.y - at[0].y) - b.y * (q.x - at[0].x)) / flat.area;
            return glm::dvec3(1 - v - w, v, w);
        };
        const std::array<glm::dvec2, 3> given = flat.at;
        if (flat.area < 0) std::swap(flat.at[1], flat.at[2]);
        const auto [low, high] = std::minmax({given[0].y, given[1].y, given[2].y});
        for (auto j = std::llround(std::floor(low - 0.5)); static_cast<double>(j) + 0.5 <= high;
             ++j) {
            if (++lines > most_lines) {
                out.too_many = true;
                return out;
            }
            const double y = static_cast<double>(j) + 0.5;
            const auto [from, to] = flat.range(y);
            if (from > to) continue;
            for (auto i = std::llround(std::floor(from - 1)); static_cast<double>(i) <= to + 1;
                 ++i) {
                const glm::dvec2 centre(static_cast<double>(i) + 0.5, y);
                if (!flat.holds(centre)) continue;
                if (out.spots.size() == most) {
                    out.too_many = true;
                    return out;
                }
                TextureSpot spot{.triangle = t, .weights = weights(centre), .cell = {i, j}};
                spot.p = spot.weights.x * p[0] + spot.weights.y * p[1] + spot.weights.z * p[2];
                spot.normal = glm::normalize(across);
                spot.along_u = along_u;
                spot.along_v = along_v;
                spot.side = side;
                out.repeated += !taken.emplace(i, j).second;
                out.spots.push_back(spot);
            }
        }
    }
    return out;
}

} // namespace trivar
