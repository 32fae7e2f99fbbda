// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/all_actions.h"

#include "core/commands/objects/shape.h"
#include "core/commands/objects/text.h"
#include "editor/actions/actions.h"
#include "editor/actions/chords.h"
#include "editor/actions/edit_actions.h"
#include "editor/actions/file_actions.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/key_actions.h"
#include "editor/actions/lattice_actions.h"
#include "editor/actions/mask_actions.h"
#include "editor/actions/menu.h"
#include "editor/actions/model_actions.h"
#include "editor/actions/placement_actions.h"
#include "editor/actions/reset_actions.h"
#include "editor/actions/selection_actions.h"
#include "editor/actions/split_actions.h"
#include "editor/actions/surface_actions.h"
#include "editor/actions/tile_actions.h"
#include "editor/actions/time_actions.h"
#include "editor/actions/view_actions.h"
#include "editor/commands/new_material.h"
#include "editor/editor.h"
#include "editor/hands/last_shaping.h"
#include "editor/hands/parts_tool.h"
#include "editor/hands/selected_placement.h"
#include "editor/tools/all_tools.h"

#include <tuple>

namespace trivar {

namespace {

template <class Add> Action add_action(const std::string& name)
{
    return {"Add", name, {}, [](Editor& e) {
                const Id id = e.session.committed().next_id;
                const bool first = e.session.committed().objects.empty();
                Add add;
                add.material = new_material;
                if (!e.session.run(prepare(add, *e.session.assets()))) return;
                e.session.selected = id;
                if (first) e.session.view.frame_all_when_evaluated = true;
            }};
}

} // namespace

std::vector<Action> all_actions()
{
    const std::vector<std::unique_ptr<Tool>> tools = all_tools(); // as the editor has them
    std::vector<Action> a;
    const Menu add(a, "Add"), edit(a, "Edit"), lattice(a, "Lattice"), tools_menu(a, "Tools");
    add_file_actions(a);
    add_edit_actions(a);
    add_tile_actions(a);
    add_surface_actions(a);
    add_split_actions(a);
    add_mask_actions(a);
    add_selection_actions(a);
    add_reset_actions(a);
    add(add_action_name, {{.key = 'A', .shift = true}}, [](Editor& e) { e.add_menu_asked = true; });
    a.push_back(add_action<AddPlane>("Plane"));
    a.push_back(add_action<AddBox>("Box"));
    a.push_back(add_action<AddSphere>("Sphere"));
    a.push_back(add_action<AddCylinder>("Cylinder"));
    a.push_back(add_action<AddTorus>("Torus"));
    a.push_back(add_action<AddMoebius>("Moebius band"));
    a.push_back(add_action<AddTeapot>("Teapot"));
    a.push_back(add_action<AddText>("Text"));
    add_lattice_actions(a);
    add_placement_actions(a);
    edit(
        preferences_action, {ctrl(ui::key_comma)},
        [](Editor& e) { e.preferences_dialog.open = true; }, {}, true);
    add_model_actions(a);
    add_view_actions(a);
    add_window_actions(a);
    add_time_actions(a);
    add_key_actions(a);
    for (std::size_t i = 0; i < tools.size(); ++i)
        tools_menu(tools[i]->name(), tools[i]->facts().keys, [i](Editor& e) {
            const std::optional<MotionKind> motion = e.tools[i]->motion();
            PartsTool* parts = e.tool_parts();
            if (motion && parts && parts->grab(e.session, *motion)) return;
            e.choose_tool(i);
            e.active_tool().begin(e.session);
        });
    for (const auto& [name, key, factor] :
         {std::tuple("Smaller tool", '[', 1 / 1.1), {"Larger tool", ']', 1.1}}) {
        tools_menu(name, {{key}}, [by = factor](Editor& e) {
            e.active_tool().resize(e.session, by);
        }).repeats = true;
    }
    lattice(mend_action, {{.key = 'M', .shift = true}},
            [](Editor& e) { e.session.run(MendVolume{e.session.selected}); },
            {[](const Editor& e) { return selected_volume(e.session) != nullptr; },
             "select a placed object or a lattice first"});
    lattice(allow_folds_action, {},
            [](Editor& e) {
                allow_folds(e.session, e.session.selected, e.tool_parts()->held(e.session));
            },
            {[](const Editor& e) {
                 const PartsTool* parts = e.tool_parts();
                 return parts && !parts->held(e.session).empty();
             },
             "choose control points first, or hold the ball of the press somewhere"});
    add_help_actions(a);
    let_keys_take(a);
    for (Action& each : a) each.usual_keys = each.keys;
    return a;
}

} // namespace trivar
