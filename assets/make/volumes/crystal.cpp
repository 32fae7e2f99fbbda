// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/density.h"

#include <algorithm>

namespace make {

// Silicon: two lattices of face-centred cubes, a quarter of a diagonal apart, and each atom bound
// to four of the other. Whole atoms only, so that a level is closed within the grid.
Volume silicon()
{
    constexpr float cell = 5.431f;
    constexpr int cells = 2;
    Density out({100, 100, 100}, vec3(-.3f * cell), .1426f);
    static constexpr vec3 faces[]{{0, 0, 0}, {0, .5f, .5f}, {.5f, 0, .5f}, {.5f, .5f, 0}},
        to_neighbours[]{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const auto within = [](vec3 p) {
        return glm::all(glm::greaterThan(p, vec3(-.01f))) &&
               glm::all(glm::lessThan(p, vec3(cells + .01f)));
    };
    const auto bound = [&](vec3 corner) {
        return std::ranges::any_of(to_neighbours,
                                   [&](vec3 to) { return within(corner + .25f * to); });
    };
    constexpr float atom_electrons = 2.3f, bond_electrons = 1.1f;
    for (int i = 0; i < (cells + 1) * (cells + 1) * (cells + 1); ++i)
        for (const vec3& face : faces) {
            const vec3 corner = vec3(i % (cells + 1), i / (cells + 1) % (cells + 1),
                                     i / (cells + 1) / (cells + 1)) +
                                face;
            if (within(corner) && bound(corner)) out.add(cell * corner, atom_electrons, .5f);
            const vec3 inner = corner + .25f;
            if (!within(inner)) continue;
            out.add(cell * inner, atom_electrons, .5f);
            for (const vec3& to : to_neighbours)
                if (within(inner - .25f * to))
                    out.add_bond(cell * inner, cell * (inner - .25f * to), bond_electrons, .66f,
                                 .36f);
        }
    return out.scaled(1000);
}

} // namespace make
