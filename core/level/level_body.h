// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/field_hulls.h"
#include "core/field/level_side.h"

namespace trivar {

// A LevelBody is the body on one side of a level of a field. It hides points behind it.
struct LevelBody {
    const ScalarField<float>& field;
    const FieldHulls& hulls;
    float level;
    LevelSide side = LevelSide::above;
    // It is looked at between these slices alone, voxels: of a slab.
    float low = -1e30f, high = 1e30f;
};

} // namespace trivar
