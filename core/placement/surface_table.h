// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

#include <span>
#include <vector>

namespace trivar {

// An AxisTable holds the basis functions of an open axis as polynomials, one row of coefficients
// per span. A value costs a few multiplications, where basis() walks the triangle of de Boor.
class AxisTable {
public:
    explicit AxisTable(const Knots& knots);

    struct Row {
        int first = 0; // control points first .. first + order - 1
        std::array<double, max_order> value, slope;
    };
    Row at(double t) const; // outside of the domain the first and the last polynomial continue

private:
    friend class SurfaceTable;
    template <std::size_t known_order> Row row(double t) const;

    int order_;
    double spans_a_unit_;
    std::vector<double> breaks_;
    struct Span {
        double begin, one_over_length;
        int first;
    };
    std::vector<Span> spans_;
    std::vector<double> coefficients_; // per span: order x order, by function, lowest power first
};

// A SurfaceTable is a surface with open axes made ready for many evaluations. The surface must
// outlive the table and keep its axes; its control points may move.
class SurfaceTable {
public:
    explicit SurfaceTable(const Surface<glm::dvec3>& surface);

    struct Jet {
        glm::dvec3 value{0}, u{0}, v{0};
    };
    Jet jet(glm::dvec2 uv) const;
    const glm::dvec2& cells() const { return cells_; } // of control points, along both axes
    bool creased() const { return creased_; } // the surface may fold along a line of control points

    // The surface at every u with every v, both ascending, v fastest: two matrix products.
    std::vector<glm::dvec3> grid(std::span<const double> u, std::span<const double> v) const;
    // The surface at (steps.x + 1) x (steps.y + 1) evenly spread parameters.
    std::vector<glm::dvec3> grid(glm::ivec2 steps) const;

    // Returns which of those parameters the marked control points influence.
    std::vector<char> touched(glm::ivec2 steps, const std::vector<char>& points) const;

    // Calls visit(index of the control point, weight) for every control point that influences the
    // place.
    template <class Visit> void each_weight(glm::dvec2 uv, const Visit& visit) const
    {
        const AxisTable::Row a = axes_[0].at(uv.x), b = axes_[1].at(uv.y);
        for (int i = 0; i < surface_.axes[0].order(); ++i)
            for (int j = 0; j < surface_.axes[1].order(); ++j)
                visit(surface_.index(a.first + i, b.first + j),
                      a.value[static_cast<std::size_t>(i)] * b.value[static_cast<std::size_t>(j)]);
    }

private:
    template <std::size_t known_rows, std::size_t known_columns> Jet jet_of(glm::dvec2 uv) const;

    const Surface<glm::dvec3>& surface_;
    std::array<AxisTable, 2> axes_;
    glm::dvec2 cells_;
    bool creased_ = false;
};

} // namespace trivar
