// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tiles.h"
#include "editor/session/session.h"

#include <optional>

namespace trivar {

// A length of tiles of which about 25 lie along an object, metres on its model; 0: it shows
// nothing.
double usual_tile_length(const Session& session, Id base);

// The cover that the selection says: of two objects the first one becomes the tile and the active
// one is covered, in a grid. Nothing: it does not say.
std::optional<CoverWithTiles> cover_wish(const Session& session);

} // namespace trivar
