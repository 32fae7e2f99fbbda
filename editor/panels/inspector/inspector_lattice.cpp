// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "editor/panels/inspector/inspect.h"

#include "editor/actions/lattice_actions.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/warp_rows.h"
#include "editor/panels/panels.h"
#include "editor/words/volume_words.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// WarpAtHand is the warp that the section shows: the next one to be made, or an earlier one.
struct WarpAtHand {
    Id of = 0;
    std::size_t step = 0;  // its number among the lattice's steps; 0: a new one
    std::size_t known = 0; // steps there were
    // The values of a new warp.
    VolumeAxis axis = VolumeAxis::up; // that the box turns about
    double toward_deg = 0;            // the side that it bends to
    double fixed = 0;                 // where along the axis it stays as it is
};

using Steps = std::vector<Ref<VolumeEdit>>;

bool is_warp(const Steps& steps, std::size_t step)
{
    return step > 0 && step <= steps.size() && steps[step - 1]->warp.has_value();
}

// Goes to the last step where that is a warp: at first, and when one was just made.
void follow_last_warp(WarpAtHand& at_hand, Id id, const Steps& steps)
{
    const bool other = at_hand.of != id;
    if (other || steps.size() > at_hand.known) at_hand.step = steps.size();
    if (!is_warp(steps, at_hand.step)) at_hand.step = 0;
    at_hand.of = id;
    at_hand.known = steps.size();
}

// A new one begins at zero each time the hand takes one of its numbers.
Warp warp_of(const Session& session, Id id, const WarpAtHand& at_hand, std::size_t committed)
{
    const Steps& steps = object(session.document(), id).shaping;
    if (is_warp(steps, at_hand.step)) return *steps[at_hand.step - 1]->warp;
    const bool making = session.proposing() && steps.size() == committed + 1 && steps.back()->warp;
    Warp w = making ? *steps.back()->warp : Warp{};
    w.axis = at_hand.axis;
    w.toward_deg = at_hand.toward_deg;
    w.fixed = at_hand.fixed;
    return w;
}

// A row that says which warp the numbers below are of.
void choose_warp(const ui::Theme& theme, WarpAtHand& at_hand, const Steps& steps)
{
    std::vector<std::string> names{"New"};
    std::vector<std::size_t> numbers{0};
    int chosen = 0;
    for (std::size_t step = 1; step <= steps.size(); ++step) {
        if (!is_warp(steps, step)) continue;
        if (step == at_hand.step) chosen = static_cast<int>(names.size());
        names.push_back(fmt::format("{}  {}", step, words_of(*steps[step - 1], true)));
        numbers.push_back(step);
    }
    const ui::Row row = ui::label_row(
        theme, "Step", false, "the warp that these numbers change: an earlier one or a new one");
    if (ui::choice(theme, "warp", chosen, names, row.width) == ui::Edit::changed)
        at_hand.step = numbers[static_cast<std::size_t>(chosen)];
}

void box_rows(Editor& editor, const ui::Theme& theme, Id id)
{
    LatticeShape s = *made_of<LatticeShape>(editor.session.document(), id);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<LatticeShape> fields(rows, s, "shape");
    fields.resting_at(s.size, &LatticeShape::size);
    fields(&LatticeShape::grid);
    fields(&LatticeShape::orders);
    propose_edit(editor, rows.edit, [&] { return SetLattice{id, s}; });
}

void draw_bending(Editor& editor, const ui::Theme& theme, Id id)
{
    const auto committed = editor.session.committed().objects.find(id);
    if (committed == editor.session.committed().objects.end()) return;
    const Steps steps = committed->second->shaping;
    auto& at_hand = editor.memory.of<WarpAtHand>();
    follow_last_warp(at_hand, id, steps);
    if (!ui::section(theme, "Bend the box")) return;
    choose_warp(theme, at_hand, steps);
    const std::size_t step = at_hand.step;
    Warp w = warp_of(editor.session, id, at_hand, steps.size());
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, step > 0 ? &keys : nullptr};
    FieldRows<Warp> fields(rows, w, step > 0 ? fmt::format("shaping.{}.warp", step - 1) : "");
    const int axis = static_cast<int>(w.axis);
    rows.choice(fields.label(&Warp::axis), axis, axis, {"X", "Y", "Z"},
                fields.words_of(&Warp::axis),
                [&](int chosen) { w.axis = static_cast<VolumeAxis>(chosen); });
    if (step == 0) rows.edit = ui::Edit::none; // of a new one it is no step by itself
    warp_rows(fields);
    ui::gap(theme, 8);
    if (step > 0)
        return propose_edit(editor, rows.edit, [&] {
            return SetWarp{id, static_cast<int>(step), w};
        });
    at_hand.axis = w.axis;
    at_hand.toward_deg = w.toward_deg;
    at_hand.fixed = w.fixed;
    const Warp nothing{.axis = w.axis, .fixed = w.fixed, .toward_deg = w.toward_deg};
    if (w != nothing || editor.session.proposing())
        propose_edit(editor, rows.edit, [&] { return WarpVolume{id, w}; });
}

} // namespace

void draw_lattice(Editor& editor, const ui::Theme& theme, Id id)
{
    if (ui::section(theme, "Box")) {
        box_rows(editor, theme, id);
        ui::gap(theme, 8);
    }
    draw_bending(editor, theme, id);
    if (!ui::section(theme, "Delete the lattice")) return;
    for (const char* name : {keep_shape_action, back_to_rest_action}) {
        const Action& way = action(editor, name);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x + theme.size.padding, at.y});
        if (ui::button(theme, way.name, ui::ButtonKind::plain, {}) && is_enabled(editor, way))
            return way.run(editor);
    }
    ui::gap(theme, 8);
}

} // namespace trivar
