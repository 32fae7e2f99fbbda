// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/mesh/clip.h"

#include <functional>
#include <optional>
#include <vector>

namespace trivar {

// The moments at which something gets a key, of `count`: the first one, the last one, and as few as
// it takes between when each is as far behind the one before as `holds(from, to)` lets it: asked
// twice as far while it holds, then between. O(log) of the way for each key.
std::vector<std::size_t> chosen_keys(std::size_t count,
                                     const std::function<bool(std::size_t, std::size_t)>& holds);

// The number in single precision that is nearest to a time and not after it, or not before it.
float not_after(double time_s);
float not_before(double time_s);

// An affine matrix as its parts; nothing where they do not give it, as when it shears.
std::optional<NodeTransform> as_parts(const glm::dmat4& matrix);
// Between two, as a viewer has it: rotations the shorter way round.
NodeTransform between_parts(const NodeTransform& a, const NodeTransform& b, double share);

// Channels of a node that moves by these matrices at these times: keys so that the corners of a box
// are nowhere further off than a tolerance at any of the times. Nothing where a matrix shears.
struct NodeMotion {
    std::vector<Channel> channels; // none where it rests
    NodeTransform first;
    std::size_t keys = 1;
    double off = 0; // at most, of the corners at those times
};
std::optional<NodeMotion> node_motion(int node, const std::vector<glm::dmat4>& matrices,
                                      const std::vector<float>& times_s, const Box& box,
                                      double tolerance);

} // namespace trivar
