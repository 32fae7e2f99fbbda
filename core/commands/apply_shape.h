// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/step_title.h"
#include "core/document/fields/attachment_fields.h"
#include "core/document/fields/import_fields.h"
#include "core/document/fields/placement_fields.h"

namespace trivar {

struct ApplyShape {
    static constexpr std::string_view verb = "apply_shape",
                                      summary = "Make the bent shape of what lies on a stroke "
                                                "final: it becomes a model from a file that holds "
                                                "it as it is, and lies on no stroke any more.";
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
        field("object", c.object, "id of an object on a stroke", required);
        FieldsOf<ImportedFile>::fields(c.file, field);
        field("transform", c.transform, "where the model of the file stands to its parent");
        field("tolerance", c.tolerance,
              "metres of the file's triangles from the true surface at most; 0: not certified",
              not_negative.in(Unit::metres));
        field("riders", c.riders,
              "ids of objects that it carries and that go on to go with it; any other one that it "
              "carries stays in the world");
        field("strokes", c.strokes, "of these, in the same order, as they are now");
        field("attach", c.attach, "what carries them from now on, in the same order");
    }
};
Document applied(Document document, const ApplyShape& command);
StepTitle title(const ApplyShape& c, const StepDocuments& step);

} // namespace trivar
