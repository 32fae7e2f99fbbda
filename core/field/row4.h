// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

namespace trivar {

// A Row4 is four numbers in one register, added and multiplied at once (a vector of GCC and Clang).
template <class Real> struct Row4Of {
    using type __attribute__((vector_size(4 * sizeof(Real)))) = Real;
};
template <class Real> using Row4 = typename Row4Of<Real>::type;

template <class Real> inline Row4<Real> row4(const Real* p) // the four from p on, not aligned
{
    Row4<Real> out;
    std::memcpy(&out, p, sizeof out);
    return out;
}

template <class Row> inline auto dot(const Row& a, const Row& b)
{
    const Row p = a * b;
    return (p[0] + p[1]) + (p[2] + p[3]);
}

// Four sums like dot(), of products.
template <class Row> inline Row four_sums(const Row& a, const Row& b, const Row& c, const Row& d)
{
    const Row ab01 = __builtin_shufflevector(a, b, 0, 4, 1, 5),
              ab23 = __builtin_shufflevector(a, b, 2, 6, 3, 7),
              cd01 = __builtin_shufflevector(c, d, 0, 4, 1, 5),
              cd23 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    return (__builtin_shufflevector(ab01, cd01, 0, 1, 4, 5) +
            __builtin_shufflevector(ab01, cd01, 2, 3, 6, 7)) +
           (__builtin_shufflevector(ab23, cd23, 0, 1, 4, 5) +
            __builtin_shufflevector(ab23, cd23, 2, 3, 6, 7));
}

} // namespace trivar
