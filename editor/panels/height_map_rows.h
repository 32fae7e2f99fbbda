// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/height_map.h"
#include "ui/widgets.h"

namespace trivar {

// A list of shapes to begin with and, where the height changes over the strip, its surface, the
// size of the grid and the number of the chosen point. `size_world` is what the factors multiply,
// metres; 0: not known yet.
ui::Edit draw_height_map(const ui::Theme& theme, const std::string& help, double size_world,
                         HeightGrid& grid, int& chosen);

} // namespace trivar
