// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/bezier_cell.h"
#include "core/spline/box_tree.h"

#include <optional>

namespace trivar {

// Where a world point lies in a volume.
struct Located {
    enum class Status {
        found,        // residual <= 1e-12 of the volume's diagonal
        outside,      // the point has no preimage; uvw is the nearest that was found
        not_converged // a search did not end: uvw is the best so far
    };
    glm::dvec3 uvw{0};
    double residual = 0; // |F(uvw) - p|, world units
    Status status = Status::not_converged;
};

// World to parameters for one map: the inverse of evaluate(f, uvw).value. Building takes the Bezier
// form, O(control points x order^3). Thread-safe; the same answer on every thread and in any order.
class Inverter {
public:
    // Throws Rejected for a shape or control points that are not finite.
    explicit Inverter(const Trivariate<glm::dvec3>& f);

    // One preimage of p. Where the map folds and there are several, the one nearest the hint;
    // without a hint the first, by cells. A point that is not finite is not_converged.
    // About 5 microseconds inside; outside, where the nearest cells are searched, 50 times that.
    Located locate(const glm::dvec3& p_world, std::optional<glm::dvec3> hint = {}) const;

    // All distinct preimages (further apart than 1e-6 of the domain), ascending by u, v, w; empty
    // outside. Each candidate cell is searched from the middles of its parts, so that two
    // preimages closer than a quarter cell may count as one.
    std::vector<Located> locate_all(const glm::dvec3& p_world) const;

private:
    std::vector<Located> search_parts(const glm::dvec3& p, int cell, bool first_only) const;
    Located nearest(const glm::dvec3& p) const;
    double apart(const glm::dvec3& a, const glm::dvec3& b) const;

    std::vector<Knots> axes_;
    std::vector<BezierCell> cells_;
    std::vector<Box> boxes_; // one a cell
    BoxTree tree_;
    double tolerance_ = 0; // world
};

} // namespace trivar
