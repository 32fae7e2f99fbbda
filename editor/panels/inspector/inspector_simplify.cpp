// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_simplify.h"

#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"

#include <fmt/format.h>

namespace trivar {

void draw_simplify(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Simplify")) return;
    Session& session = editor.session;
    const std::optional<Simplifying> now = object(session.document(), id).simplifying;
    bool on = now.has_value();
    ui::label_row(theme, "Triangles", false,
                  "reduces them; borders, creases and texture seams stay");
    const ui::Edit turned = ui::check_box(theme, "simplified", on, "fewer");
    if (turned == ui::Edit::copied)
        copy_command(editor, on ? Command(Simplify{{id}, *now}) : ClearSimplify{{id}});
    else if (turned == ui::Edit::changed) {
        session.run(on ? Command(Simplify{{id}, {}}) : ClearSimplify{{id}});
        return;
    }
    if (!now) {
        ui::gap(theme, 8);
        return;
    }
    Simplifying s = *now;
    ValueRows rows{theme};
    FieldRows<Simplifying> fields(rows, s, "");
    fields(&Simplifying::keep);
    fields(&Simplifying::deviation);
    const auto effects = session.evaluated().objects.find(id);
    if (effects != session.evaluated().objects.end() && effects->second->triangles_before > 0)
        ui::fact_row(theme, "Left",
                     fmt::format("{} of {}", ui::with_commas(effects->second->triangles),
                                 ui::with_commas(effects->second->triangles_before)),
                     theme.color.text, "triangles of the model before it is bent");
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Simplify{{id}, s}; });
}

} // namespace trivar
