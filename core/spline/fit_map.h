// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/axis_map.h"

namespace trivar {

// The sites of an axis's control points: their Greville abscissae, brought into the domain.
std::vector<double> greville_sites(const Knots& knots);

struct FitOptions {
    double smoothing = 0; // mu of mu int |C''|^2 dt over the domain (|C'|^2 for order 2)
    bool ends = false;    // passes through the first and the last sample; clamped axes only
    std::span<const double> weights = {}; // one per sample, >= 0; empty: all 1
};

// The map from values at the Greville sites to control points: the inverse of sampling there.
// Throws Rejected where two sites coincide (a knot of multiplicity `order` inside the axis).
// O(count^2 x order).
AxisMap interpolation_map(const Knots& knots);

// The map from m values q at parameters t, brought into the domain, to the control points that
// minimise sum_s w_s |C(t_s) - q_s|^2 + mu int |C''|^2. Throws Rejected for numbers that are not
// finite, negative weights or smoothing, samples that leave a control point undetermined
// (Schoenberg and Whitney: with mu = 0 every control point needs a sample of its own inside its
// support), and tables of more than 2^24 numbers. A dense table of count x m, O(count x m x order).
AxisMap least_squares_map(const Knots& knots, std::span<const double> parameters,
                          const FitOptions& options = {});

// The same for one set of values: the map from the right sides of the normal equations, sum_s w_s
// N_i(t_s) q_s for each i, to control points. With `ends` the first and the last right side are the
// first and the last value. O(m x order^2 + count^2 x order), without a table of m columns.
AxisMap normal_inverse(const Knots& knots, std::span<const double> parameters,
                       const FitOptions& options = {});

// The number of samples that a map of this file takes, once round the axis.
int sample_count(const Knots& knots, const AxisMap& map);
void check_value_count(std::size_t values, std::span<const int> counts);

// Applies one map after the other along the axes of a grid of values, the last axis fastest. Throws
// Rejected unless there is one value for every combination. Used by fit and interpolate.
template <class T, std::size_t N>
std::vector<T> fitted_points(const std::array<Knots, N>& axes, const std::array<AxisMap, N>& maps,
                             std::vector<T> values)
{
    std::array<int, N> samples{};
    for (std::size_t a = 0; a < N; ++a) samples[a] = sample_count(axes[a], maps[a]);
    check_value_count(values.size(), samples);
    std::size_t inner = 1; // from the fastest axis outward: the faster ones are control points
    for (std::size_t a = N; a-- > 0;) {
        values =
            applied(maps[a], {samples[a], axes[a].closure()}, std::span<const T>(values), inner);
        inner *= static_cast<std::size_t>(axes[a].count());
    }
    return values;
}

} // namespace trivar
