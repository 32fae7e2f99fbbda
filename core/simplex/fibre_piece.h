// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

// The simplices into which core/simplex/fibre_clipping.h cuts.

namespace trivar {
namespace fibre_detail {

template <int N> struct Corner {
    glm::vec<N, double> mu{0};
    std::uint32_t planes = 0; // those on which it lies
};
template <int N> using Piece = std::array<Corner<N>, N + 1>;

template <int N> double content(const Piece<N>& p)
{
    if constexpr (N == 1)
        return std::abs(p[1].mu.x - p[0].mu.x);
    else if constexpr (N == 2) {
        const glm::dvec2 a = p[1].mu - p[0].mu, b = p[2].mu - p[0].mu;
        return std::abs(a.x * b.y - a.y * b.x) / 2;
    } else
        return std::abs(
                   glm::dot(p[1].mu - p[0].mu, glm::cross(p[2].mu - p[0].mu, p[3].mu - p[0].mu))) /
               6;
}

// Returns the content of the facet opposite to a corner.
template <int N> double facet_content(const Piece<N>& p, std::size_t opposite)
{
    if constexpr (N == 1)
        return 1;
    else if constexpr (N == 2)
        return glm::distance(p[(opposite + 1) % 3].mu, p[(opposite + 2) % 3].mu);
    else {
        const glm::dvec3 a = p[(opposite + 1) & 3].mu, b = p[(opposite + 2) & 3].mu,
                         c = p[(opposite + 3) & 3].mu;
        return glm::length(glm::cross(b - a, c - a)) / 2;
    }
}

} // namespace fibre_detail
} // namespace trivar
