// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <vector>

namespace trivar {

// A Curve is C(t) = sum_i P_i N_i(t).
template <class T> struct Curve {
    Knots knots;
    std::vector<T> points; // stored control points
    bool operator==(const Curve&) const = default;
};

template <class T> struct CurveJet {
    T value{}, first{}, second{};
};

// The jet at t, which is first brought into the domain; `derivatives` 0, 1 or 2 says how many are
// computed.
template <class T> CurveJet<T> evaluate(const Curve<T>& c, double t, int derivatives = 0)
{
    const Basis b = basis(c.knots, c.knots.into_domain(t).t, derivatives);
    CurveJet<T> jet;
    for (int i = 0; i < c.knots.order(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const T& p = c.points[static_cast<std::size_t>(c.knots.wrapped(b.first + i).index)];
        jet.value = jet.value + p * b.value[k];
        jet.first = jet.first + p * b.first_derivative[k];
        jet.second = jet.second + p * b.second_derivative[k];
    }
    return jet;
}

} // namespace trivar
