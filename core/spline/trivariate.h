// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A Trivariate is F(u,v,w) = sum_ijk P_ijk N_i(u) N_j(v) N_k(w): a tensor-product B-spline with
// values of type T (anything with + and a product with double).
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
    // A control point by unwrapped indices: closed axes repeat, twisted ones mirror the other two.
    const T& point(int i, int j, int k) const
    {
        const Knots::WrappedIndex u = axes[0].wrapped(i), v = axes[1].wrapped(j),
                                  w = axes[2].wrapped(k);
        const bool flip_u = v.mirrored != w.mirrored, flip_v = u.mirrored != w.mirrored,
                   flip_w = u.mirrored != v.mirrored;
        return points[index(flip_u ? axes[0].count() - 1 - u.index : u.index,
                            flip_v ? axes[1].count() - 1 - v.index : v.index,
                            flip_w ? axes[2].count() - 1 - w.index : w.index)];
    }
    bool operator==(const Trivariate&) const = default;
};

// A Jet is the value, gradient (d/du, d/dv, d/dw) and second derivatives (uu, vv, ww, uv, vw, wu)
// at a point.
template <class T> struct Jet {
    T value{};
    std::array<T, 3> first{};
    std::array<T, 6> second{};
};

// The jet at uvw, brought into the domain; `derivatives` 0, 1 or 2 says how many are computed.
// O(order^3). It is the reference against which every faster evaluator is tested.
template <class T> Jet<T> evaluate(const Trivariate<T>& f, glm::dvec3 uvw, int derivatives = 0);

template <class T> Jet<T> evaluate(const Trivariate<T>& f, glm::dvec3 uvw, int derivatives)
{
    // A twisted axis that was gone round an odd number of times mirrors the other two.
    glm::dvec3 t = uvw;
    glm::dvec3 sign(1);
    for (int axis = 0; axis < 3; ++axis) {
        const Knots& knots = f.axes[static_cast<std::size_t>(axis)];
        const Knots::InDomain in = knots.into_domain(t[axis]);
        t[axis] = in.t;
        if (!in.odd) continue;
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            const Knots& k = f.axes[static_cast<std::size_t>(other)];
            t[other] = k.begin() + k.end() - t[other];
            sign[other] = -sign[other];
        }
    }
    for (int axis = 0; axis < 3; ++axis)
        t[axis] = f.axes[static_cast<std::size_t>(axis)].into_domain(t[axis]).t;

    const std::array<Basis, 3> b{basis(f.axes[0], t.x, derivatives),
                                 basis(f.axes[1], t.y, derivatives),
                                 basis(f.axes[2], t.z, derivatives)};
    // Stored positions once an axis; only a twisted axis makes them depend on each other.
    std::array<std::array<std::size_t, max_order>, 3> offset{};
    bool twisted = false;
    for (std::size_t axis = 3, stride = 1; axis-- > 0;) {
        const Knots& knots = f.axes[axis];
        for (int i = 0; i < knots.order(); ++i)
            offset[axis][static_cast<std::size_t>(i)] =
                static_cast<std::size_t>(knots.wrapped(b[axis].first + i).index) * stride;
        stride *= static_cast<std::size_t>(knots.count());
        twisted = twisted || knots.closure() == Closure::twisted;
    }

    // Contracts over w, then v, then u; derivatives that are not asked for cost nothing.
    Jet<T> jet;
    for (int i = 0; i < f.axes[0].order(); ++i) {
        T plane{}, plane_v{}, plane_w{}, plane_vv{}, plane_ww{}, plane_vw{};
        for (int j = 0; j < f.axes[1].order(); ++j) {
            T line{}, line_w{}, line_ww{};
            for (int k = 0; k < f.axes[2].order(); ++k) {
                const auto K = static_cast<std::size_t>(k);
                const T& p = twisted
                                 ? f.point(b[0].first + i, b[1].first + j, b[2].first + k)
                                 : f.points[offset[0][static_cast<std::size_t>(i)] +
                                            offset[1][static_cast<std::size_t>(j)] + offset[2][K]];
                line = line + p * b[2].value[K];
                if (derivatives > 0) line_w = line_w + p * b[2].first_derivative[K];
                if (derivatives > 1) line_ww = line_ww + p * b[2].second_derivative[K];
            }
            const auto J = static_cast<std::size_t>(j);
            const double v = b[1].value[J], v1 = b[1].first_derivative[J];
            plane = plane + line * v;
            if (derivatives > 0) {
                plane_v = plane_v + line * v1;
                plane_w = plane_w + line_w * v;
            }
            if (derivatives > 1) {
                plane_vv = plane_vv + line * b[1].second_derivative[J];
                plane_vw = plane_vw + line_w * v1;
                plane_ww = plane_ww + line_ww * v;
            }
        }
        const auto I = static_cast<std::size_t>(i);
        const double u = b[0].value[I], u1 = b[0].first_derivative[I];
        jet.value = jet.value + plane * u;
        if (derivatives > 0) {
            jet.first[0] = jet.first[0] + plane * (sign.x * u1);
            jet.first[1] = jet.first[1] + plane_v * (sign.y * u);
            jet.first[2] = jet.first[2] + plane_w * (sign.z * u);
        }
        if (derivatives > 1) {
            jet.second[0] = jet.second[0] + plane * b[0].second_derivative[I];
            jet.second[1] = jet.second[1] + plane_vv * u;
            jet.second[2] = jet.second[2] + plane_ww * u;
            jet.second[3] = jet.second[3] + plane_v * (sign.x * sign.y * u1);
            jet.second[4] = jet.second[4] + plane_vw * (sign.y * sign.z * u);
            jet.second[5] = jet.second[5] + plane_w * (sign.z * sign.x * u1);
        }
    }
    return jet;
}

} // namespace trivar
