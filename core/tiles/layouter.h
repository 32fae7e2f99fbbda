// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/tiles/layout.h"

#include <memory>

namespace trivar {

// Lays the tiles of strokes, in their order. Pure: a tile's seed comes from its stroke and its
// number in it, so that editing one stroke leaves the tiles of others, except where they avoid each
// other.
//   progress   its throw ends the work
//   curvature  of the base, asked for where tiles head along it; null: it is estimated then
// About 5 us per try. Throws Cancelled.
TileLayout layout_of(const TileBase& base, const std::vector<Ref<TileStroke>>& strokes,
                     const Progress& progress = {}, const Lazy<TileCurvature>* curvature = nullptr);

// A Layouter lays the strokes of a layer again and again, and gives the same as layout_of(). It
// keeps the state at the begin of the last strokes, so that a change of these costs only their own
// tiles; a growing stroke that scatters tiles, only the new part. Layouts share the runs of tiles
// that stayed. Not thread-safe.
class Layouter {
public:
    Layouter();
    ~Layouter();
    TileLayout operator()(const Ref<TileBase>& base, const std::vector<Ref<TileStroke>>& strokes,
                          const Progress& progress = {},
                          const Lazy<TileCurvature>* curvature = nullptr);

private:
    class Work;
    Ref<TileBase> base_;
    std::unique_ptr<Work> work_; // null: none that is sound
};

} // namespace trivar
