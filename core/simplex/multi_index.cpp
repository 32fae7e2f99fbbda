// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/multi_index.h"

namespace trivar {
namespace {

constexpr std::size_t number_of(int corners, int degree)
{
    // ways to share out a number among that many: (degree + corners - 1 over degree)
    std::size_t out = 1;
    for (int i = 1; i <= degree; ++i)
        out = out * static_cast<std::size_t>(corners - 1 + i) / static_cast<std::size_t>(i);
    return out;
}

template <int S, int Degree> constexpr auto listed()
{
    std::array<MultiIndex<S>, number_of(S + 1, Degree)> out{};
    std::size_t n = 0;
    for (int a = Degree; a >= 0; --a)
        for (int b = Degree - a; b >= 0; --b) {
            if constexpr (S == 2)
                out[n++] = {a, b, Degree - a - b};
            else
                for (int c = Degree - a - b; c >= 0; --c) out[n++] = {a, b, c, Degree - a - b - c};
        }
    return out;
}

template <int S, int Degree> constexpr auto list = listed<S, Degree>();

} // namespace

template <int S> std::span<const MultiIndex<S>> multi_indices(int degree)
{
    if (degree == 1) return list<S, 1>;
    if (degree == 2) return list<S, 2>;
    return list<S, 3>;
}

template std::span<const MultiIndex<2>> multi_indices<2>(int);
template std::span<const MultiIndex<3>> multi_indices<3>(int);

} // namespace trivar
