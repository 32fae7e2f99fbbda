// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/hull_cells.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>

namespace trivar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

// Whether no four points span a volume.
bool flat(const std::vector<Point>& points)
{
    const Point& a = points.front();
    const auto differs = [&](const Point& p) { return p != a; };
    const auto b = std::find_if(points.begin(), points.end(), differs);
    if (b == points.end()) return true;
    const auto off_line = [&](const Point& p) { return !CGAL::collinear(a, *b, p); };
    const auto c = std::find_if(b, points.end(), off_line);
    if (c == points.end()) return true;
    return std::all_of(c, points.end(),
                       [&](const Point& p) { return CGAL::coplanar(a, *b, *c, p); });
}

// Each point with others so near to it that they are no matter, but span a volume.
std::vector<Point> thickened(const std::vector<Point>& points)
{
    Box box;
    for (const Point& p : points) box.add(glm::dvec3(p.x(), p.y(), p.z()));
    const glm::dvec3 size = box.size(), far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double by = std::max({1e-6 * glm::length(size), 1e-12 * glm::length(far), 1e-100});
    std::vector<Point> out;
    for (const Point& p : points)
        for (const double sign : {-by, by}) {
            out.emplace_back(p.x() + sign, p.y(), p.z());
            out.emplace_back(p.x(), p.y() + sign, p.z());
            out.emplace_back(p.x(), p.y(), p.z() + sign);
        }
    return out;
}

} // namespace

FilledCells hull_cells(std::span<const glm::dvec3> points, const CellFilling& filling)
{
    if (points.empty()) throw Rejected("There are no points to put cells around.");
    std::vector<Point> all;
    for (const glm::dvec3& p : points) {
        if (!finite(p) || glm::length(p) > 1e30)
            throw Rejected("A vertex of the model is not a number, or too far away.");
        all.emplace_back(p.x, p.y, p.z);
    }
    if (flat(all)) all = thickened(all);
    CGAL::Surface_mesh<Point> hull;
    CGAL::convex_hull_3(all.begin(), all.end(), hull);
    std::vector<glm::dvec3> positions;
    for (const auto v : hull.vertices()) {
        const Point& p = hull.point(v);
        positions.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<std::array<int, 3>> triangles;
    for (const auto f : hull.faces()) {
        std::array<int, 3> t{};
        std::size_t n = 0;
        for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
            if (n < 3) t[n++] = static_cast<int>(v);
        triangles.push_back(t);
    }
    return cells_around(positions, triangles, filling);
}

} // namespace trivar
