// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_stroke.h"
#include "editor/session/session.h"
#include "ui/widgets.h"

namespace trivar {

// Shows the tile of a layer from above and from the side, with the sides of its unit cell, the
// level that lies on the surface and how far it reaches into the next tiles of a strand. Lines are
// dragged; near the tile's box they snap to it. Draws nothing where no tile is shown.
ui::Edit draw_tile_cell(const Session& session, const ui::Theme& theme, Id layer, TileLook& look);

} // namespace trivar
