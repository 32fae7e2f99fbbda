// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/attachment_fields.h"
#include "core/document/fields/import_fields.h"
#include "core/document/fields/placement_fields.h"

namespace trivar {

struct ApplyShape {
    static constexpr std::string_view
        verb = "apply_shape",
        summary = "Make the bent shape of a placed object final: it becomes a model from a file, "
                  "which no longer lies on a stroke.";
    static constexpr CommandNature nature{.icon = CommandIcon::import_model,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    ImportedFile file;
    Transform transform = {};
    double tolerance = 0;
    std::vector<Id> riders = {};
    std::vector<Sketch> strokes = {};
    std::vector<Attachment> attach = {};
    bool operator==(const ApplyShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object on a stroke", required.names_object());
        spread(c.file, field);
        field("transform", c.transform, "transform of the model in its parent");
        field("tolerance", c.tolerance,
              "metres that the file's triangles may be from the true surface at most; 0: not "
              "certified",
              not_negative.in(Unit::metres));
        field("riders", c.riders,
              "ids of attached objects that stay attached to it; all others stay in the world",
              any_value.names_object());
        field("strokes", c.strokes, "strokes of the riders, in the same order, as they are now");
        field("attach", c.attach, "hosts of the riders from now on, in the same order");
    }
};
Document applied(Document document, const ApplyShape& command);
StepTitle title(const ApplyShape& c, const StepDocuments& step);

} // namespace trivar
