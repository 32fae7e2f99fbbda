// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/mesh/pose.h"

#include <optional>

namespace trivar {

// The largest coordinate that is accepted, in metres: products of two lengths then stay within
// single precision, which ends near 3e38.
inline constexpr double most_coordinate = 1e15;
inline constexpr const char* too_large_words = "too large (beyond 1e15 m from the origin)";

// Whether the whole of a box is within most_coordinate after a matrix, and every number of the
// matrix small enough. True for an empty box.
bool within_reach(const Box& box, const glm::dmat4& matrix = glm::dmat4(1));

// An Extent tells how far out the vertices of a mesh are, in any pose.
class Extent {
public:
    explicit Extent(const Ref<Mesh>& mesh); // O(#V)
    // Takes over the extent of a mesh that differs only in the places of some vertices, and the box
    // round all vertices of `mesh`. O(1).
    Extent(const Ref<Mesh>& mesh, const Extent& other, const Box& box);

    // A box that holds the mesh in a pose; null: in the pose of its file. Empty where a vertex is
    // out of range or one of its numbers is not finite. O(#joints + #targets), and O(#V) only where
    // that cannot decide.
    std::optional<Box> posed(const Pose* pose) const;

private:
    Ref<Mesh> mesh_;
    Box box_;
    bool finite_ = true;
    Lazy<std::vector<Box>> targets_;
};

// Whether a mesh or a curve that hangs on a node of the model is out of range there, in the file's
// pose.
bool too_large(const Model& model);

} // namespace trivar
