// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <vector>

namespace trivar {

enum class MotionKind { move, rotate, scale };

// What a gesture does, along and about three axes that each object knows of its own.
struct Motion {
    MotionKind kind = MotionKind::move;
    glm::dvec3 offset{0};          // move: along each axis, metres
    double angle_deg = 0;          // rotate: right-handed
    glm::dvec3 turn_axis{0, 0, 1}; // rotate: unit, in terms of the axes
    glm::dvec3 factors{1};         // scale: along each axis, none is 0
    bool is_nothing() const;
};

// An object as a gesture finds it.
struct Stand {
    Id id = 0;
    Transform transform;
    glm::dmat4 parent_to_world{1};
    glm::dvec3 origin_world() const;
    glm::dmat3 axes_world() const; // its own three, unit and at right angles
};

// The topmost of the objects that stand freely: what lies on a stroke is where the stroke is, and
// what is locked stays.
std::vector<Stand> stands_of(const Document& document, const std::vector<Id>& ids);

// What a motion is about, in the world.
struct MotionFrame {
    glm::dvec3 pivot{0};
    glm::dmat3 axes{1}; // columns, unit and at right angles
};

// The object's transform after the motion. A move keeps rotation and scale to the bit, a turn the
// scale, and scaling the rotation: what would shear is scaled along the object's own axes by how
// much those grow.
Transform moved(const Stand& stand, const Motion& motion, const MotionFrame& frame);

// One step for several objects: the plain command where it is only one.
Command arranged(const std::vector<Id>& ids, const std::vector<Transform>& transforms);

} // namespace trivar
