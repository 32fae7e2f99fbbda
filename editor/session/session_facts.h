// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <vector>

namespace trivar {

// The box round an object, with what is in it if it is a group, or round everything for id 0.
Box bounds_of(const Session& session, Id id);
Box bounds_of(const Session& session, const std::vector<Id>& ids);
// All vertices of these objects, and the control points of lattices, in world space; where there is
// none, of everything but what is left aside.
std::vector<glm::dvec3> points_of(const Session& session, const std::vector<Id>& ids);

// What the window shows now, in the shape that the view of pictures has already, if it is kept.
Camera camera_for_pictures(const Session& session);

} // namespace trivar
