// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/placement/travel.h"
#include "core/placement/journey.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

std::string way_of(const Journey& journey, double frames_per_second)
{
    const double seconds = journey.seconds();
    if (!std::isfinite(seconds)) return "endless";
    return fmt::format("{} s, {} frames", ui::short_number(seconds),
                       number_text(std::round(seconds * frames_per_second)));
}

} // namespace

void draw_travel(Editor& editor, const ui::Theme& theme, const std::vector<Id>& placed)
{
    const Document& document = editor.session.document();
    if (!ui::section(theme, "Travel")) return;
    std::vector<Travel> all;
    for (const Id id : placed) all.push_back(object(document, id).travel);
    Travel t = all.back(); // the active one's, from which a drag begins
    const KeyGutter keys(editor, placed);
    ValueRows rows{theme, &keys};
    FieldRows<Travel> fields(rows, t, "travel", all);
    fields(&Travel::speed);
    const auto travels = [](const Travel& each) { return each.speed != 0; };
    const bool any = std::ranges::any_of(all, travels) || t.speed != 0;
    ui::rows_if(theme, any, "It does not move: its speed is 0.", [&] {
        fields(&Travel::ends);
        fields(&Travel::ease_in);
        fields(&Travel::ease_out);
        fields.resting_at(document.time.first_frame, &Travel::start_frame);
        fields(&Travel::duration);
        const auto effects = editor.session.evaluated().objects.find(placed.back());
        const bool known =
            any && effects != editor.session.evaluated().objects.end() && effects->second->journey;
        if (placed.size() == 1)
            ui::fact_row(theme, "Moves for",
                         known ? way_of(*effects->second->journey, document.time.frames_per_second)
                               : "");
    });
    fields(&Travel::followers);
    ui::rows_if(theme, t.followers > 0, "There are no followers.", [&] {
        fields(&Travel::gap, t.ends == Ends::loop ? "even" : "close");
        fields(&Travel::phase);
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        if (placed.size() == 1) return SetTravel{placed, t};
        for (Travel& each : all) fields.put_into(each);
        return SetTravel{placed, {}, all};
    });
}

} // namespace trivar
