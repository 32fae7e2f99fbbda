// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_line_drawing.h"

#include "core/commands/objects/line_drawing.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/ink_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/key_gutter.h"

namespace trivar {
void draw_line_drawing(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const LineStyle pen{.taper = 0}; // so that lines are strokes in files, which a hand can edit
    const std::optional<LineDrawing> now = object(session.document(), id).line_drawing;
    if (!ui::section(theme, "Line drawing", now.has_value())) return;
    bool on = now.has_value();
    ui::label_row(theme, "Lines", false, "draws the object in lines");
    const ui::Edit turned = ui::check_box(theme, "drawn in lines", on, "drawn");
    if (turned == ui::Edit::copied)
        copy_command(editor, on ? Command(SetLineDrawing{{id}, *now}) : ClearLineDrawing{{id}});
    else if (turned == ui::Edit::changed) {
        session.run(on ? Command(SetLineDrawing{{id}, {.intersections = true, .ink = pen}})
                       : ClearLineDrawing{{id}});
        return;
    }
    LineDrawing drawing = now.value_or(LineDrawing{});
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    const std::string own = "line_drawing";
    FieldRows<LineDrawing> fields(rows, drawing, own);
    ui::rows_if(theme, now.has_value(), "It is not drawn in lines.", [&] {
        fields(&LineDrawing::outlines);
        fields(&LineDrawing::creases);
        ui::rows_if(theme, drawing.creases, "No creases are drawn.",
                    [&] { fields(&LineDrawing::crease_deg); });
        fields(&LineDrawing::borders);
        fields(&LineDrawing::intersections);
        fields(&LineDrawing::surface);
        ui::rows_if(theme, drawing.surface, "The surface is not drawn.",
                    [&] { fields(&LineDrawing::paper); });
        draw_ink_rows(rows, drawing.ink, pen, own + ".ink");
        draw_more_line_rows(rows, drawing.more, own + ".more");
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return SetLineDrawing{{id}, drawing}; });
}

} // namespace trivar
