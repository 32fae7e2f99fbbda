// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/document/asset_store.h"
#include "core/evaluation/shape.h"
#include "core/placement/round.h"
#include "core/text/installed_fonts.h"

namespace trivar {

// The font of a text, whose file's name may be as from the scene's folder. Throws Rejected where
// there is no font at all.
FoundFont font_of(const TextShape& text, const AssetStore& assets);

// Shapes by what they come from: two objects with equal sources share one.
class Shapes {
public:
    explicit Shapes(Ref<AssetStore> assets) : assets_(std::move(assets)) {}

    // Never null; trouble is in the notices, and tried again next time if the file was missing.
    // Throws Cancelled. Stages: import, subdivide, letters.
    Ref<Shape> operator()(const Source& source, Timings& timings, const Progress& progress);
    void forget_unused(); // those that nobody else holds

private:
    Ref<AssetStore> assets_;
    std::vector<std::pair<Source, Ref<Shape>>> known_;
};

} // namespace trivar
