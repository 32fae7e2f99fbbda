// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspect.h"

#include "editor/actions/lattice_actions.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/panels.h"

namespace trivar {
namespace {

struct NextWarp {
    VolumeAxis axis = VolumeAxis::up; // that the box turns about
    double toward_deg = 0;            // the side that it bends to
    double fixed = 0;                 // where along the axis it stays as it is
};

// The warp that is being made: it begins at zero each time the hand takes one of its numbers.
Warp warp_at_hand(const Session& session, Id id)
{
    const std::vector<Ref<VolumeEdit>>& steps = object(session.document(), id).shaping;
    const auto before = session.committed().objects.find(id);
    const bool making = session.proposing() && before != session.committed().objects.end() &&
                        steps.size() == before->second->shaping.size() + 1 && steps.back()->warp;
    return making ? *steps.back()->warp : Warp{};
}

void box_rows(Editor& editor, const ui::Theme& theme, Id id)
{
    LatticeShape s = std::get<LatticeShape>(object(editor.session.document(), id).source);
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
    if (!ui::section(theme, "Bend the box")) return;
    Warp w = warp_at_hand(editor.session, id);
    auto& next = editor.memory.of<NextWarp>();
    ValueRows rows{theme};
    w.axis = next.axis;
    w.toward_deg = next.toward_deg;
    w.fixed = next.fixed;
    FieldRows<Warp> fields(rows, w, "");
    const int axis = static_cast<int>(w.axis);
    rows.choice(fields.label(&Warp::axis), axis, axis, {"X", "Y", "Z"},
                fields.words_of(&Warp::axis),
                [&](int chosen) { w.axis = static_cast<VolumeAxis>(chosen); });
    rows.edit = ui::Edit::none; // it is no step by itself
    fields(&Warp::twist_deg);
    fields(&Warp::bend_deg);
    fields(&Warp::toward_deg);
    fields(&Warp::fixed);
    fields(&Warp::taper);
    fields(&Warp::shear);
    fields(&Warp::bulge);
    next = {w.axis, w.toward_deg, w.fixed};
    ui::gap(theme, 8);
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
        if (ui::button(theme, way.name, ui::ButtonKind::plain, {}) && is_enabled(editor, way))
            return way.run(editor);
    }
    ui::gap(theme, 8);
}

} // namespace trivar
