// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/volume.h"

#include "core/base/unit.h"
#include "core/placement/contact.h"
#include "core/spline/greville_grid.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Points = std::vector<glm::dvec3>;
using Jets = std::vector<SurfaceJet<glm::dvec3>>;

// The guard keeps the roof below 0.8 of the radius of a hollow: any closer, det J is nearly zero.
constexpr double share_of_radius = 0.8;
constexpr double told = 0.5; // relative to the height: less lowering is hardly visible
constexpr int most_smoothings = 40;

// Returns the principal curvatures toward n, the larger one first; negative where the surface
// curves away.
glm::dvec2 curvatures(const SurfaceJet<glm::dvec3>& s, const glm::dvec3& n)
{
    const double E = glm::dot(s.u, s.u), F = glm::dot(s.u, s.v), G = glm::dot(s.v, s.v);
    const double L = glm::dot(s.uu, n), M = glm::dot(s.uv, n), N = glm::dot(s.vv, n);
    const double area = E * G - F * F;
    if (!(area > 0)) return glm::dvec2(0);
    const double mean = (E * N - 2 * F * M + G * L) / (2 * area);
    const double gauss = (L * N - M * M) / area;
    const double apart = std::sqrt(std::max(0.0, mean * mean - gauss));
    return {mean + apart, mean - apart};
}

// Returns det J at the nodes, the smallest over three levels of the volume.
std::vector<double> smallest_det(const Jets& s, const Jets& e, const Levels& levels)
{
    std::vector<double> out(s.size());
    for (std::size_t k = 0; k < s.size(); ++k) {
        const auto det = [&](double w) {
            return glm::dot(glm::cross(s[k].u + w * e[k].u, s[k].v + w * e[k].v), e[k].value);
        };
        out[k] = std::min({det(levels.floor), det(levels.middle), det(levels.roof)});
    }
    return out;
}

// Moves each point half way to the mean of its neighbours.
Points smoothed(const Points& in, int rows, int columns)
{
    Points out(in.size());
    const auto at = [columns](int i, int j) {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(j);
    };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const glm::dvec3 around =
                in[at(std::max(i - 1, 0), j)] + in[at(std::min(i + 1, rows - 1), j)] +
                in[at(i, std::max(j - 1, 0))] + in[at(i, std::min(j + 1, columns - 1))];
            out[at(i, j)] = (in[at(i, j)] + around / 4.0) / 2.0;
        }
    return out;
}

} // namespace

Levels levels_of(const Rise& rise, double contact_level)
{
    const double ground = rise.at(contact_level);
    return {rise.at(0) - ground, rise.at(0.5) - ground, rise.at(1) - ground};
}

double Extrusion::least_det() const
{
    return *std::min_element(det.begin(), det.end());
}

Extrusion extrusion(const Surface<glm::dvec3>& contact, const View& view,
                    const std::vector<double>& height, double offset, bool through_nodes,
                    const Levels& levels)
{
    const int rows = contact.axes[0].count(), columns = contact.axes[1].count();
    const GrevilleGrid nodes(contact.axes);
    const Jets at_nodes = nodes.jets(contact.points, 2);
    Points rise(at_nodes.size());
    int lowered = 0;
    for (std::size_t k = 0; k < rise.size(); ++k) {
        const SurfaceJet<glm::dvec3>& s = at_nodes[k];
        const glm::dvec3 v = view.toward_eye(s.value);
        const double wanted = height[k];
        if (offset == 0) {
            rise[k] = wanted * v;
            continue;
        }
        const glm::dvec3 n = unit_or(glm::cross(s.u, s.v), v);
        const glm::dvec3 d = unit_or(glm::mix(v, n, offset), v);
        const glm::dvec2 curvature = curvatures(s, n); // the roof bends in hollows, the floor over
                                                       // ridges
        const double bend =
            offset * std::max(levels.roof * curvature.x, levels.floor * curvature.y);
        const double highest = bend > 0 ? share_of_radius / bend : wanted;
        if (highest < told * wanted) ++lowered;
        rise[k] = std::min(wanted, highest) * d;
    }
    // On a crease both sides count equally.
    for (int axis = 0; offset > 0 && axis < 2; ++axis)
        for (int i = 1; i + 1 < contact.axes[static_cast<std::size_t>(axis)].count(); ++i) {
            if (!creased(contact.axes[static_cast<std::size_t>(axis)], i)) continue;
            for (int j = 0; j < (axis == 0 ? columns : rows); ++j) {
                const auto at = [&](int step) {
                    return axis == 0 ? contact.index(i + step, j) : contact.index(j, i + step);
                };
                const glm::dvec3 &before = rise[at(-1)], &after = rise[at(1)];
                glm::dvec3& on = rise[at(0)];
                on = glm::length(before + after) / 2 * unit_or(before + after, unit_or_zero(on));
            }
        }
    const auto surface = [&](const Points& values) {
        Surface<glm::dvec3> control{contact.axes, values};
        if (!through_nodes) return control;
        Surface<glm::dvec3> through = nodes.through(values);
        for (std::size_t k = 0; offset == 0 && k < values.size(); ++k)
            if (!(glm::dot(through.points[k], values[k]) > 0)) return control;
        return through;
    };
    Extrusion out{surface(rise), lowered, {}, {}};
    out.det = smallest_det(at_nodes, nodes.jets(out.rise.points, 1), levels);
    // The volume is tested after 1, 2, 4, 7, 11, ... smoothings, because fitting costs more than
    // smoothing.
    for (int i = 0; offset > 0 && i < most_smoothings && out.least_det() <= 0;) {
        for (const int until = i + i / 2 + 1; i < until; ++i) rise = smoothed(rise, rows, columns);
        out.rise = surface(rise);
        out.det = smallest_det(at_nodes, nodes.jets(out.rise.points, 1), levels);
    }
    for (const SurfaceJet<glm::dvec3>& s : at_nodes) {
        out.area.push_back(glm::length(glm::cross(s.u, s.v)));
        out.longest_u = std::max(out.longest_u, glm::length(s.u));
    }
    return out;
}

Lattice volume_over(const Surface<glm::dvec3>& contact, const Surface<glm::dvec3>& extruded,
                    const Knots& above, const Rise& rise, double contact_level)
{
    const double ground = rise.at(contact_level);
    Trivariate<glm::dvec3> f{{contact.axes[0], contact.axes[1], above}, {}};
    f.points.reserve(contact.points.size() * static_cast<std::size_t>(above.count()));
    for (std::size_t k = 0; k < contact.points.size(); ++k)
        for (int i = 0; i < above.count(); ++i)
            f.points.push_back(contact.points[k] + (rise.point(i) - ground) * extruded.points[k]);
    return lattice_through(f);
}

} // namespace trivar
