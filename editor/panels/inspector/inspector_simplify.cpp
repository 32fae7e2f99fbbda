// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_simplify.h"

#include "core/base/number_text.h"
#include "core/commands/objects/simplify.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"

#include <fmt/format.h>

namespace trivar {

void draw_simplify(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const std::optional<Simplifying> now = object(session.document(), id).simplifying;
    if (!ui::section(theme, "Simplify", now.has_value())) return;
    bool on = now.has_value();
    ui::label_row(theme, "Triangles", false,
                  "reduces them; borders, creases and texture seams stay");
    const ui::Edit turned = ui::check_box(theme, "simplified", on, "reduce");
    if (turned == ui::Edit::copied)
        copy_command(editor, on ? Command(Simplify{{id}, *now}) : ClearSimplify{{id}});
    else if (turned == ui::Edit::changed) {
        session.run(on ? Command(Simplify{{id}, {}}) : ClearSimplify{{id}});
        return;
    }
    Simplifying s = now.value_or(Simplifying{});
    ValueRows rows{theme};
    FieldRows<Simplifying> fields(rows, s, "");
    const auto effects = session.evaluated().objects.find(id);
    const bool known = now && effects != session.evaluated().objects.end() &&
                       effects->second->triangles_before > 0;
    ui::rows_if(theme, now.has_value(), "It keeps all its triangles.", [&] {
        fields(&Simplifying::keep);
        fields(&Simplifying::deviation);
        ui::fact_row(theme, "Left",
                     known ? fmt::format("{} of {}", with_commas(effects->second->triangles),
                                         with_commas(effects->second->triangles_before))
                           : "",
                     theme.color.text, "triangles of the model before it is bent");
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Simplify{{id}, s}; });
}

} // namespace trivar
