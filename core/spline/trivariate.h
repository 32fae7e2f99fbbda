// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// F(u,v,w) = sum_ijk P_ijk N_i(u) N_j(v) N_k(w): a tensor-product B-spline with values of type T
// (anything with + and a product with double).
template <class T> struct Trivariate {
    std::array<Knots, 3> axes;
    std::vector<T> points; // n_u x n_v x n_w stored control points, w fastest

    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(i) * static_cast<std::size_t>(axes[1].count()) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(axes[2].count()) +
               static_cast<std::size_t>(k);
    }
    // By unwrapped indices: closed axes repeat, twisted ones mirror the other two.
    const T& point(int i, int j, int k) const
    {
        const Knots::Wrapped u = axes[0].wrapped(i), v = axes[1].wrapped(j), w = axes[2].wrapped(k);
        const bool flip_u = v.mirrored != w.mirrored, flip_v = u.mirrored != w.mirrored,
                   flip_w = u.mirrored != v.mirrored;
        return points[index(flip_u ? axes[0].count() - 1 - u.index : u.index,
                            flip_v ? axes[1].count() - 1 - v.index : v.index,
                            flip_w ? axes[2].count() - 1 - w.index : w.index)];
    }
    bool operator==(const Trivariate&) const = default;
};

// Value, gradient (d/du, d/dv, d/dw) and second derivatives (uu, vv, ww, uv, vw, wu) at a point.
template <class T> struct Jet {
    T value{};
    std::array<T, 3> first{};
    std::array<T, 6> second{};
};

// The jet at uvw, brought into the domain; `derivatives` 0, 1 or 2 says what is filled in.
// O(order^3). The reference that every faster evaluator is tested against.
template <class T> Jet<T> evaluate(const Trivariate<T>& f, glm::dvec3 uvw, int derivatives = 0);

} // namespace trivar

#include "core/spline/trivariate_impl.h"
