// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/exact_side.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace trivar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Sorts by number and returns the sign of the permutation.
template <class Points, std::size_t N> int sorted(Points& points, std::array<int, N>& numbers)
{
    int sign = 1;
    for (std::size_t i = 1; i < N; ++i)
        for (std::size_t k = i; k > 0 && numbers[k] < numbers[k - 1]; --k) {
            std::swap(numbers[k], numbers[k - 1]);
            std::swap(points[k], points[k - 1]);
            sign = -sign;
        }
    return sign;
}

Kernel::Point_3 of(const glm::dvec3& p)
{
    return {p.x, p.y, p.z};
}
Kernel::Point_2 of(const glm::dvec2& p)
{
    return {p.x, p.y};
}

} // namespace

int exact_side(std::array<glm::dvec2, 2> line, std::array<int, 2> numbers, const glm::dvec2& point,
               const glm::dvec2& direction)
{
    const int sign = sorted(line, numbers);
    const CGAL::Orientation exact = CGAL::orientation(of(line[0]), of(line[1]), of(point));
    if (exact != CGAL::COLLINEAR) return exact == CGAL::POSITIVE ? sign : -sign;
    const glm::dvec2 along = line[1] - line[0];
    return along.x * direction.y - along.y * direction.x > 0 ? sign : -sign;
}

int exact_side(std::array<glm::dvec3, 3> plane, std::array<int, 3> numbers, const glm::dvec3& point,
               const glm::dvec3& direction)
{
    const int sign = sorted(plane, numbers);
    // CGAL counts (b - a, c - a, p - a) of positive orientation as positive
    const CGAL::Orientation exact =
        CGAL::orientation(of(plane[0]), of(plane[1]), of(plane[2]), of(point));
    if (exact != CGAL::COPLANAR) return exact == CGAL::POSITIVE ? sign : -sign;
    const glm::dvec3 normal = glm::cross(plane[1] - plane[0], plane[2] - plane[0]);
    return glm::dot(normal, direction) > 0 ? sign : -sign;
}

} // namespace trivar
