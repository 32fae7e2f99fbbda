// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/line_fields.h"

namespace trivar {

struct SetLineDrawing {
    static constexpr std::string_view
        verb = "set_line_drawing",
        summary = "Draw objects in lines: outlines, sharp edges, borders, and further lines.";
    std::vector<Id> objects;
    LineDrawing drawing;
    bool operator==(const SetLineDrawing&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.drawing, field);
    }
    static std::optional<SetLineDrawing> as_it_is(const Object& object, Id id)
    {
        return SetLineDrawing{{id}, object.line_drawing.value_or(LineDrawing{})};
    }
};
Document applied(Document document, const SetLineDrawing& command);
StepTitle title(const SetLineDrawing& c, const StepDocuments& step);

struct ClearLineDrawing {
    static constexpr std::string_view verb = "clear_line_drawing",
                                      summary = "Draw objects without lines again.";
    static constexpr CommandNature nature{.asked = Invocation::at_once};
    std::vector<Id> objects;
    bool operator==(const ClearLineDrawing&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects drawn in lines", required.names_object());
    }
};
Document applied(Document document, const ClearLineDrawing& command);
StepTitle title(const ClearLineDrawing& c, const StepDocuments& step);

} // namespace trivar
