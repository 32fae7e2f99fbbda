// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// S(u,v) = sum_ij P_ij N_i(u) N_j(v).
template <class T> struct Surface {
    std::array<Knots, 2> axes;
    std::vector<T> points; // n_u x n_v stored control points, v fastest

    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(axes[1].count()) +
               static_cast<std::size_t>(j);
    }
    // By unwrapped indices: closed axes repeat, a twisted one mirrors the other.
    const T& point(int i, int j) const
    {
        const Knots::Wrapped u = axes[0].wrapped(i), v = axes[1].wrapped(j);
        return points[index(v.mirrored ? axes[0].count() - 1 - u.index : u.index,
                            u.mirrored ? axes[1].count() - 1 - v.index : v.index)];
    }
    bool operator==(const Surface&) const = default;
};

template <class T> struct SurfaceJet {
    T value{}, u{}, v{}, uu{}, uv{}, vv{};
};

// The jet at (u, v), brought into the domain; `derivatives` 0, 1 or 2 says what is filled in.
template <class T> SurfaceJet<T> evaluate(const Surface<T>& s, glm::dvec2 uv, int derivatives = 0)
{
    const Basis a = basis(s.axes[0], s.axes[0].into_domain(uv.x).t, derivatives);
    const Basis b = basis(s.axes[1], s.axes[1].into_domain(uv.y).t, derivatives);
    SurfaceJet<T> jet;
    for (int i = 0; i < s.axes[0].order(); ++i)
        for (int j = 0; j < s.axes[1].order(); ++j) {
            const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
            const T& p = s.point(a.first + i, b.first + j);
            jet.value = jet.value + p * (a.value[I] * b.value[J]);
            if (derivatives < 1) continue;
            jet.u = jet.u + p * (a.first_derivative[I] * b.value[J]);
            jet.v = jet.v + p * (a.value[I] * b.first_derivative[J]);
            if (derivatives < 2) continue;
            jet.uu = jet.uu + p * (a.second_derivative[I] * b.value[J]);
            jet.uv = jet.uv + p * (a.first_derivative[I] * b.first_derivative[J]);
            jet.vv = jet.vv + p * (a.value[I] * b.second_derivative[J]);
        }
    return jet;
}

} // namespace trivar
