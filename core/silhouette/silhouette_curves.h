// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/scalar_field.h"
#include "core/silhouette/edge_chains.h"
#include "core/silhouette/silhouettes.h"

#include <span>

namespace trivar {

// Returns the corners of a triangle that have a product of at least 0, one bit each.
inline unsigned signs_of(const std::uint32_t* corners, const float* product)
{
    return unsigned{product[corners[0]] >= 0} | unsigned{product[corners[1]] >= 0} << 1 |
           unsigned{product[corners[2]] >= 0} << 2;
}

// Adds a triangle if a product changes its sign in it.
inline void add_crossed(const std::uint32_t* corners, unsigned signs,
                        std::vector<CrossedTriangle>& out)
{
    if (signs == 0 || signs == 7) return;
    constexpr std::array<std::uint8_t, 8> alone{0, 0, 1, 2, 2, 1, 0, 0}; // corner
    const unsigned i = alone[signs];
    const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
    out.push_back({edge_key(a, b), edge_key(a, c)});
}

// Makes curves of chains of edges, at the places on these where the product is 0. Points that are
// nearer to the last one than the spacing are left out; ends stay, and three points of a loop.
Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> positions,
                      std::span<const float> product, float spacing);

// The same with the places, one for each edge of the chains.
Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> places, float spacing);
// The place where a line crosses an edge, of the products at its ends.
glm::vec3 place_on_edge(const glm::vec3& a, const glm::vec3& b, float product_a, float product_b);

// Moves the points to the spline, if that is wished, and sets their other values.
void finish(const ScalarField<float>& field, float level, const ViewPoint& view,
            const SilhouetteOptions& options, Silhouettes& out);

// Whether both ends of an edge of a level are in one face of a grid, 0 or `end` along an axis.
bool are_in_a_face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& end);

// Throws Rejected if a view has neither a direction nor an eye.
void check(const ViewPoint& view);

} // namespace trivar
