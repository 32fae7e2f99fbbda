// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplex/exact_recursion.h"

#include "core/simplex/multi_index.h"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

namespace trivar {
namespace {

using Number = boost::multiprecision::cpp_rational;
using Point = std::array<Number, 3>;

Point point(const glm::dvec3& p)
{
    return {Number(p.x), Number(p.y), Number(p.z)};
}

Number det(const Point& a, const Point& b, const Point& c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Point minus(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
// six times the volume, signed
Number volume(const std::array<Point, 4>& c)
{
    return det(minus(c[1], c[0]), minus(c[2], c[0]), minus(c[3], c[0]));
}

struct Place {
    Point x, direction;
};

// M(x | knots) of integral 1, by any four knots that are not in one plane.
Number simplex_spline(const std::vector<Point>& knots, const Place& place)
{
    const std::size_t count = knots.size();
    std::array<std::size_t, 4> w{};
    Number whole = 0;
    for (std::size_t a = 0; a < count && whole == 0; ++a)
        for (std::size_t b = a + 1; b < count && whole == 0; ++b)
            for (std::size_t c = b + 1; c < count && whole == 0; ++c)
                for (std::size_t d = c + 1; d < count && whole == 0; ++d) {
                    whole = volume({knots[a], knots[b], knots[c], knots[d]});
                    if (whole != 0) w = {a, b, c, d};
                }
    if (whole == 0) return 0;
    std::array<Number, 4> l, toward; // barycentric coordinates, and how they change
    const Point moved{place.x[0] + place.direction[0], place.x[1] + place.direction[1],
                      place.x[2] + place.direction[2]};
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<Point, 4> c{knots[w[0]], knots[w[1]], knots[w[2]], knots[w[3]]};
        c[i] = place.x;
        l[i] = volume(c) / whole;
        c[i] = moved;
        toward[i] = volume(c) / whole - l[i];
    }
    if (count == 4) {
        for (std::size_t i = 0; i < 4; ++i)
            if (l[i] < 0 || (l[i] == 0 && toward[i] < 0)) return 0;
        return 6 / abs(whole);
    }
    Number sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (l[i] == 0) continue;
        std::vector<Point> rest = knots;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(w[i]));
        sum += l[i] * simplex_spline(rest, place);
    }
    const int n = static_cast<int>(count) - 4;
    return sum * (n + 3) / n;
}

bool beside(const std::vector<glm::dvec3>& knots, const glm::dvec3& x)
{
    glm::dvec3 lo = knots[0], hi = lo;
    for (const glm::dvec3& k : knots) lo = glm::min(lo, k), hi = glm::max(hi, k);
    return glm::any(glm::lessThan(x, lo)) || glm::any(glm::greaterThan(x, hi));
}

} // namespace

std::vector<double> exact_values(const SimplexDomain<3>& domain, const glm::dvec3& x,
                                 const glm::dvec3& direction)
{
    const Place place{point(x), point(direction)};
    int factor = 1; // (n + 3)! / n!
    for (int i = 1; i <= 3; ++i) factor *= domain.degree + i;
    std::vector<double> out;
    for (const auto& cell : domain.cells)
        for (const MultiIndex<3>& index : multi_indices<3>(domain.degree)) {
            std::vector<glm::dvec3> knots;
            std::array<Point, 4> last;
            for (std::size_t k = 0; k < 4; ++k) {
                for (int j = 0; j <= index[k]; ++j) knots.push_back(domain.knot(cell[k], j));
                last[k] = point(knots.back());
            }
            out.push_back(0);
            if (beside(knots, x)) continue;
            std::vector<Point> exact;
            for (const glm::dvec3& k : knots) exact.push_back(point(k));
            const Number value = abs(volume(last)) * simplex_spline(exact, place) / factor;
            out.back() = static_cast<double>(value);
        }
    return out;
}

} // namespace trivar
