// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/objects/set_shape.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/voxel_fields.h"

namespace trivar {

// Throws Rejected for volume data without a file, or with more levels than can be shown.
void check(const VoxelShape& shape);
std::string size_words(const VoxelShape& shape);

using AddVoxels = AddShape<VoxelShape>;

template <> struct SetWords<VoxelShape> {
    static constexpr std::string_view verb = "set_volume",
                                      summary = "Change volume data in place: its file, how it is "
                                                "read as a function, the levels that are shown.",
                                      help = "id of volume data";
};
using SetVoxels = SetShape<VoxelShape>;
StepTitle title_of_change(const VoxelShape* before, const VoxelShape& now, const std::string& name);

} // namespace trivar
