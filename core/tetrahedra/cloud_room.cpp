// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/cloud_room.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Calls visit(knot numbers, corners) for each simplex of one knot per corner of a cell.
void each_simplex(const SimplexDomain<3>& domain, int cell, auto&& visit)
{
    const auto& vertices = domain.cells[static_cast<std::size_t>(cell)];
    const int n = domain.degree;
    for (int a = 0; a <= n; ++a)
        for (int b = 0; a + b <= n; ++b)
            for (int c = 0; a + b + c <= n; ++c)
                for (int d = 0; a + b + c + d <= n; ++d) {
                    const std::array<int, 4> index{a, b, c, d};
                    std::array<glm::dvec3, 4> x;
                    for (std::size_t k = 0; k < 4; ++k) x[k] = domain.knot(vertices[k], index[k]);
                    visit(index, x);
                }
}

double volume_of(const SimplexDomain<3>& domain, int cell)
{
    return orientation(corners(domain, static_cast<std::size_t>(cell)));
}

using Polygon = std::vector<glm::dvec3>;

// The half-space in which normal . p + offset >= 0.
struct HalfSpace {
    glm::dvec3 normal;
    double offset;
    double operator()(const glm::dvec3& p) const { return glm::dot(normal, p) + offset; }
};

std::vector<Polygon> cube(const glm::dvec3& middle, double half)
{
    std::vector<Polygon> out;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 n(0), u(0), v(0);
            n[axis] = side * half;
            u[(axis + 1) % 3] = half;
            v[(axis + 2) % 3] = side * half;
            const glm::dvec3 at = middle + n;
            out.push_back({at - u - v, at + u - v, at + u + v, at - u + v});
        }
    return out;
}

// Points of a convex polygon in a plane, in their order round it.
Polygon in_order(Polygon points, const glm::dvec3& normal)
{
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
    const glm::dvec3 u = glm::normalize(points.front() - middle);
    const glm::dvec3 v = glm::cross(glm::normalize(normal), u);
    std::ranges::sort(points, {}, [&](const glm::dvec3& p) {
        return std::atan2(glm::dot(v, p - middle), glm::dot(u, p - middle));
    });
    return points;
}

// Clips a convex body to a half-space.
std::vector<Polygon> clipped(const std::vector<Polygon>& body, const HalfSpace& half, double tiny)
{
    std::vector<Polygon> out;
    Polygon cap;
    const auto add_to_cap = [&](const glm::dvec3& p) {
        if (std::ranges::none_of(cap,
                                 [&](const glm::dvec3& q) { return glm::distance(p, q) < tiny; }))
            cap.push_back(p);
    };
    for (const Polygon& face : body) {
        Polygon kept;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3 &a = face[i], &b = face[(i + 1) % face.size()];
            const double fa = half(a), fb = half(b);
            if (fa >= 0) kept.push_back(a);
            if ((fa >= 0) == (fb >= 0)) continue;
            const glm::dvec3 between = glm::mix(a, b, fa / (fa - fb));
            kept.push_back(between);
            add_to_cap(between);
        }
        if (kept.size() >= 3) out.push_back(std::move(kept));
    }
    if (cap.size() >= 3) out.push_back(in_order(std::move(cap), -half.normal));
    return out;
}

} // namespace

std::vector<std::vector<glm::dvec3>> knot_region(const SimplexDomain<3>& domain,
                                                 std::span<const int> cells_round, int vertex,
                                                 int knot, double reach)
{
    const glm::dvec3 middle = domain.vertex(vertex);
    std::vector<Polygon> out = cube(middle, reach);
    for (const int cell : cells_round) {
        const auto& vertices = domain.cells[static_cast<std::size_t>(cell)];
        const auto at =
            static_cast<std::size_t>(std::ranges::find(vertices, vertex) - vertices.begin());
        const double whole = volume_of(domain, cell);
        each_simplex(domain, cell, [&](const std::array<int, 4>& index, auto x) {
            if (at == 4 || index[at] != knot) return;
            const double least = std::min(orientation(x) / whole, least_room);
            HalfSpace half{};
            x[at] = middle;
            const double there = orientation(x) / whole;
            for (int axis = 0; axis < 3; ++axis) {
                x[at] = middle;
                x[at][axis] += reach;
                half.normal[axis] = (orientation(x) / whole - there) / reach;
            }
            half.offset = there - least - glm::dot(half.normal, middle);
            if (glm::length(half.normal) > 0) out = clipped(out, half, 1e-9 * reach);
        });
    }
    return out;
}

std::vector<int> cells_round(const SimplexDomain<3>& domain, int vertex)
{
    std::vector<int> out;
    for (std::size_t c = 0; c < domain.cells.size(); ++c)
        if (std::ranges::find(domain.cells[c], vertex) != domain.cells[c].end())
            out.push_back(static_cast<int>(c));
    return out;
}

double cloud_room(const SimplexDomain<3>& domain, std::span<const int> cells_round)
{
    double out = 1;
    for (const int cell : cells_round) {
        const double whole = volume_of(domain, cell);
        each_simplex(domain, cell, [&](const std::array<int, 4>&, const auto& x) {
            out = std::min(out, orientation(x) / whole);
        });
    }
    return out;
}

double allowed_share(const SimplexDomain<3>& domain, std::span<const int> cells_round, int vertex,
                     int knot, const glm::dvec3& by)
{
    double out = 1;
    for (const int cell : cells_round) {
        const auto& vertices = domain.cells[static_cast<std::size_t>(cell)];
        const auto at =
            static_cast<std::size_t>(std::ranges::find(vertices, vertex) - vertices.begin());
        if (at == 4) continue;
        const double whole = volume_of(domain, cell);
        each_simplex(domain, cell, [&](const std::array<int, 4>& index, auto x) {
            if (index[at] != knot) return;
            const double now = orientation(x) / whole;
            x[at] += by;
            const double then = orientation(x) / whole, least = std::min(now, least_room);
            if (then < least) out = std::min(out, (now - least) / (now - then));
        });
    }
    return out;
}

} // namespace trivar
