// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/voxel_shape.h"
#include "core/silhouette/voxel_field.h"

namespace trivar {

// A ShownVolume is volume data with the levels that an object shows of it: what their lines are
// drawn by. A level that is hidden is not in it.
struct ShownVolume {
    struct Level {
        std::size_t number = 0; // in VoxelShape::levels
        std::string name;
        Ref<LevelMesh> mesh;
        bool lines = false;
        LineStyle ink = {};
    };
    Ref<VoxelField> field;
    LevelSide side = LevelSide::above; // of the bodies, as samples
    glm::dmat4 to_model{1};            // voxels to the object's model
    std::vector<Level> levels;
};

} // namespace trivar
