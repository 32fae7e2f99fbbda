// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A Surface is S(u,v) = sum_ij P_ij N_i(u) N_j(v).
template <class T> struct Surface {
    std::array<Knots, 2> axes;
    std::vector<T> points; // n_u x n_v stored control points, v fastest

    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(axes[1].count()) +
               static_cast<std::size_t>(j);
    }
    // A control point by unwrapped indices: closed axes repeat, a twisted one mirrors the other.
    const T& point(int i, int j) const
    {
        const Knots::WrappedIndex u = axes[0].wrapped(i), v = axes[1].wrapped(j);
        return points[index(v.mirrored ? axes[0].count() - 1 - u.index : u.index,
                            u.mirrored ? axes[1].count() - 1 - v.index : v.index)];
    }
    bool operator==(const Surface&) const = default;
};

template <class T> struct SurfaceJet {
    T value{}, u{}, v{}, uu{}, uv{}, vv{};
};

// The jet at (u, v), brought into the domain; `derivatives` 0, 1 or 2 says how many are computed.
template <class T> SurfaceJet<T> evaluate(const Surface<T>& s, glm::dvec2 uv, int derivatives = 0)
{
    // A twisted axis that was gone round an odd number of times mirrors the other one.
    glm::dvec2 t = uv;
    glm::dvec2 sign(1);
    for (int axis = 0; axis < 2; ++axis) {
        const Knots::InDomain in = s.axes[static_cast<std::size_t>(axis)].into_domain(t[axis]);
        t[axis] = in.t;
        if (!in.odd) continue;
        const Knots& other = s.axes[static_cast<std::size_t>(1 - axis)];
        t[1 - axis] = other.begin() + other.end() - t[1 - axis];
        sign[1 - axis] = -sign[1 - axis];
    }
    t.x = s.axes[0].into_domain(t.x).t;
    const Basis a = basis(s.axes[0], t.x, derivatives);
    const Basis b = basis(s.axes[1], t.y, derivatives);
    SurfaceJet<T> jet;
    for (int i = 0; i < s.axes[0].order(); ++i)
        for (int j = 0; j < s.axes[1].order(); ++j) {
            const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
            const T& p = s.point(a.first + i, b.first + j);
            jet.value = jet.value + p * (a.value[I] * b.value[J]);
            if (derivatives < 1) continue;
            const double u1 = sign.x * a.first_derivative[I], v1 = sign.y * b.first_derivative[J];
            jet.u = jet.u + p * (u1 * b.value[J]);
            jet.v = jet.v + p * (a.value[I] * v1);
            if (derivatives < 2) continue;
            jet.uu = jet.uu + p * (a.second_derivative[I] * b.value[J]);
            jet.uv = jet.uv + p * (u1 * v1);
            jet.vv = jet.vv + p * (a.value[I] * b.second_derivative[J]);
        }
    return jet;
}

} // namespace trivar
