// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace trivar {

// A LevelRing is the polygon in which a level cuts a tetrahedron, as the edges that it meets in
// turn: each from a corner above the level to one below [Doi, Koide, 1991].
//
//        0               0 above: 0-1, 0-2, 0-3
//       /|\              0, 1 above: 0-2, 0-3, 1-3, 1-2
//      1-+-3
//       \|/
//        2
struct LevelRing {
    struct Edge {
        std::size_t above, below; // corners, 0 .. 3
    };
    std::array<Edge, 4> edges{};
    std::size_t size = 0; // 0, 3 or 4
    bool odd = false;     // whether corners below before those above are an odd permutation
};

// The ring of a tetrahedron by what corner is above.
inline LevelRing level_ring(const std::array<bool, 4>& is_above)
{
    std::array<std::size_t, 4> above{}, below{};
    std::size_t up = 0, down = 0;
    LevelRing out;
    for (std::size_t k = 0; k < 4; ++k)
        if (is_above[k]) {
            above[up++] = k;
            out.odd = out.odd != (down % 2 == 1); // steps over so many that are below
        } else
            below[down++] = k;
    const auto edge = [&](std::size_t a, std::size_t b) {
        out.edges[out.size++] = {above[a], below[b]};
    };
    for (std::size_t i = 0; i < 3 && up == 1; ++i) edge(0, i);
    for (std::size_t i = 0; i < 3 && up == 3; ++i) edge(i, 0);
    if (up == 2) edge(0, 0), edge(0, 1), edge(1, 1), edge(1, 0);
    return out;
}

} // namespace trivar
