// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

#include <algorithm>
#include <array>
#include <vector>

namespace trivar {

// BicubicCells is an open bicubic spline with equally spaced knots, ready to be evaluated many
// times: the polynomial of each cell in powers of its local parameters. About 10 nanoseconds a
// value, and 20 with derivatives. Parameters beyond the domain are moved to its border.
class BicubicCells {
public:
    BicubicCells() = default;
    explicit BicubicCells(const Surface<double>& surface);

    struct Jet {
        double value = 0, u = 0, v = 0;
    };
    double value(const glm::dvec2& uv) const;
    Jet jet(const glm::dvec2& uv) const;

private:
    struct Local { // where a parameter pair is
        const double* cell;
        double x, y; // 0..1
    };
    Local local(const glm::dvec2& uv) const;

    glm::dvec2 begin_{0}, per_cell_{1}; // per_cell_: 1 / length of a cell
    glm::ivec2 count_{0};
    std::vector<double> powers_; // 16 a cell, powers of u fastest
};

inline BicubicCells::Local BicubicCells::local(const glm::dvec2& uv) const
{
    const glm::dvec2 end(count_);
    const double u = std::min(std::max((uv.x - begin_.x) * per_cell_.x, 0.0), end.x);
    const double v = std::min(std::max((uv.y - begin_.y) * per_cell_.y, 0.0), end.y);
    const int i = std::min(static_cast<int>(u), count_.x - 1);
    const int j = std::min(static_cast<int>(v), count_.y - 1);
    return {powers_.data() + 16 * static_cast<std::size_t>(i * count_.y + j), u - i, v - j};
}

inline double BicubicCells::value(const glm::dvec2& uv) const
{
    const auto [c, x, y] = local(uv);
    std::array<double, 4> value; // by power of u
    for (std::size_t i = 0; i < 4; ++i)
        value[i] = c[i] + y * (c[4 + i] + y * (c[8 + i] + y * c[12 + i]));
    return value[0] + x * (value[1] + x * (value[2] + x * value[3]));
}

inline BicubicCells::Jet BicubicCells::jet(const glm::dvec2& uv) const
{
    const auto [c, x, y] = local(uv);
    std::array<double, 4> value, slope; // by power of u
    for (std::size_t i = 0; i < 4; ++i) {
        value[i] = c[i] + y * (c[4 + i] + y * (c[8 + i] + y * c[12 + i]));
        slope[i] = c[4 + i] + y * (2 * c[8 + i] + y * 3 * c[12 + i]);
    }
    return {value[0] + x * (value[1] + x * (value[2] + x * value[3])),
            per_cell_.x * (value[1] + x * (2 * value[2] + x * 3 * value[3])),
            per_cell_.y * (slope[0] + x * (slope[1] + x * (slope[2] + x * slope[3])))};
}

} // namespace trivar
