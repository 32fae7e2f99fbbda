// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounded.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

RowWords help_of_refine(const std::string& field)
{
    return {help_of_field("refine", field), "refining." + field};
}

Command refine_each(const std::vector<Id>& ids, const std::vector<Refining>& all)
{
    const auto same = [&](const Refining& each) { return each == all.front(); };
    if (std::ranges::all_of(all, same)) return Refine{ids, all.front(), {}};
    return Refine{ids, {}, all};
}

// What a hand took, if it did.
std::optional<SplitPoint> split_row(ValueRows& rows, SplitPoint split, bool mixed)
{
    std::vector<std::string> words{"By curvature", "Midpoint", "Greville", "Greatest error"};
    if (mixed) words.insert(words.begin(), "Mixed"); // is shown; to take it changes nothing
    const int first = mixed ? 1 : 0, shown = mixed ? 0 : static_cast<int>(split);
    int chosen = shown;
    rows.row("Split", chosen, first, help_of_refine("split"),
             [&](float width) { return ui::choice(rows.theme, "split", chosen, words, width); });
    if (chosen == shown) return std::nullopt;
    return static_cast<SplitPoint>(chosen - first);
}

// What came of it, of all together.
void refined_facts(const ui::Theme& theme, const Evaluated& evaluated, const std::vector<Id>& ids)
{
    std::size_t before = 0, after = 0, open = 0;
    double bound = 0;
    for (const Id id : ids) {
        const auto found = evaluated.objects.find(id);
        if (found == evaluated.objects.end() || !found->second->refined) continue;
        const Refined& its = *found->second->refined;
        for (const RefinedPart& part : its.parts) before += part.triangles_before;
        after += its.triangles();
        open += its.not_certified();
        bound = std::max(bound, its.bound);
    }
    if (after == 0) return; // hidden, not evaluated yet, or refused: the notices say why
    ui::fact_row(theme, "Triangles", ui::with_commas(after), 0, "once they are split");
    ui::fact_row(theme, "Before", ui::with_commas(before), 0, "triangles of the model");
    if (std::isfinite(bound))
        ui::fact_row(theme, "Error", "at most " + ui::short_number(rounded_up(bound, 3)) + " m", 0,
                     "how far the flat triangles are proven to be from the true surface");
    ui::fact_row(theme, "Certified", open == 0 ? "all" : "all but " + ui::with_commas(open),
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
    const Refining rest, before = all.empty() ? rest : all.back();
    bool on = ids.size() == placed.size();
    ui::label_row(theme, "Edges", false, "splits them until the bent surface is certified");
    const ui::Edit turned = ui::check_box(
        theme, "refined", on, on || ids.empty() ? "split where bent" : "some are split");
    if (turned == ui::Edit::copied) {
        copy_command(editor, on ? refine_each(ids, all) : ClearRefine{placed});
    } else if (turned == ui::Edit::changed) {
        std::vector<Id> others = placed; // what is refined keeps how
        if (on) std::erase_if(others, [&](Id id) { return std::ranges::count(ids, id) > 0; });
        session.run(on ? Command(Refine{others, before, {}}) : ClearRefine{ids});
        return;
    }
    Refining r = before;
    const auto style = [&](auto Refining::*part, const ui::NumberStyle& own) {
        return mixed_style(all, before, part, own);
    };
    const KeyGutter keys(editor, ids);
    ValueRows rows{theme, &keys};
    std::optional<SplitPoint> split;
    if (!ids.empty()) {
        rows.number("Tolerance", r.tolerance, rest.tolerance,
                    style(&Refining::tolerance, {.lo = 1e-6, .hi = 1e3, .unit = "m"}),
                    help_of_refine("tolerance"));
        split = split_row(rows, r.split, differs(all, before, &Refining::split));
        rows.integer("Budget", r.budget, rest.budget,
                     style(&Refining::budget, {.lo = 12, .hi = 20000000}),
                     help_of_refine("budget"));
        refined_facts(theme, session.evaluated(), ids);
    }
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        for (Refining& each : all) { // what a hand changed of one, in each of them
            if (before.tolerance != r.tolerance) each.tolerance = r.tolerance;
            if (split) each.split = *split;
            if (before.budget != r.budget) each.budget = r.budget;
        }
        return refine_each(ids, all);
    });
}

} // namespace trivar
