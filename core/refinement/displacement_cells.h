// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/trivariate.h"

namespace trivar {

// AxisSlabs divides one axis into slabs between its knot planes. Slab 0 begins where the domain
// begins. An open axis has one endless slab more on either side, where nothing changes along it. A
// closed axis has slabs without end.
class AxisSlabs {
public:
    explicit AxisSlabs(const Knots& knots);

    int order() const { return order_; }
    Closure closure() const { return closure_; }
    bool open() const { return closure_ == Closure::open; }
    int count() const { return count_; } // of the domain, or of one period
    // The slab in which x lies; where two slabs meet in x, the upper or the lower one of them.
    int upper(double x) const;
    int lower(double x) const;
    double begin(int slab) const; // -infinity where the slab has none
    double end(int slab) const { return begin(slab + 1); }
    bool beyond(int slab) const { return open() && (slab < 0 || slab >= count_); }

    // The continuity that is left where a slab meets the next one.
    enum class Joint { smooth, kink, jump };
    Joint joint(int slab) const;

    // The span from which a slab takes its values: its first unwrapped control point, and the
    // Bezier points of the span as order x order weights of control points, row by row.
    struct Span {
        int first = 0;
        std::array<double, max_order * max_order> bezier{};
        bool mirrors_others = false; // an odd number of times round a twisted axis
    };
    Span span(int slab) const;
    // The slab at this one's place when counted from the other end; open axes only.
    int mirrored(int slab) const { return count_ - 1 - slab; }
    // A parameter that is outside of an open axis by a rounding error is moved to the end of the
    // axis.
    double snapped(double x) const;

private:
    int order_, count_; // slabs of the domain, or of one period
    Closure closure_;
    double period_;
    std::vector<double> breaks_;
    std::vector<Span> spans_;
    std::vector<Joint> joints_; // where slab i begins, i = 0 .. count_
};

// DisplacementCells holds the displacement of a lattice cell by cell, in Bernstein form.
class DisplacementCells {
public:
    explicit DisplacementCells(const Trivariate<glm::dvec3>& displacement);

    const Trivariate<glm::dvec3>& displacement() const { return f_; }
    const AxisSlabs& axis(int a) const { return axes_[static_cast<std::size_t>(a)]; }
    glm::ivec3 orders() const { return {axes_[0].order(), axes_[1].order(), axes_[2].order()}; }

    // A Cell holds the Bezier points over its slabs, w fastest, and how its parameters are mapped.
    struct Cell {
        glm::ivec3 slabs{0};
        std::array<glm::dvec4, max_order * max_order * max_order> points;
        glm::bvec3 mirrored{false};
        glm::bvec3 beyond{false};
        glm::dvec3 begin{0}, size{1}; // of the slabs; beyond an axis: the axis's end, and 1
        double local(const glm::dvec3& uvw, int a) const; // from 0 to 1
    };
    void load(const glm::ivec3& slabs, Cell& cell) const;

    double largest() const { return largest_; } // greatest length of a control point
    // greatest length of the derivative by u, v and w
    const glm::dvec3& slopes() const { return slopes_; }
    bool zero() const { return largest_ == 0; }

private:
    Trivariate<glm::dvec3> f_;
    std::array<AxisSlabs, 3> axes_;
    double largest_ = 0;
    glm::dvec3 slopes_{0};
};

} // namespace trivar
