// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/mesh/node_parts.h"

#include <functional>
#include <vector>

namespace trivar {

// Chooses the moments that get a key: the first, the last, and as few as possible between them.
//   count  number of moments
//   holds  whether no key is needed between two moments
// The distance asked for is doubled while the answer is yes and then bisected: O(log distance)
// questions per key.
std::vector<std::size_t> chosen_keys(std::size_t count,
                                     const std::function<bool(std::size_t, std::size_t)>& holds);

// The largest single-precision number that is not after a time; and the smallest that is not before
// it.
float not_after(double time_s);
float not_before(double time_s);

// The mixture of two transforms as a viewer makes it: rotations go the shorter way round.
NodeTransform between_parts(const NodeTransform& a, const NodeTransform& b, double share);

// The channels of a node that moves by the given matrices at the given times. The keys are such
// that at none of these times a corner of the box is further off than a tolerance. Empty where a
// matrix shears.
struct NodeMotion {
    std::vector<Channel> channels; // empty where the node rests
    NodeTransform first;
    std::size_t keys = 1;
    double off = 0; // largest distance of a corner at those times
};
std::optional<NodeMotion> node_motion(int node, const std::vector<glm::dmat4>& matrices,
                                      const std::vector<float>& times_s, const Box& box,
                                      double tolerance);

} // namespace trivar
