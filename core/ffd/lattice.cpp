// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/lattice.h"

#include <limits>

namespace trivar {

glm::dvec3 greville(const Lattice& lattice, const glm::ivec3& index)
{
    const std::array<Knots, 3>& axes = lattice.displacement.axes;
    return {axes[0].greville(index.x), axes[1].greville(index.y), axes[2].greville(index.z)};
}

Lattice moved(Lattice lattice, std::span<const PointMove> moves)
{
    Trivariate<glm::dvec3>& d = lattice.displacement;
    for (const PointMove& move : moves)
        d.points[d.index(move.index.x, move.index.y, move.index.z)] += move.by;
    return lattice;
}

Reach reach(const Knots& knots)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (knots.closure() != Closure::open) return {-infinity, infinity};
    // A box fitted to a model has vertices on its faces, up to rounding; these count as inside.
    const double slack = 1e-6 * (knots.end() - knots.begin());
    return {knots.begin() - slack, knots.end() + slack};
}

Lattice lattice_at_rest(const std::array<Knots, 3>& axes, const glm::dmat4& rest)
{
    Lattice out{{axes, {}}, rest};
    out.displacement.points.assign(static_cast<std::size_t>(axes[0].count()) *
                                       static_cast<std::size_t>(axes[1].count()) *
                                       static_cast<std::size_t>(axes[2].count()),
                                   glm::dvec3(0));
    return out;
}

glm::dvec3 control_point(const Lattice& lattice, int i, int j, int k)
{
    const auto& d = lattice.displacement;
    return glm::dvec3(lattice.rest * glm::dvec4(greville(lattice, {i, j, k}), 1)) +
           d.points[d.index(i, j, k)];
}

Lattice lattice_through(const Trivariate<glm::dvec3>& control_points_world)
{
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : control_points_world.points) sum += p;
    const glm::dvec3 mean = sum / static_cast<double>(control_points_world.points.size());
    Lattice out{control_points_world, glm::dmat4(0)};
    out.rest[3] = glm::dvec4(mean, 1);
    for (glm::dvec3& p : out.displacement.points) p -= mean;
    return out;
}

Lattice mapped(Lattice lattice, const glm::dmat4& to_world)
{
    const glm::dmat3 turn(to_world);
    for (glm::dvec3& d : lattice.displacement.points) d = turn * d;
    lattice.rest = to_world * lattice.rest;
    return lattice;
}

Jet<glm::dvec3> evaluate(const Lattice& lattice, glm::dvec3 uvw, int derivatives)
{
    Jet<glm::dvec3> jet = evaluate(lattice.displacement, uvw, derivatives);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const Reach r = reach(lattice.displacement.axes[axis]);
            uvw[static_cast<int>(axis)] < r.least || uvw[static_cast<int>(axis)] > r.most)
            jet.first[axis] = glm::dvec3(0);
    jet.value += glm::dvec3(lattice.rest * glm::dvec4(uvw, 1));
    for (std::size_t axis = 0; axis < 3 && derivatives > 0; ++axis)
        jet.first[axis] += glm::dvec3(lattice.rest[static_cast<int>(axis)]);
    return jet;
}

} // namespace trivar
