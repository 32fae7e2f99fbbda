// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace trivar {

// A MultiIndex says how many knots beyond the first a basis function takes from each corner of its
// cell; they sum to the degree. For degree 2 in a triangle, as the Bezier control net:
//
//             (0,0,2)
//             /     \          Bezier point b of a polynomial rests at the barycentric
//        (1,0,1)--(0,1,1)      coordinates b / 2,
//         /   \    /   \       b = (i, j, k)
//   (2,0,0)--(1,1,0)--(0,2,0)
template <int S> using MultiIndex = std::array<int, S + 1>;

// All multi-indices of a degree (1..3), in lexicographic order: 3, 6, 10 of them for S = 2 and 4,
// 10, 20 for S = 3.
template <int S> std::span<const MultiIndex<S>> multi_indices(int degree);

} // namespace trivar
