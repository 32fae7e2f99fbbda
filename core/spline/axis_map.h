// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <span>
#include <vector>

namespace trivar {

// An AxisMap is a linear map along one axis of a tensor product: row r of the result is sum_k
// weights[r * width + k] * (point first[r] + k). Indices are unwrapped, so that a row may reach
// round a closed axis. Insertion, sub-boxes, derivatives, sampling and fits are such maps; they are
// computed in double and applied to values of any type.
struct AxisMap {
    int width = 0;               // number of weights per row
    std::vector<int> first;      // one per row
    std::vector<double> weights; // rows x width, row-major

    std::size_t rows() const { return first.size(); }
};

// An AxisExtent is the number of points that the source axis stores, and how indices outside of it
// are wrapped.
struct AxisExtent {
    int count = 0;
    Closure closure = Closure::open;
};
inline AxisExtent extent(const Knots& knots)
{
    return {knots.count(), knots.closure()};
}

// The points after the map. `inner` is the number of points that vary faster than the axis. On a
// twisted axis all other axes are mirrored together, which reverses both the slower and the faster
// index. O(#points x width).
template <class T>
std::vector<T> applied(const AxisMap& map, AxisExtent axis, std::span<const T> points,
                       std::size_t inner)
{
    const auto count = static_cast<std::size_t>(axis.count);
    const auto width = static_cast<std::size_t>(map.width);
    const std::size_t outer = points.size() / (count * inner);
    std::vector<T> out(outer * map.rows() * inner);
    for (std::size_t a = 0; a < outer; ++a)
        for (std::size_t r = 0; r < map.rows(); ++r)
            for (std::size_t k = 0; k < width; ++k) {
                const double weight = map.weights[r * width + k];
                if (weight == 0) continue; // an inactive point may hold anything, even a NaN
                const std::size_t i = static_cast<std::size_t>(map.first[r]) + k;
                const bool mirrored = axis.closure == Closure::twisted && (i / count) % 2 == 1;
                const std::size_t row =
                    ((mirrored ? outer - 1 - a : a) * count + i % count) * inner;
                for (std::size_t b = 0; b < inner; ++b) {
                    T& sum = out[(a * map.rows() + r) * inner + b];
                    sum = sum + points[row + (mirrored ? inner - 1 - b : b)] * weight;
                }
            }
    return out;
}

// The map to values at the given parameters, each brought into the domain: rows of basis functions
// or, for `derivative` 1 or 2, of their derivatives. On a twisted axis a parameter that is an odd
// number of turns away takes the mirrored points.
AxisMap sampling_map(const Knots& knots, std::span<const double> parameters, int derivative = 0);

} // namespace trivar
