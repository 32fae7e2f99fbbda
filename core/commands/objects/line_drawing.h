// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/line_fields.h"

namespace trivar {

struct SetLineDrawing {
    static constexpr std::string_view
        verb = "set_line_drawing",
        summary = "Draw objects in lines: outlines, sharp edges, borders, and further lines.";
    static constexpr auto sets = &Object::line_drawing;
    std::vector<Id> objects;
    LineDrawing drawing;
    bool operator==(const SetLineDrawing&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.drawing, field);
    }
};
Document applied(Document document, const SetLineDrawing& command);
StepTitle title(const SetLineDrawing& c, const StepDocuments& step);

struct OfClearLineDrawing {
    static constexpr std::string_view verb = "clear_line_drawing",
                                      summary = "Draw objects without lines again.",
                                      help = "ids of objects drawn in lines",
                                      title = "Draw {} without lines";
    static constexpr CommandNature nature{.asked = Invocation::at_once};
    static void change(Object& o) { o.line_drawing.reset(); }
};
using ClearLineDrawing = OnObjects<OfClearLineDrawing>;

} // namespace trivar
