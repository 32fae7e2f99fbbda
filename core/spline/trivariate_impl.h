// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/trivariate.h"

namespace trivar {

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
    Jet<T> jet;
    for (int i = 0; i < f.axes[0].order(); ++i)
        for (int j = 0; j < f.axes[1].order(); ++j)
            for (int k = 0; k < f.axes[2].order(); ++k) {
                const T& p = f.point(b[0].first + i, b[1].first + j, b[2].first + k);
                const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j),
                           K = static_cast<std::size_t>(k);
                const double u = b[0].value[I], v = b[1].value[J], w = b[2].value[K];
                jet.value = jet.value + p * (u * v * w);
                if (derivatives < 1) continue;
                const double u1 = sign.x * b[0].first_derivative[I],
                             v1 = sign.y * b[1].first_derivative[J],
                             w1 = sign.z * b[2].first_derivative[K];
                jet.first[0] = jet.first[0] + p * (u1 * v * w);
                jet.first[1] = jet.first[1] + p * (u * v1 * w);
                jet.first[2] = jet.first[2] + p * (u * v * w1);
                if (derivatives < 2) continue;
                jet.second[0] = jet.second[0] + p * (b[0].second_derivative[I] * v * w);
                jet.second[1] = jet.second[1] + p * (u * b[1].second_derivative[J] * w);
                jet.second[2] = jet.second[2] + p * (u * v * b[2].second_derivative[K]);
                jet.second[3] = jet.second[3] + p * (u1 * v1 * w);
                jet.second[4] = jet.second[4] + p * (u * v1 * w1);
                jet.second[5] = jet.second[5] + p * (u1 * v * w1);
            }
    return jet;
}

} // namespace trivar
