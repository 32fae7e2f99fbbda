// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/mesh/pose.h"

#include <optional>

namespace trivar {

// No place that is worked with is further out along an axis, in metres: products of two lengths
// then keep to single precision, which ends near 3e38.
inline constexpr double most_coordinate = 1e15;
inline constexpr const char* too_large_words =
    "too large to be worked with (beyond 1e15 m from the origin)";

// Whether all of a box is within that where a matrix takes it, and none of its numbers is too
// large. An empty box is.
bool within_reach(const Box& box, const glm::dmat4& matrix = glm::dmat4(1));

// How far out the vertices of a mesh are, whichever pose it takes.
class Extent {
public:
    explicit Extent(const Ref<Mesh>& mesh); // O(#V)

    // A box that holds the mesh in a pose; null: as it came. Nothing where a vertex is out of reach
    // or a number that goes with it is none. O(#joints + #targets), and O(#V) only where that
    // leaves it open.
    std::optional<Box> posed(const Pose* pose) const;

private:
    Ref<Mesh> mesh_;
    Box box_;
    bool finite_ = true;
    Lazy<std::vector<Box>> targets_;
};

// Whether a mesh or a curve that hangs on a node of the model is out of reach there, as it came.
bool too_large(const Model& model);

} // namespace trivar
