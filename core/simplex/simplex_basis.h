// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/box_grid.h"
#include "core/simplex/multi_index.h"
#include "core/simplex/simplex_domain.h"

#include <cstdint>
#include <vector>

namespace trivar {

// A BasisValue is one basis function at a point: the number of its control point, its value and its
// gradient.
template <int S> struct BasisValue {
    int point = 0;
    double value = 0;
    glm::vec<S, double> gradient{0};
};

// A SimplexBasis has the DMS basis functions [1] of a domain. Function b of cell (t_0 .. t_S), b a
// multi-index, is the simplex spline of knots (k, 0) .. (k, b_k) of all corners k, scaled so that
// all functions sum to 1 in the domain:
//
//   N_b(x) = n! |det X_b / det W| vol_n { mu >= 0 : l(x) - B mu >= 0 }
//
// with X_b the knots (k, b_k), W the corners, l(x) the barycentric coordinates of x in the cell and
// the columns of B those of the other knots. Evaluating that volume (core/simplex/fibre.h) instead
// of the recursion needs no indicator of a simplex, and is as robust as it is fast. Where knots lie
// in one face's plane so that N_b jumps there, a point on the plane belongs to one side: that to
// which one fixed direction leads, or on the border of the domain the one into a cell there.
//   [1] Dahmen, Micchelli, Seidel, Blossoming begets B-splines built better by B-patches, 1992
template <int S> class SimplexBasis {
public:
    using Point = glm::vec<S, double>;

    // The domain must pass check(). O(number of cells).
    explicit SimplexBasis(SimplexDomain<S> domain);

    const SimplexDomain<S>& domain() const { return domain_; }
    // Functions whose knots are stacked on the same vertices share one control point, across faces
    // that are not cut.
    std::size_t point_count() const { return rest_.size(); }
    // Rest positions of the control points: with them as values the sum is the identity. By the
    // polar form they are (1/n) times the sum of the knots (k, j) with j < b_k.
    const std::vector<Point>& rest() const { return rest_; }
    int point_of(std::size_t cell, std::size_t index) const
    {
        return points_[cell * per_cell_ + index];
    }

    // The functions that are not 0 at x, by cell and multi-index; empty away from the domain. A
    // control point that several functions share may come several times. About 3 us for S = 3 and
    // degree 2, twice that with gradients. Thread-safe.
    void values_at(const Point& x, bool gradients, std::vector<BasisValue<S>>& out) const;

private:
    static constexpr std::size_t K = S + 1;
    using Barycentric = std::array<double, K>;
    // CellData holds the constants for evaluating the functions of one cell. Barycentric
    // coordinates are affine: rows give all but the first from x minus the first corner.
    struct CellData {
        Point origin;
        std::array<Point, K> gradient;
        Barycentric least;       // of all knots of the cell
        std::uint8_t border = 0; // bits of corners opposite to which the domain ends
        bool steep = false;      // so that coordinates by gradients would lose three digits
    };

    struct Place {
        Point x, direction; // to the side to which x belongs
        bool gradients;
    };
    Barycentric barycentric(std::size_t cell, const Point& x) const;
    Point inner_direction(const Point& x) const;
    // These two return whether a gradient may jump at the place.
    template <int N>
    bool add_values(std::size_t cell, const Barycentric& l, const Place& at,
                    std::vector<BasisValue<S>>& out) const;
    bool add_all(const Place& at, std::vector<BasisValue<S>>& out) const;
    bool beyond_jump(std::size_t cell, std::size_t corner, const Place& at) const;
    void find_border();
    void find_points();

    SimplexDomain<S> domain_;
    std::size_t per_cell_;
    std::vector<CellData> cells_;
    std::vector<Barycentric> clouds_; // of cloud knots, degree per corner, K corners per cell
    std::vector<double> scales_;      // n! |det X_b / det W|, per_cell_ per cell
    std::vector<std::uint8_t> jumps_; // per function: bits of corners at whose faces it jumps
    std::vector<int> points_;         // per function
    std::vector<Point> rest_;
    BoxGrid<S> grid_;
};

} // namespace trivar
