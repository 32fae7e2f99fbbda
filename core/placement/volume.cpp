// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/volume.h"

#include "core/spline/greville_grid.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Points = std::vector<glm::dvec3>;
using Jets = std::vector<SurfaceJet<glm::dvec3>>;

// The guard keeps the roof below 0.8 of the radius of a hollow: closer and det J is nearly zero.
constexpr double share_of_radius = 0.8;
constexpr int most_smoothings = 40;
constexpr int steps_around = 2; // a fold, in nodes, that are smoothed with it

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

// The larger principal curvature toward n; negative where the surface curves away on all sides.
double largest_curvature(const SurfaceJet<glm::dvec3>& s, const glm::dvec3& n)
{
    const double E = glm::dot(s.u, s.u), F = glm::dot(s.u, s.v), G = glm::dot(s.v, s.v);
    const double L = glm::dot(s.uu, n), M = glm::dot(s.uv, n), N = glm::dot(s.vv, n);
    const double area = E * G - F * F;
    if (!(area > 0)) return 0;
    const double mean = (E * N - 2 * F * M + G * L) / (2 * area);
    const double gauss = (L * N - M * M) / area;
    return mean + std::sqrt(std::max(0.0, mean * mean - gauss));
}

// The smallest det J at a node, of three heights of the volume.
double smallest_det(const SurfaceJet<glm::dvec3>& s, const SurfaceJet<glm::dvec3>& e)
{
    double smallest = 1e300;
    for (const double w : {0.0, 0.5, 1.0})
        smallest = std::min(smallest, glm::dot(glm::cross(s.u + w * e.u, s.v + w * e.v), e.value));
    return smallest;
}

// Halfway to the mean of the neighbours, where `chosen`.
Points smoothed(const Points& in, const std::vector<char>& chosen, int rows, int columns)
{
    Points out = in;
    const auto at = [columns](int i, int j) {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(j);
    };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            if (!chosen[at(i, j)]) continue;
            const glm::dvec3 around =
                in[at(std::max(i - 1, 0), j)] + in[at(std::min(i + 1, rows - 1), j)] +
                in[at(i, std::max(j - 1, 0))] + in[at(i, std::min(j + 1, columns - 1))];
            out[at(i, j)] = (in[at(i, j)] + around / 4.0) / 2.0;
        }
    return out;
}

// Adds the nodes around those where the volume folds; false if it folds nowhere.
bool add_folds(std::vector<char>& chosen, const Jets& s, const Jets& e, int rows, int columns)
{
    bool any = false;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const auto k = static_cast<std::size_t>(i * columns + j);
            if (smallest_det(s[k], e[k]) > 0) continue;
            any = true;
            for (int a = std::max(i - steps_around, 0); a <= std::min(i + steps_around, rows - 1);
                 ++a)
                for (int b = std::max(j - steps_around, 0);
                     b <= std::min(j + steps_around, columns - 1); ++b)
                    chosen[static_cast<std::size_t>(a * columns + b)] = 1;
        }
    return any;
}

} // namespace

Extrusion extrusion(const Surface<glm::dvec3>& contact, const View& view, double height,
                    double offset, bool through_nodes)
{
    const int rows = contact.axes[0].count(), columns = contact.axes[1].count();
    const GrevilleGrid nodes(contact.axes);
    const Jets at_nodes = nodes.jets(contact.points, 2);
    Points rise(at_nodes.size());
    int lowered = 0;
    for (std::size_t k = 0; k < rise.size(); ++k) {
        const SurfaceJet<glm::dvec3>& s = at_nodes[k];
        const glm::dvec3 v = view.toward_eye(s.value);
        if (offset == 0) {
            rise[k] = height * v;
            continue;
        }
        const glm::dvec3 n = unit_or(glm::cross(s.u, s.v), v);
        const glm::dvec3 d = unit_or(glm::mix(v, n, offset), v);
        const double bend = offset * largest_curvature(s, n);
        const double highest = bend > 0 ? share_of_radius / bend : height;
        if (highest < height) ++lowered;
        rise[k] = std::min(height, highest) * d;
    }
    const auto surface = [&](const Points& values) {
        return through_nodes ? nodes.through(values) : Surface<glm::dvec3>{contact.axes, values};
    };
    Extrusion out{surface(rise), lowered};
    Jets e = nodes.jets(out.rise.points, 1);
    std::vector<char> folded(rise.size(), 0);
    for (int i = 0; offset > 0 && i < most_smoothings; ++i) {
        if (!add_folds(folded, at_nodes, e, rows, columns)) break;
        rise = smoothed(rise, folded, rows, columns);
        out.rise = surface(rise);
        e = nodes.jets(out.rise.points, 1);
    }
    out.least_det = 1e300;
    for (std::size_t k = 0; k < e.size(); ++k) {
        out.least_det = std::min(out.least_det, smallest_det(at_nodes[k], e[k]));
        out.longest_u = std::max(out.longest_u, glm::length(at_nodes[k].u));
    }
    return out;
}

Lattice volume_over(const Surface<glm::dvec3>& contact, const Surface<glm::dvec3>& rise,
                    const Knots& above)
{
    Trivariate<glm::dvec3> f{{contact.axes[0], contact.axes[1], above}, {}};
    f.points.reserve(contact.points.size() * static_cast<std::size_t>(above.count()));
    for (std::size_t k = 0; k < contact.points.size(); ++k)
        for (int i = 0; i < above.count(); ++i)
            f.points.push_back(contact.points[k] + above.greville(i) * rise.points[k]);
    return lattice_through(f);
}

} // namespace trivar
