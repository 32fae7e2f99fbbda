// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

std::string help_of_travel(const char* field)
{
    return help_of_field("set_travel", field);
}
RowWords with_keys(const std::string& field)
{
    return {help_of_travel(field.c_str()), "travel." + field};
}

void ends_row(ValueRows& rows, Ends& ends)
{
    int chosen = static_cast<int>(ends);
    rows.row("Ends", chosen, 0, help_of_travel("ends"), [&](float width) {
        return ui::choice(rows.theme, "ends", chosen,
                          {"Stay", "Hide", "Run on", "Loop", "Back and forth"}, width);
    });
    ends = static_cast<Ends>(chosen);
}

std::string way_of(const Journey& journey, double frames_per_second)
{
    const double seconds = journey.seconds();
    if (!std::isfinite(seconds)) return "without end";
    return fmt::format("{} s, {:.0f} frames", ui::short_number(seconds),
                       seconds * frames_per_second);
}

// What a hand changed of one travel, in another one.
void take_changes(Travel& travel, const Travel& before, const Travel& after)
{
    const auto take = [&](auto Travel::*part) {
        if (before.*part != after.*part) travel.*part = after.*part;
    };
    take(&Travel::speed);
    take(&Travel::ends);
    take(&Travel::ease_in);
    take(&Travel::ease_out);
    take(&Travel::start_frame);
    take(&Travel::duration);
    take(&Travel::followers);
    take(&Travel::gap);
    take(&Travel::phase);
}

} // namespace

void draw_travel(Editor& editor, const ui::Theme& theme, const std::vector<Id>& placed)
{
    const Document& document = editor.session.document();
    if (!ui::section(theme, "Travel")) return;
    std::vector<Travel> all;
    for (const Id id : placed) all.push_back(object(document, id).travel);
    const Travel rest, before = all.back(); // the active one's, from which a drag begins
    Travel t = before;
    const auto style = [&](auto Travel::*part, const ui::NumberStyle& own) {
        return mixed_style(all, before, part, own);
    };
    const KeyGutter keys(editor, placed);
    ValueRows rows{theme, &keys};
    rows.number("Speed", t.speed, 0,
                style(&Travel::speed, {.lo = -1e6, .hi = 1e6, .unit = "m/s", .zero = "rests"}),
                help_of_travel("speed"));
    const auto travels = [](const Travel& each) { return each.speed != 0; };
    if (std::ranges::any_of(all, travels) || t.speed != 0) {
        ends_row(rows, t.ends);
        const ui::NumberStyle seconds{.lo = 0, .hi = 1e6, .unit = "s"};
        rows.number("Ease in", t.ease_in, rest.ease_in, style(&Travel::ease_in, seconds),
                    help_of_travel("ease_in"));
        rows.number("Ease out", t.ease_out, rest.ease_out, style(&Travel::ease_out, seconds),
                    help_of_travel("ease_out"));
        rows.integer("Sets out", t.start_frame, document.time.first_frame,
                     style(&Travel::start_frame, {.lo = -999999, .hi = 999999, .unit = "frame"}),
                     help_of_travel("start_frame"));
        ui::NumberStyle duration = seconds;
        duration.zero = "no limit";
        rows.number("Stops after", t.duration, rest.duration, style(&Travel::duration, duration),
                    help_of_travel("duration"));
        const auto effects = editor.session.evaluated().objects.find(placed.back());
        if (placed.size() == 1 && effects != editor.session.evaluated().objects.end() &&
            effects->second->journey)
            ui::fact_row(theme, "Moves for",
                         way_of(*effects->second->journey, document.time.frames_per_second));
    }
    rows.integer("Followers", t.followers, rest.followers,
                 style(&Travel::followers, {.lo = 0, .hi = 999, .zero = "alone"}),
                 with_keys("followers"));
    if (t.followers > 0) {
        rows.number(
            "Gap", t.gap, rest.gap,
            style(
                &Travel::gap,
                {.lo = 0, .hi = 1e6, .unit = "m", .zero = t.ends == Ends::loop ? "even" : "close"}),
            with_keys("gap"));
        rows.number("Phase", t.phase, rest.phase, style(&Travel::phase, {.lo = -1, .hi = 1}),
                    with_keys("phase"));
    }
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        if (placed.size() == 1) return SetTravel{placed, t};
        for (Travel& each : all) take_changes(each, before, t);
        return SetTravel{placed, {}, all};
    });
}

} // namespace trivar
