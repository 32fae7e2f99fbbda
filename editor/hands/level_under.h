// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/shown_volume.h"
#include "editor/session/session.h"

#include <optional>

namespace trivar {

// Returns the shown volume data of an object; null: it has none, or is not evaluated.
const ShownVolume* shown_volume_of(const Session& session, Id id);

// The level, by its number in the document, of which a line goes by a point of the picture at most
// `reach_px` away; the nearest. Finds all lines anew: as long as a picture of them.
std::optional<int> level_under(const Session& session, Id id, glm::dvec2 at_px, double reach_px);

} // namespace trivar
