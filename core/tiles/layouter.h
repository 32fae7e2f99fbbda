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

// A Layouter works off the strokes of a layer again and again, and gives the same as layout_of().
// It keeps where the last strokes began, so that a change of these costs what they lay themselves;
// of a stroke that scatters tiles and goes on, what is new. Layouts have the runs of tiles in
// common that stayed. Not thread-safe.
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
