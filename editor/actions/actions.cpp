// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"

#include "editor/actions/edit_actions.h"
#include "editor/actions/file_actions.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/key_actions.h"
#include "editor/actions/reset_actions.h"
#include "editor/actions/selection_actions.h"
#include "editor/actions/start_card.h"
#include "editor/actions/time_actions.h"
#include "editor/actions/view_actions.h"
#include "editor/commands/new_material.h"
#include "editor/editor.h"
#include "editor/panels/panels.h"
#include "editor/tools/last_shaping.h"
#include "editor/tools/placement_handles.h"
#include "ui/input.h"
#include "ui/sentence.h"

#include <algorithm>
#include <cassert>
#include <imgui.h>
#include <imgui_internal.h>
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
                if (first) e.session.frame_all_when_evaluated = true;
            }};
}

} // namespace

Condition something_selected()
{
    return {[](const Editor& e) { return e.session.selected != 0; }, "select an object first"};
}

Condition something_there()
{
    return {[](const Editor& e) { return !e.session.document().objects.empty(); },
            "the scene is empty"};
}

std::vector<Action> all_actions(const Editor& editor)
{
    std::vector<Action> a;
    add_file_actions(a);
    add_edit_actions(a);
    add_selection_actions(a);
    add_reset_actions(a);
    a.push_back({"Add", add_action_name, {{.key = 'A', .shift = true}}, [](Editor& e) {
                     e.add_menu_asked = true;
                 }});
    a.push_back(add_action<AddPlane>("Plane"));
    a.push_back(add_action<AddBox>("Box"));
    a.push_back(add_action<AddSphere>("Sphere"));
    a.push_back(add_action<AddCylinder>("Cylinder"));
    a.push_back(add_action<AddTorus>("Torus"));
    a.push_back(add_action<AddMoebius>("Moebius band"));
    a.push_back(add_action<AddTeapot>("Teapot"));
    a.push_back(add_action<AddText>("Text"));
    add_view_actions(a);
    add_window_actions(a);
    add_time_actions(a);
    add_key_actions(a);
    for (std::size_t i = 0; i < editor.tools.size(); ++i)
        a.push_back({"Tools", editor.tools[i]->name(), editor.tools[i]->keys(), [i](Editor& e) {
                         if (e.tools[i]->moves() && e.active_tool().grab(e.session)) return;
                         e.choose_tool(i);
                         e.active_tool().begin(e.session);
                     }});
    for (const auto& [name, key, factor] :
         {std::tuple("Smaller tool", '[', 1 / 1.1), {"Larger tool", ']', 1.1}}) {
        a.push_back({"Tools", name, {{key}}, [by = factor](Editor& e) {
                         e.active_tool().resize(e.session, by);
                     }});
        a.back().repeats = true;
        a.back().group_begins = factor < 1;
    }
    a.push_back({"Edit",
                 mend_action,
                 {{.key = 'M', .shift = true}},
                 [](Editor& e) { e.session.run(MendVolume{e.session.selected}); },
                 {[](const Editor& e) { return selected_placement(e.session) != nullptr; },
                  "select one placed object first"},
                 true});
    a.push_back({"Edit",
                 allow_folds_action,
                 {},
                 [](Editor& e) {
                     allow_folds(e.session, e.session.selected,
                                 e.active_tool().held_parts(e.session));
                 },
                 {[](const Editor& e) { return !e.active_tool().held_parts(e.session).empty(); },
                  "choose control points first, or hold the ball of the press somewhere"}});
    add_help_actions(a);
    let_keys_take(a);
    for (Action& each : a) each.usual_keys = each.keys;
    return a;
}

const Action& action(const Editor& editor, const std::string& name)
{
    for (const Action& each : editor.actions)
        if (each.name == name) return each;
    assert(false && "no action of this name");
    return editor.actions.front();
}

bool is_enabled(const Editor& editor, const Action& action)
{
    return !action.enabled.holds || action.enabled.holds(editor);
}

std::string key_text(const Action& action)
{
    return action.keys.empty() ? std::string() : ui::text_of(action.keys.front());
}

ui::Tip tip_of(const Editor& editor, const Action& action, std::string sentence)
{
    if (!is_enabled(editor, action))
        sentence += (sentence.empty() ? "" : " ") + ui::sentence(action.enabled.otherwise);
    return {action.name, key_text(action), std::move(sentence)};
}

namespace {

// A tool with which something was done while its key was held goes with the key.
void return_lent_tool(Editor& editor)
{
    LentTool& lent = editor.lent_tool;
    const bool busy = editor.active_tool().busy();
    if (lent.key == 0) return;
    if (ui::is_down(lent.key)) {
        lent.used = lent.used || (busy && ImGui::IsMouseDown(ImGuiMouseButton_Left));
    } else if (!busy) {
        if (lent.used) editor.choose_tool(lent.before);
        lent = {};
    }
}

// Where Space makes the left button the middle one, what else it does waits till it is let go:
// whether it was, and nothing else happened meanwhile.
bool space_was_tapped(Editor& editor)
{
    HeldSpace& space = editor.held_space;
    if (ui::struck({ui::key_space})) space = {.down = true};
    if (!space.down) return false;
    const ImGuiIO& io = ImGui::GetIO();
    space.used = space.used || editor.active_tool().busy() || editor.files.asking() ||
                 std::ranges::count(io.MouseDown, true) > 0 || ImGui::IsAnyItemActive() ||
                 ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
    space.down = ui::is_down(ui::key_space);
    return !space.down && !space.used;
}

} // namespace

void run_keys(Editor& editor)
{
    const bool space_waits = editor.preferences.mouse.emulation == "space";
    const bool space_tapped = space_was_tapped(editor);
    return_lent_tool(editor);
    const auto escape = [] { return ui::struck({ui::key_escape}); };
    Tool& tool = editor.active_tool();
    if (tool.busy()) { // a gesture has the keyboard: only it and the camera go on
        const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        editor.right_cancelled = editor.right_cancelled || right;
        if (escape() || right)
            tool.cancel(editor.session);
        else
            tool.take_keys(editor.session);
        ui::swallow_keys();
        return;
    }
    if (editor.timeline.keys.gesture.by_key) return; // the timeline takes them
    if (editor.files.asking()) return;
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) {
        if (escape()) ImGui::ClosePopupToLevel(0, true);
        return;
    }
    // A menu may have closed itself by this very Esc, as the frame began.
    if (escape() && (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) return;
    if (ImGui::IsAnyItemActive()) return; // a field is being dragged
    if (escape()) {
        if (editor.session.committing())
            editor.session.cancel();
        else if (editor.show_focus && editor.panel != Editor::Panel::view)
            editor.panel = Editor::Panel::view;
        else if (editor.start_card.asked == editor.session.scenes())
            editor.start_card.asked = -1;
        else
            editor.choose_tool(0);
        editor.session.notices.clear(); // read
    }
    const bool in_list = editor.panel == Editor::Panel::outliner;
    const KeysIn here = editor.tutorial.runs(editor.session) ? KeysIn::tutorial
                        : in_list || shows_welcome(editor)   ? KeysIn::anywhere
                                                             : KeysIn::picture;
    for (const Action& each : editor.actions) {
        if (each.keys_in != KeysIn::anywhere && each.keys_in != here) continue;
        const auto chord = std::ranges::find_if(each.keys, [&](const ui::Chord& one) {
            if (space_waits && one == ui::Chord{ui::key_space}) return space_tapped;
            return ui::struck(one, each.repeats) && !tool.awaits(one) &&
                   !ui::hands().keeps(one.key);
        });
        if (chord == each.keys.end() || !is_enabled(editor, each)) continue;
        const std::size_t tool_before = editor.tool;
        const int key = chord->key; // the action may give it to another
        each.run(editor);
        editor.lent_tool = {};
        if (editor.tool != tool_before) editor.lent_tool = {key, tool_before};
        return; // one press, one action
    }
}

} // namespace trivar
