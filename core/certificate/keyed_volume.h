// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/shaper.h"

#include <optional>

namespace trivar {

// The largest distance, at any time between two frames, of a track from the straight line between
// its values at both frames; infinite beyond a range to whose ends values are limited. The convex
// hulls of the track's pieces bound it. O(#keys between).
double off_chord(const Track& track, double from_frame, double to_frame, double lo, double hi);

// A KeyedVolume is a volume whose last step of shaping moves control points by keys. The points
// move as the keys do: each along a constant direction, as long as the guard takes nothing back.
class KeyedVolume {
public:
    // Whether a track of the object belongs to such a step. Only an object that rests on nothing
    // but its stroke has one.
    static bool is_of_it(const Object& object, const Track& track);
    // Empty: the object has no such keys.
    static std::optional<KeyedVolume> of(const Object& object);

    struct Change {
        double uneven = 0;  // metres; no control point is further than this from moving evenly
        glm::dvec3 turn{0}; // largest change of the derivatives of F by u, v and w
    };
    // The change from one frame to another; empty: the guard may act between them. `slopes` are, at
    // both frames, at least as large as the derivatives of F by u, v and w.
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
