// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/objects/refine.h"
#include "core/refinement/refine.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

Command refine_each(const std::vector<Id>& ids, const std::vector<Refining>& all)
{
    const auto same = [&](const Refining& each) { return each == all.front(); };
    if (std::ranges::all_of(all, same)) return Refine{ids, all.front(), {}};
    return Refine{ids, {}, all};
}

// Draws the result of refining all of them together.
void refined_facts(const ui::Theme& theme, const Evaluation& evaluated, const std::vector<Id>& ids)
{
    std::size_t before = 0, after = 0, open = 0;
    double bound = 0;
    for (const Id id : ids) {
        const auto found = evaluated.objects.find(id);
        if (found == evaluated.objects.end() || !found->second->refined) continue;
        const RefinementResult& its = *found->second->refined;
        for (const RefinedPart& part : its.parts) before += part.triangles_before;
        after += its.triangles();
        open += its.not_certified();
        bound = std::max(bound, its.bound);
    }
    const bool any = after > 0; // else hidden, not evaluated yet, or refused: the notices say why
    ui::fact_row(theme, "Triangles", any ? with_commas(after) : "", 0, "once they are split");
    ui::fact_row(theme, "Before", any ? with_commas(before) : "", 0, "triangles of the model");
    ui::fact_row(theme, "Error",
                 !any                   ? ""
                 : std::isfinite(bound) ? "at most " + ui::short_number(rounded_up(bound, 3)) + " m"
                                        : "no bound",
                 0, "how far the flat triangles are proven to be from the true surface");
    ui::fact_row(theme, "Certified",
                 !any        ? ""
                 : open == 0 ? "all"
                             : "all but " + with_commas(open),
                 open == 0 ? theme.color.good : theme.color.warn,
                 "triangles that are proven to be within the tolerance");
}

} // namespace

void draw_refinement(Editor& editor, const ui::Theme& theme, const std::vector<Id>& placed)
{
    if (!ui::section(theme, "Refinement")) return;
    Session& session = editor.session;
    std::vector<Id> ids; // those that are refined
    std::vector<Refining> all;
    for (const Id id : placed)
        if (const auto& refining = object(session.document(), id).refining) {
            ids.push_back(id);
            all.push_back(*refining);
        }
    const Refining before = all.empty() ? Refining{} : all.back();
    bool on = ids.size() == placed.size();
    ui::label_row(theme, "Edges", false, "splits them until the bent surface is certified");
    const ui::Edit turned = ui::check_box(
        theme, "refined", on, on || ids.empty() ? "refine where bent" : "some are refined");
    if (turned == ui::Edit::copied) {
        copy_command(editor, on ? refine_each(ids, all) : ClearRefine{placed});
    } else if (turned == ui::Edit::changed) {
        std::vector<Id> others = placed; // what is refined keeps how
        if (on) std::erase_if(others, [&](Id id) { return std::ranges::count(ids, id) > 0; });
        session.run(on ? Command(Refine{others, before, {}}) : ClearRefine{ids});
        return;
    }
    Refining r = before;
    const KeyGutter keys(editor, ids);
    ValueRows rows{theme, &keys};
    FieldRows<Refining> fields(rows, r, "refining", all);
    ui::rows_if(theme, !ids.empty(), "Its edges are not refined.", [&] {
        fields(&Refining::tolerance);
        fields(&Refining::split);
        fields(&Refining::budget);
        refined_facts(theme, session.evaluated(), ids);
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        for (Refining& each : all) fields.put_into(each);
        return refine_each(ids, all);
    });
}

} // namespace trivar
