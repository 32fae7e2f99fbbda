// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_unwrap.h"

#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"

#include <fmt/format.h>

namespace trivar {

void draw_unwrap(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "UVs")) return;
    Session& session = editor.session;
    const std::optional<Unwrapping> now = object(session.document(), id).unwrapping;
    bool on = now.has_value();
    ui::label_row(theme, "Surface", false,
                  "cuts it into charts, lays them flat and packs them into the texture square");
    const ui::Edit turned = ui::check_box(theme, "unwrapped", on, "unwrapped");
    if (turned == ui::Edit::copied)
        copy_command(editor, on ? Command(Unwrap{{id}, *now}) : ClearUnwrap{{id}});
    else if (turned == ui::Edit::changed) {
        session.run(on ? Command(Unwrap{{id}, {}}) : ClearUnwrap{{id}});
        return;
    }
    if (!now) {
        ui::gap(theme, 8);
        return;
    }
    Unwrapping u = *now;
    ValueRows rows{theme};
    FieldRows<Unwrapping> fields(rows, u, "");
    fields(&Unwrapping::method);
    fields(&Unwrapping::seam_angle_deg);
    fields(&Unwrapping::spread_deg);
    fields(&Unwrapping::margin);
    const auto shown = session.evaluated().objects.find(id);
    if (shown != session.evaluated().objects.end() && shown->second->unwrapped) {
        const UnwrapFacts& facts = *shown->second->unwrapped;
        const auto fact = [&](const char* label, const std::string& value, const char* help) {
            ui::fact_row(theme, label, value, theme.color.text, help);
        };
        fact("Charts", ui::with_commas(facts.charts),
             "pieces of the surface; some are divided because they would fold or stretch");
        fact("Square filled", fmt::format("{:.0f} %", 100 * facts.filled),
             "share of the texture that lies on the surface");
        fact("Angles off", fmt::format("{:.2f} times", facts.angle),
             "stretch one way relative to the other, where it is largest: a thousandth of the "
             "surface may be worse");
        fact("Lengths off", fmt::format("{:.2f} times", facts.length),
             "relative to the average, where they are off most: a thousandth of the surface may "
             "be worse");
    }
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Unwrap{{id}, u}; });
}

} // namespace trivar
