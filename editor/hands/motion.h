// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <vector>

namespace trivar {

enum class MotionKind { move, rotate, scale };

// A Motion is what a gesture does, along and about the three axes that each object has.
struct Motion {
    MotionKind kind = MotionKind::move;
    glm::dvec3 offset{0};          // move: along each axis, metres
    double angle_deg = 0;          // rotate: degrees, right-handed
    glm::dvec3 turn_axis{0, 0, 1}; // rotate: unit, by components along the axes
    glm::dvec3 factors{1};         // scale: along each axis, never 0
    bool is_nothing() const;
};

// A Stand is the state of an object when a gesture begins.
struct Stand {
    Id id = 0;
    Transform transform;
    glm::dmat4 parent_to_world{1};
    glm::dvec3 origin_world() const;
    glm::dmat3 axes_world() const; // its own three axes, unit and at right angles
};

// The topmost of those objects that can be moved freely: an object on a stroke is where the stroke
// is, and a locked one stays.
std::vector<Stand> stands_of(const Document& document, const std::vector<Id>& ids);

// A MotionFrame says about which point and along which axes a motion goes, in the world.
struct MotionFrame {
    glm::dvec3 pivot{0};
    glm::dmat3 axes{1}; // columns, unit and at right angles
};

// The object's transform after the motion. A move keeps rotation and scale to the last bit, a turn
// keeps the scale, and scaling keeps the rotation: where it would shear, the object is scaled along
// its own axes by as much as these grow.
Transform moved(const Stand& stand, const Motion& motion, const MotionFrame& frame);

// One step for several objects; for a single one the plain command.
Command arranged(const std::vector<Id>& ids, const std::vector<Transform>& transforms);

} // namespace trivar
