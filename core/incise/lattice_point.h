// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_skin.h"

namespace trivar {

// The number of steps along each side of a triangle: points of cuts lie on a lattice of whole
// numbers. A coarse lattice is better than a fine one: nearly equal points or lines become equal.
inline constexpr int lattice_steps = 1024;

// A LatticePoint is a point of the skin, named by the smallest thing that it lies on, so that every
// triangle round it gives it the same numbers.
//
//      2
//      |\            four steps in place of 1024: p lies in the triangle, with
//      | \           b = 1 (weight 1/4 of corner 1) and c = 2 (2/4 of corner 2);
//      | p\          q lies on the edge, 3 steps from its end 0
//      0--q1
struct LatticePoint {
    enum class On : char { point, edge, triangle } on = On::point;
    std::uint32_t index = 0; // point, lower side of the edge, or triangle of the skin
    // On an edge: steps from the end with the lower number. In a triangle: weights of the corners 1
    // and 2 in steps.
    int b = 0, c = 0;
    bool operator==(const LatticePoint&) const = default;
};

// The point of a triangle with those weights of its corners 1 and 2, in steps.
LatticePoint lattice_point(const SlitSkin& skin, std::uint32_t triangle, glm::ivec2 weights);
// The lattice point nearest to a place.
LatticePoint nearest_lattice_point(const SlitSkin& skin, const SkinPlace& place);
// Its weights of the corners 1 and 2 in a triangle that it belongs to; none in others.
std::optional<glm::ivec2> weights_in(const SlitSkin& skin, const LatticePoint& p,
                                     std::uint32_t triangle);
// All triangles that it belongs to.
std::vector<std::uint32_t> triangles_round(const SlitSkin& skin, const LatticePoint& p);
std::uint64_t key_of(const LatticePoint& p);

// A Blend is a point as a mean of points of the skin. An edge's is the same from both its sides.
struct Blend {
    glm::uvec3 of{0};
    glm::dvec3 weights{1, 0, 0};

    template <class Value> auto operator()(const Value& value) const // value(point)
    {
        auto sum = weights.x * value(of.x);
        if (weights.y != 0) sum += weights.y * value(of.y);
        if (weights.z != 0) sum += weights.z * value(of.z);
        return sum;
    }
};
Blend blend_of(const SlitSkin& skin, const LatticePoint& p);
glm::dvec3 position(const SlitSkin& skin, const LatticePoint& p);

} // namespace trivar
