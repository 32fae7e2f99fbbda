// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/simplify/decimation.h"

#include <array>

namespace trivar {

using VertexPlaces = std::vector<std::vector<glm::dvec3>>; // by pose, #V each

// A Proof shows, round after round, how much of a mesh and of its simplification lies within a
// distance of the other. The fans and places outlive it.
class Proof {
public:
    Proof(const Fans& fans, const VertexPlaces& places, double distance);

    // Returns the nodes of old and new triangles whose distance is not proven, ascending. Empty:
    // both meshes are within the distance in every pose. Triangles with the same surroundings as in
    // the round before are not proven again. O(#T log #T).
    std::vector<std::uint32_t> unproven_nodes(const Decimation& left);

private:
    std::vector<Box> boxes_moved(const std::vector<glm::uvec3>& now,
                                 const std::vector<glm::dvec3>& places) const;

    const Fans& fans_;
    const VertexPlaces& places_;
    double distance_;
    std::vector<glm::uvec3> last_; // #T that were left in the round before; `none`: gone
    std::vector<std::array<std::vector<char>, 2>> known_; // by pose, of both ways, #T: proven then
};

// Returns the least proven distance among `least` times powers of 1.25.
double proven_error(const Fans& fans, const Decimation& left, const VertexPlaces& places,
                    double least);

} // namespace trivar
