// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/laid_tiles.h"
#include "core/tiles/tile_stroke.h"

namespace trivar {

// Lists the triangles of a base that a fill covers, ascending; `path` is not empty. O(#triangles).
std::vector<std::uint32_t> filled_triangles(const TileBase& base, TileArea area,
                                            const std::vector<StrokeStep>& path);

} // namespace trivar
