// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspect.h"

#include "editor/actions/lattice_actions.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

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
    const auto help = [](const char* field) { return help_of_field("set_lattice", field); };
    rows.row(
        "Size", s.size, s.size, RowWords(help("size"), axes_of("shape.size")),
        [&](float width) {
            return axis_fields(theme, width, {.lo = 1e-6, .hi = 1e6, .unit = "m"},
                               [&](int axis, const ui::NumberStyle& own, float each) {
                                   return ui::number_field(theme, std::string("size") + own.axis,
                                                           s.size[axis], own, each);
                               });
        },
        true);
    constexpr ValueRows::Names xyz{"X", "Y", "Z"};
    rows.triple("Density", s.grid, LatticeShape{}.grid, {.lo = 2, .hi = 1024},
                RowWords(help("grid")), xyz);
    rows.triple("Order", s.orders, LatticeShape{}.orders, {.lo = 2, .hi = 6},
                RowWords(help("orders")), xyz);
    propose_edit(editor, rows.edit, [&] { return SetLattice{id, s}; });
}

void draw_bending(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Bend the box")) return;
    Warp w = warp_at_hand(editor.session, id);
    auto& next = editor.memory.of<NextWarp>();
    ValueRows rows{theme};
    const auto help = [](const char* field) {
        return RowWords(help_of_field("warp_volume", field), std::vector<std::string>{});
    };
    rows.choice("Along", static_cast<int>(next.axis), static_cast<int>(next.axis), {"X", "Y", "Z"},
                help("axis"), [&](int chosen) { next.axis = static_cast<VolumeAxis>(chosen); });
    rows.edit = ui::Edit::none; // it is no step by itself
    w.axis = next.axis;
    const ui::NumberStyle turn{.lo = -3600, .hi = 3600, .step = 1, .unit = "deg"};
    const ui::NumberStyle share{.lo = -1, .hi = 100, .step = 0.01};
    rows.number("Twist", w.twist_deg, 0, turn, help("twist_deg"));
    rows.number("Bend", w.bend_deg, 0, {.lo = -720, .hi = 720, .step = 1, .unit = "deg"},
                help("bend_deg"));
    rows.number("Toward", next.toward_deg, 0, {.lo = -360, .hi = 360, .step = 1, .unit = "deg"},
                help("toward_deg"));
    w.toward_deg = next.toward_deg;
    rows.number("Fixed at", next.fixed, 0, {.lo = 0, .hi = 1, .bar_hi = 1, .step = 0.01},
                help("fixed"));
    w.fixed = next.fixed;
    rows.number("Taper", w.taper, 0, share, help("taper"));
    rows.number("Shear", w.shear, 0, {.lo = -100, .hi = 100, .step = 0.01}, help("shear"));
    rows.number("Bulge", w.bulge, 0, share, help("bulge"));
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
