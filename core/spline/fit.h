// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/fit_map.h"
#include "core/spline/tensor.h"

#include <glm/glm.hpp>

namespace trivar {

// The spline with given values at the Greville sites of its axes (for grids: every combination, the
// last axis fastest). Throws Rejected for another number of values; see interpolation_map.
template <class T> Curve<T> interpolate(const Knots& knots, const std::vector<T>& values)
{
    return {knots, fitted_points<T, 1>({knots}, {interpolation_map(knots)}, values)};
}
template <class T>
Surface<T> interpolate(const std::array<Knots, 2>& axes, const std::vector<T>& values)
{
    return {axes, fitted_points<T, 2>(
                      axes, {interpolation_map(axes[0]), interpolation_map(axes[1])}, values)};
}
template <class T>
Trivariate<T> interpolate(const std::array<Knots, 3>& axes, const std::vector<T>& values)
{
    return {axes, fitted_points<T, 3>(axes,
                                      {interpolation_map(axes[0]), interpolation_map(axes[1]),
                                       interpolation_map(axes[2])},
                                      values)};
}

// The curve nearest to values at parameters; see least_squares_map. O(m x order^2) for m samples
// and O(count^2 x order).
template <class T>
Curve<T> fit(const Knots& knots, std::span<const double> parameters, const std::vector<T>& values,
             const FitOptions& options = {})
{
    check_value_count(values.size(), std::array{static_cast<int>(parameters.size())});
    const AxisMap inverse = normal_inverse(knots, parameters, options);
    const AxisMap basis_at = sampling_map(knots, parameters);
    const auto width = static_cast<std::size_t>(basis_at.width);
    std::vector<T> right(static_cast<std::size_t>(knots.count()));
    for (std::size_t s = 0; s < values.size(); ++s)
        for (std::size_t k = 0; k < width; ++k) {
            const int i = knots.wrapped(basis_at.first[s] + static_cast<int>(k)).index;
            const double weight = options.weights.empty() ? 1 : options.weights[s];
            T& sum = right[static_cast<std::size_t>(i)];
            sum = sum + values[s] * (weight * basis_at.weights[s * width + k]);
        }
    if (options.ends) {
        right.front() = values.front();
        right.back() = values.back();
    }
    return {knots, applied(inverse, extent(knots), std::span<const T>(right), 1)};
}

// The surface or trivariate function nearest to values on the grid of parameters, the last axis
// fastest. Axes are fitted one after the other with their own options; without smoothing and
// weights that is the least-squares fit of the whole grid. Where an axis is twisted, the
// parameters of the other axes must be symmetric.
template <class T>
Surface<T> fit(const std::array<Knots, 2>& axes,
               const std::array<std::vector<double>, 2>& parameters, const std::vector<T>& values,
               const std::array<FitOptions, 2>& options = {})
{
    return {axes, fitted_points<T, 2>(axes,
                                      {least_squares_map(axes[0], parameters[0], options[0]),
                                       least_squares_map(axes[1], parameters[1], options[1])},
                                      values)};
}
template <class T>
Trivariate<T> fit(const std::array<Knots, 3>& axes,
                  const std::array<std::vector<double>, 3>& parameters,
                  const std::vector<T>& values, const std::array<FitOptions, 3>& options = {})
{
    return {axes, fitted_points<T, 3>(axes,
                                      {least_squares_map(axes[0], parameters[0], options[0]),
                                       least_squares_map(axes[1], parameters[1], options[1]),
                                       least_squares_map(axes[2], parameters[2], options[2])},
                                      values)};
}

// The length of the polygon up to each point as a share of its whole length, scaled to [begin,
// end]. Each step counts by its length to the power of `exponent`: 1 chord length, 1/2 centripetal.
// Throws Rejected where all points coincide or one is not finite.
std::vector<double> chord_length_parameters(std::span<const glm::dvec2> points, double begin = 0,
                                            double end = 1, double exponent = 1);
std::vector<double> chord_length_parameters(std::span<const glm::dvec3> points, double begin = 0,
                                            double end = 1, double exponent = 1);

// Takes one Newton step that moves each parameter toward the foot of its point on the curve, t +=
// <q - C, C'> / (|C'|^2 - <q - C, C''>), kept inside the domain; a step that would not descend is
// left out. Hoschek 1988.
std::vector<double> corrected_parameters(const Curve<glm::dvec2>& c, std::vector<double> parameters,
                                         std::span<const glm::dvec2> points);

} // namespace trivar
