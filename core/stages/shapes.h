// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/document/asset_store.h"
#include "core/mesh/height_sheet.h"
#include "core/placement/round.h"
#include "core/stages/shape.h"
#include "core/stages/voxel_shapes.h"
#include "core/text/installed_fonts.h"

namespace trivar {

// The font of a text; the name of its file may be relative to the scene's folder. Throws Rejected
// where no font is found at all.
FoundFont font_of(const TextShape& text, const AssetStore& assets);

// The sheet of a shape, without its picture.
HeightSheet sheet_of(const HeightShape& shape);

// Shapes keeps shapes by their source: two objects with equal sources share one shape.
class Shapes {
public:
    explicit Shapes(Ref<AssetStore> assets) : assets_(std::move(assets)) {}

    // The shape of a source, never null. Trouble is told in the shape's notices; a missing file is
    // tried again next time. Throws Cancelled. Stages: import, subdivide, letters.
    Ref<Shape> operator()(const Source& source, Timings& timings, const Progress& progress);
    void forget_unused(); // the shapes that nobody else holds

private:
    Ref<AssetStore> assets_;
    VoxelShapes voxels_;
    std::vector<std::pair<Source, Ref<Shape>>> known_;
};

} // namespace trivar
