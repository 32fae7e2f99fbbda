// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"
#include "core/mesh/primitives.h"
#include "core/refinement/refine.h"
#include "tests/support/splines.h"

#include <numbers>

namespace trivar::testing {

// One cell over [0, 1]^3 whose control points are where `place` takes their Greville points.
template <class Place> Lattice one_cell(int order, const Place& place)
{
    const Knots knots = Knots::uniform(order, order);
    Lattice lattice = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    for (int i = 0; i < order; ++i)
        for (int j = 0; j < order; ++j)
            for (int k = 0; k < order; ++k) {
                const glm::dvec3 at(knots.greville(i), knots.greville(j), knots.greville(k));
                const auto p = lattice.displacement.index(i, j, k);
                lattice.displacement.points[p] = place(at) - at;
            }
    return lattice;
}

inline glm::dvec3 bend(const glm::dvec3& p)
{
    const double angle = (p.x - 0.5) * std::numbers::pi * 0.9, radius = 1.2 - p.z;
    return {radius * std::sin(angle), p.y, radius * std::cos(angle)};
}
inline glm::dvec3 twist(const glm::dvec3& p)
{
    const glm::dvec3 c = p - 0.5;
    const double angle = 2 * c.z;
    return {c.x * std::cos(angle) - c.y * std::sin(angle),
            c.x * std::sin(angle) + c.y * std::cos(angle), c.z};
}
inline double diagonal(const Lattice& lattice)
{
    Box box;
    const auto& axes = lattice.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) box.add(control_point(lattice, i, j, k));
    return glm::length(box.size());
}

// The cube [0, 1]^3: 12 triangles over 8 points.
inline Mesh unit_cube()
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i >> 2, i >> 1 & 1, i & 1);
    for (const auto& q : std::vector<std::array<std::uint32_t, 4>>{
             {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
        add_face(mesh, std::array{q[0], q[1], q[2]});
        add_face(mesh, std::array{q[0], q[2], q[3]});
    }
    return mesh;
}

// The greatest distance of what is drawn, flat triangles of single precision, from the deformed
// surface of the mesh before, sampled: every triangle is taken over its own plane.
inline double drawn_error(const Mesh& refined, const Embedding& embedding, const Lattice& lattice,
                          int levels = 12)
{
    const Mesh drawn = deform(refined, embedding, lattice);
    double most = 0;
    for (const glm::uvec3& t : triangles(refined))
        for (int i = 0; i <= levels; ++i)
            for (int j = 0; i + j <= levels; ++j) {
                const double a = double(i) / levels, b = double(j) / levels, c = 1 - a - b;
                const auto mixed = [&](const Mesh& mesh) {
                    return a * glm::dvec3(mesh.positions[t.x]) +
                           b * glm::dvec3(mesh.positions[t.y]) +
                           c * glm::dvec3(mesh.positions[t.z]);
                };
                const glm::dvec3 p = mixed(refined);
                const glm::dvec3 truth =
                    evaluate(lattice.displacement, glm::dvec3(embedding.to_uvw * glm::dvec4(p, 1)))
                        .value +
                    glm::dvec3(embedding.to_rest * glm::dvec4(p, 1));
                most = std::max(most, glm::distance(mixed(drawn), truth));
            }
    return most;
}

inline RefinementResult refine_one(const Mesh& mesh, const Lattice& lattice, RefineOptions options)
{
    return refine({{make_ref(mesh), {}}}, lattice, options);
}

} // namespace trivar::testing
