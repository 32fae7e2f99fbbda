// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/evaluate.h"

#include <optional>

namespace trivar {

// How far a track is at any time between two frames from going evenly from its value at the one to
// that at the other; infinite beyond a range to whose ends values are taken. By the convex hulls of
// its pieces. O(#keys between).
double off_chord(const Track& track, double from_frame, double to_frame, double lo, double hi);

// A volume the last step of whose shaping moves control points by keys. They go as the keys do:
// what moves is a constant direction each, as long as the guard takes nothing back.
class KeyedVolume {
public:
    // Whether a track of the object is of such a step; what rests on its stroke alone has one.
    static bool is_of_it(const Object& object, const Track& track);
    // Nothing: it has no such keys.
    static std::optional<KeyedVolume> of(const Object& object);

    struct Change {
        double uneven = 0;  // metres: no control point is further from going evenly
        glm::dvec3 turn{0}; // of how much F changes, no longer is the derivative by u, v, w
    };
    // From one frame to another; nothing: the guard may act between. `slopes` are at both no less
    // than those of F by u, v and w.
    std::optional<Change> change(const EvaluatedObject& from, double from_frame,
                                 const EvaluatedObject& to, double to_frame,
                                 const glm::dvec3& slopes);

private:
    struct Moving {
        Track track;
        double lo, hi;
    };
    std::vector<Moving> moving_;
    bool guarded_ = true;
    std::optional<Change> changed(const ShapedVolume& from, double from_frame,
                                  const ShapedVolume& to, double to_frame,
                                  const glm::dvec3& slopes) const;
    struct Step {
        Ref<ShapedVolume> from, to;
        double from_frame;
        bool operator==(const Step&) const = default;
    };
    Recent<Step, std::optional<Change>> changes_{1};
};

} // namespace trivar
