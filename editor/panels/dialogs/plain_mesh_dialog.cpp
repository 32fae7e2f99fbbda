// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "editor/files/plain_mesh.h"
#include "editor/panels/dialogs/plan_dialog.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "ui/widgets.h"

namespace trivar {
namespace {

void draw_fineness(const ui::Theme& theme, Refining& refining)
{
    ui::number_field(
        theme, "tolerance", refining.tolerance, {.lo = 1e-9, .hi = 1e3, .unit = "m"},
        ui::label_row(theme, "Tolerance", false,
                      "Largest proven distance of its flat triangles from the bent surface.")
            .width);
    ui::integer_field(
        theme, "budget", refining.budget, {.lo = 1, .hi = 2e7},
        ui::label_row(theme, "Triangles", false, "The largest number of triangles.").width);
}

} // namespace

void draw_plain_mesh_dialog(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.memory.of<PlainMeshDialog>();
    if (!dialog.open) return;
    PlainMeshWish& wish = dialog.wish;
    if (laid_shape(editor.session) != wish.object) { // an undo took it away
        dialog.open = false;
        return;
    }
    const std::string name = name_of(editor.session.document(), wish.object);
    const PlanAnswer answer = draw_plan_dialog(
        theme,
        {.title = wish.in_place ? "Apply shape" : "Copy as plain mesh",
         .rows = 2,
         .fields = [&] { draw_fineness(theme, wish.refining); },
         .come_to =
             [&] {
                 return wish.in_place
                            ? name + " becomes a plain model in its shape of this frame, saved in "
                                     "a file that goes with the scene. It leaves its stroke and "
                                     "moves freely; objects on it stay. Undo brings the stroke "
                                     "back."
                            : "Adds a plain model in the shape that " + name +
                                  " has in this frame, in the same place, saved in a file that "
                                  "goes with the scene. It lies on no stroke and moves freely.";
             },
         .begin = [&] { return std::string(wish.in_place ? "Apply" : "Copy"); }});
    dialog.open = answer == PlanAnswer::none;
    if (answer == PlanAnswer::begun) make_plain_mesh(editor.session, wish);
}

} // namespace trivar
