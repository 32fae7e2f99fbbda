// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

namespace trivar {

// A NodeTransform is an affine transform in parts: first the scale, then the rotation, then the
// translation.
struct NodeTransform {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0}; // unit
    glm::dvec3 scale{1};
    glm::dmat4 matrix() const;
    bool operator==(const NodeTransform&) const = default;
};

// A Channel says how one property of a node changes in time (glTF 2.0, 3.11).
struct Channel {
    enum class Of { translation, rotation, scale, morph_weights };
    enum class Interpolation { step, linear, cubic }; // cubic: Hermite
    int node = 0;                                     // index into Model::nodes
    Of of = Of::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times_s; // of the keys, ascending; at least one
    // `components` numbers per key; for cubic three times as many: tangent in, value, tangent out.
    // Rotations are x, y, z, w.
    std::vector<float> values;
    std::size_t components = 3;
};

// A Clip is a movement that a model makes by itself: a walk, a jump.
struct Clip {
    std::string name; // unique in its model
    std::vector<Channel> channels;
    double begin_s = 0, end_s = 0; // times of its first and last keys
};

// Four numbers whose length is at most this are no rotation.
inline constexpr double least_rotation = 1e-9;

// The channel's value at a time; before the first key that key's value, after the last one that
// one's. Rotations go the shorter way round and are unit; where a key gives no rotation it is the
// identity. O(log #keys).
std::vector<double> value_at(const Channel& channel, double time_s);

} // namespace trivar
