// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <vector>

namespace trivar {

// The box round an object and, for a group, its contents; for id 0 round the whole scene.
Box bounds_of(const Session& session, Id id);
Box bounds_of(const Session& session, const std::vector<Id>& ids);
// All vertices of these objects, and the control points of lattices, in world space; for an empty
// list, of everything that is not hidden here.
std::vector<glm::dvec3> points_of(const Session& session, const std::vector<Id>& ids);

// The camera of the window, in the shape of the kept view of pictures if there is one.
Camera camera_for_pictures(const Session& session);

// The layer whose tiles are made higher or lower by what is proposed now; 0: none.
Id heights_in_hand(const Session& session);

} // namespace trivar
