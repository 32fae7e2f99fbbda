// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_unwrap.h"

#include "core/base/number_text.h"
#include "core/commands/objects/unwrap.h"
#include "core/unwrap/unwrap.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"

namespace trivar {

void draw_unwrap(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const std::optional<Unwrapping> now = object(session.document(), id).unwrapping;
    if (!ui::section(theme, "UVs", now.has_value())) return;
    bool on = now.has_value();
    ui::label_row(theme, "UVs", false,
                  "cuts it into charts, lays them flat and packs them into the texture square");
    const ui::Edit turned = ui::check_box(theme, "unwrapped", on, "unwrap");
    if (turned == ui::Edit::copied)
        copy_command(editor, on ? Command(Unwrap{{id}, *now}) : ClearUnwrap{{id}});
    else if (turned == ui::Edit::changed) {
        session.run(on ? Command(Unwrap{{id}, {}}) : ClearUnwrap{{id}});
        return;
    }
    Unwrapping u = now.value_or(Unwrapping{});
    ValueRows rows{theme};
    FieldRows<Unwrapping> fields(rows, u, "");
    const auto shown = session.evaluated().objects.find(id);
    const UnwrapFacts* facts =
        now && shown != session.evaluated().objects.end() && shown->second->unwrapped
            ? &*shown->second->unwrapped
            : nullptr;
    const auto fact = [&](const char* label, const std::string& value, const char* help) {
        ui::fact_row(theme, label, facts ? value : "", theme.color.text, help);
    };
    const UnwrapFacts known = facts ? *facts : UnwrapFacts{};
    ui::rows_if(theme, now.has_value(), "The surface is not unwrapped.", [&] {
        fields(&Unwrapping::method);
        fields(&Unwrapping::seam_angle_deg);
        fields(&Unwrapping::spread_deg);
        fields(&Unwrapping::margin);
        fact("Charts", with_commas(known.charts),
             "pieces of the surface; some are divided because they would fold or stretch");
        fact("Square filled", percent_text(known.filled),
             "share of the texture that lies on the surface");
        fact("Angles off", number_text(known.angle) + " times",
             "stretch one way relative to the other, where it is largest: a thousandth of the "
             "surface may be worse");
        fact("Lengths off", number_text(known.length) + " times",
             "relative to the average, where they are off most: a thousandth of the surface may "
             "be worse");
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Unwrap{{id}, u}; });
}

} // namespace trivar
