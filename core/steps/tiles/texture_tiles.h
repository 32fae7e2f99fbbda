// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/stages/tiled_base.h"
#include "core/tiles/layout.h"
#include "core/tiles/tile_cover.h"

namespace trivar {

// A TextureLayout places the tiles of a cover by texture on their base at rest.
struct TextureLayout {
    std::vector<Tile> tiles; // they count as painted within a second, from the lowest row up
    bool too_many = false;
    std::vector<std::string> notices;
};

// One tile for every cell of the texture square whose centre is on the surface, with its X along u.
// Each has a chart of its own, so that no seam cuts it; of two that would stand in one place, as
// along a seam, the first stays.
class TextureTiles {
public:
    // `base` holds the triangles of the pieces, or those of their limit surface.
    Ref<TextureLayout> operator()(const TiledPieces& pieces, const Ref<TileBase>& base, bool limit,
                                  const TileCover& cover);

private:
    struct Input {
        TiledPieces pieces;
        Ref<TileBase> base;
        bool limit;
        TileCover cover;
        bool operator==(const Input&) const = default;
    };
    Kept<Input, Ref<TextureLayout>> known_;
};

// The tiles that strokes have laid, and behind them the others.
TileLayout joined(const TileLayout& painted, const TextureLayout& by_texture);

} // namespace trivar
