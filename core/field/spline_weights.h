// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/field_spline.h"

#include <algorithm>
#include <array>

namespace trivar {

// The weights of the four coefficients from `first` on, for the value and the first and second
// derivative of a spline along one axis.
template <class Real> struct SplineWeights {
    int first;
    std::array<Real, 4> value, slope, bend;
};

// Returns the weights at x on an axis of `size` samples. Beyond the samples the polynomial of the
// last cell continues.
template <class Real>
[[gnu::always_inline]] inline SplineWeights<Real> spline_weights(FieldOrder order, Real x, int size)
{
    SplineWeights<Real> w;
    if (order == FieldOrder::cubic) {
        const int i = std::clamp(static_cast<int>(x), 0, size - 2);
        const Real t = x - static_cast<Real>(i), s = 1 - t, sixth = Real(1) / 6;
        w.first = i - 1;
        w.value = {s * s * s * sixth, (3 * t * t * t - 6 * t * t + 4) * sixth,
                   (3 * s * s * s - 6 * s * s + 4) * sixth, t * t * t * sixth};
        w.slope = {Real(-0.5) * s * s, Real(1.5) * t * t - 2 * t, 2 * s - Real(1.5) * s * s,
                   Real(0.5) * t * t};
        w.bend = {s, 3 * t - 2, 1 - 3 * t, t};
    } else if (order == FieldOrder::quadratic) {
        const int i = std::clamp(static_cast<int>(x + Real(0.5)), 0, size - 1);
        const Real t = x - static_cast<Real>(i), a = Real(0.5) - t, b = Real(0.5) + t;
        w.first = i - 1;
        w.value = {a * a / 2, Real(0.75) - t * t, b * b / 2, 0};
        w.slope = {-a, -2 * t, b, 0};
        w.bend = {1, -2, 1, 0};
    } else {
        const int i = std::clamp(static_cast<int>(x), 0, size - 2);
        const Real t = x - static_cast<Real>(i);
        w.first = i;
        w.value = {1 - t, t, 0, 0};
        w.slope = {-1, 1, 0, 0};
        w.bend = {0, 0, 0, 0};
    }
    return w;
}

} // namespace trivar
