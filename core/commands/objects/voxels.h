// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/voxel_fields.h"

namespace trivar {

// Throws Rejected for volume data without a file, or with more levels than can be shown.
void check(const VoxelShape& shape);
std::string size_words(const VoxelShape& shape);

using AddVoxels = AddShape<VoxelShape>;

struct SetVoxels {
    static constexpr std::string_view verb = "set_volume",
                                      summary = "Change volume data in place: its file, how it is "
                                                "read as a function, the levels that are shown.";
    Id object = 0;
    VoxelShape shape;
    bool operator==(const SetVoxels&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of volume data", required.names_object());
        spread(c.shape, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetVoxels> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<VoxelShape>(&object.source);
        if (!own) return std::nullopt;
        return SetVoxels{id, *own};
    }
};
Document applied(Document document, const SetVoxels& command);
StepTitle title(const SetVoxels& c, const StepDocuments& step);

} // namespace trivar
