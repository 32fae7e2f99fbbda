// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions.h"

#include "editor/editor.h"
#include "editor/help_actions.h"
#include "editor/relink.h"
#include "editor/reset_actions.h"
#include "editor/selection_actions.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <cassert>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using ui::Chord;

constexpr Chord ctrl(int key, bool shift = false)
{
    return {.key = key, .ctrl = true, .shift = shift};
}
constexpr Chord alt(int key)
{
    return {.key = key, .alt = true};
}

// A group's members go where it goes.
std::vector<Id> chosen(const Editor& e)
{
    return topmost(e.session.document(), e.session.selected.ids());
}

void file_actions(std::vector<Action>& a)
{
    a.push_back({"File", "New scene", {ctrl('N')}, [](Editor& e) {
                     // Whoever asks for one needs no card that offers it.
                     e.files.new_scene([&e] { e.start_card = {.left = e.session.scenes()}; });
                 }});
    a.push_back({"File", "Open...", {ctrl('O')}, [](Editor& e) { e.files.ask_open(); }});
    a.push_back({"File", "Save", {ctrl('S')}, [](Editor& e) { e.files.save(); }, {}, true});
    a.push_back(
        {"File", "Save as...", {ctrl('S', true)}, [](Editor& e) { e.files.ask_save_as(); }});
    a.push_back(
        {"File", "Save numbered copy", {{.key = 'S', .ctrl = true, .alt = true}}, [](Editor& e) {
             e.files.save_numbered_copy();
         }});
    a.push_back({"File", "Save compact...", {}, [](Editor& e) { e.files.ask_save_compact(); }});
    a.push_back({"File",
                 "Import model...",
                 {ctrl('I', true)},
                 [](Editor& e) { e.files.ask_import(); },
                 {},
                 true});
    a.push_back({"File",
                 "Find missing file...",
                 {},
                 [](Editor& e) { e.files.ask_missing(); },
                 something_there()});
    a.push_back({"File",
                 "Read files anew",
                 {},
                 [](Editor& e) { read_anew(e.session, e.session.selected.ids()); },
                 something_selected()});
    a.push_back({"File",
                 "Collect files beside the scene",
                 {},
                 [](Editor& e) { e.files.collect(); },
                 something_there()});
    a.push_back({"File",
                 "Export...",
                 {ctrl('E')},
                 [](Editor& e) { e.files.ask_export(); },
                 something_there()});
    a.push_back({"File", "Quit", {ctrl('Q')}, [](Editor& e) { e.files.ask_close(); }, {}, true});
}

void edit_actions(std::vector<Action>& a)
{
    a.push_back({"Edit",
                 "Undo",
                 {ctrl('Z')},
                 [](Editor& e) { e.session.undo(); },
                 {[](const Editor& e) { return e.session.scene().history().position() > 0; },
                  "nothing was done yet"}});
    a.push_back({"Edit",
                 "Redo",
                 {ctrl('Z', true), ctrl('Y')},
                 [](Editor& e) { e.session.redo(); },
                 {[](const Editor& e) {
                      const History& h = e.session.scene().history();
                      return h.position() < h.steps().size();
                  },
                  "nothing was undone"}});
    a.push_back({"Edit",
                 "Duplicate",
                 {{.key = 'D', .shift = true}},
                 [](Editor& e) {
                     const Id first = e.session.committed().next_id;
                     if (!e.session.run(Duplicate{chosen(e), {0, 0, 0}})) return;
                     e.session.select_new(first);
                     action(e, "Move").run(e); // else the copies hide in what they are copies of
                 },
                 something_selected(),
                 true});
    a.push_back({"Edit",
                 "Rename",
                 {{ui::key_f1 + 1}},
                 [](Editor& e) {
                     const Id id = e.session.selected;
                     e.outliner.renaming = id;
                     e.outliner.new_name = name_of(e.session.document(), id);
                     e.preferences.show_dock = true;
                     e.only_view = false;
                 },
                 something_selected()});
    a.push_back({"Edit",
                 "Group",
                 {ctrl('G')},
                 [](Editor& e) {
                     const Id group = e.session.committed().next_id;
                     if (e.session.run(Group{chosen(e)})) e.session.selected = group;
                 },
                 something_selected()});
    a.push_back({"Edit",
                 "Ungroup",
                 {ctrl('G', true)},
                 [](Editor& e) { e.session.run(Ungroup{e.session.selected}); },
                 {[](const Editor& e) {
                      const auto& objects = e.session.document().objects;
                      const auto found = objects.find(e.session.selected);
                      return found != objects.end() &&
                             std::holds_alternative<GroupShape>(found->second->source);
                  },
                  "select a group first"}});
    a.push_back({"Edit",
                 "Take off the stroke",
                 {},
                 [](Editor& e) { e.session.run(Unplace{e.session.selected}); },
                 {[](const Editor& e) {
                      const auto& objects = e.session.document().objects;
                      const auto found = objects.find(e.session.selected);
                      return found != objects.end() && found->second->placement.has_value();
                  },
                  "select a placed object first"}});
    a.push_back({"Edit",
                 "Hide or show",
                 {{'H'}},
                 [](Editor& e) {
                     const auto hidden = [&](Id id) {
                         return object(e.session.document(), id).hidden;
                     };
                     const std::vector<Id> ids = chosen(e);
                     if (std::all_of(ids.begin(), ids.end(), hidden))
                         e.session.run(Show{ids});
                     else
                         e.session.run(Hide{ids});
                 },
                 something_selected()});
    a.push_back({"Edit",
                 "Lock or unlock",
                 {},
                 [](Editor& e) {
                     const auto is_locked = [&](Id id) {
                         return object(e.session.document(), id).locked;
                     };
                     const std::vector<Id> ids = chosen(e);
                     if (std::all_of(ids.begin(), ids.end(), is_locked))
                         e.session.run(Unlock{ids});
                     else
                         e.session.run(Lock{ids});
                 },
                 something_selected()});
    a.push_back({"Edit",
                 "Delete",
                 {{ui::key_delete}},
                 [](Editor& e) {
                     std::vector<Id> ids = chosen(e);
                     std::erase_if(ids, [&](Id id) { return locked(e.session.document(), id); });
                     if (!ids.empty())
                         e.session.run(Delete{ids});
                     else
                         e.session.notices.say(ui::NoticeKind::warning, "Nothing was deleted",
                                               "What is selected is locked. Unlock it first.");
                 },
                 something_selected()});
    a.push_back({"Edit",
                 "Find in the outliner",
                 {ctrl('F')},
                 [](Editor& e) {
                     e.preferences.show_dock = true;
                     e.only_view = false;
                     e.outliner.focus_filter = true;
                 },
                 something_there()});
    a.push_back({"Edit",
                 "Repeat last",
                 {{.key = 'R', .shift = true}},
                 [](Editor& e) {
                     const auto command = repeated(e.session);
                     if (!command) return;
                     const Id first = e.session.committed().next_id;
                     if (e.session.run(*command)) e.session.select_new(first);
                 },
                 {[](const Editor& e) { return repeated(e.session).has_value(); },
                  "the last step cannot be repeated on what is selected"}});
    a.push_back(
        {"Edit",
         "Adjust last",
         {{ui::key_f1 + 8}},
         [](Editor& e) { e.adjustment.open = !e.adjustment.open; },
         {[](const Editor& e) { return e.adjustment.step != 0; }, "the last step has no numbers"}});
    a.push_back({"Edit",
                 preferences_action,
                 {ctrl(ui::key_comma)},
                 [](Editor& e) { e.preferences_dialog.open = true; },
                 {},
                 true});
}

template <class Add> Action add_action(const std::string& name)
{
    return {"Add", name, {}, [](Editor& e) {
                const Id id = e.session.committed().next_id;
                const bool first = e.session.committed().objects.empty();
                if (!e.session.run(Add{})) return;
                e.session.selected = id;
                if (first) e.session.frame_all_when_evaluated = true;
            }};
}

void look_from(Editor& e, const glm::dvec3& direction)
{
    e.session.camera = ui::seen_from(e.session.camera, direction);
}

void view_actions(std::vector<Action>& a)
{
    a.push_back({"View",
                 "Frame selection",
                 {{ui::key_period}, {'F'}},
                 [](Editor& e) {
                     e.session.camera = ui::framed(e.session.camera,
                                                   points_of(e.session, e.session.selected.ids()));
                 },
                 something_there()});
    a.push_back({"View",
                 "Frame all",
                 {{ui::key_home}},
                 [](Editor& e) {
                     e.session.camera = ui::framed(e.session.camera, points_of(e.session, {}));
                 },
                 something_there()});
    a.push_back({"View",
                 "Front",
                 {alt('1')},
                 [](Editor& e) {
                     look_from(e, {0, -1, 0});
                 },
                 {},
                 true});
    a.push_back({"View", "Right", {alt('3')}, [](Editor& e) { look_from(e, {1, 0, 0}); }});
    a.push_back({"View", "Top", {alt('7')}, [](Editor& e) { look_from(e, {0, 0, 1}); }});
    a.push_back({"View", "Perspective", {alt('5')}, [](Editor& e) {
                     Camera& camera = e.session.camera;
                     camera = ui::with_perspective(camera, !camera.perspective);
                 }});
    const auto colored_by = [](ColorBy by) {
        return [by](Editor& e) {
            RenderSettings settings = *e.session.document().render;
            settings.color_by = by;
            e.session.run(SetRender{settings});
        };
    };
    const auto by_other_than = [](ColorBy by) {
        return Condition{
            [by](const Editor& e) { return e.session.document().render->color_by != by; },
            "it is so"};
    };
    a.push_back({"View",
                 "Colour by material",
                 {},
                 colored_by(ColorBy::material),
                 by_other_than(ColorBy::material),
                 true});
    a.push_back({"View",
                 "Colour by stretch",
                 {},
                 colored_by(ColorBy::stretch),
                 by_other_than(ColorBy::stretch)});
    a.push_back({"View",
                 "Keep this view",
                 {},
                 [](Editor& e) {
                     std::string name;
                     int n = 1;
                     do name = "View " + std::to_string(n++);
                     while (e.session.document().bookmarks.contains(name));
                     if (e.session.run(SaveCamera{name, e.session.camera}))
                         e.session.notices.say(ui::NoticeKind::good, name + " is kept",
                                               "It is in the View menu.");
                 },
                 {},
                 true});
    a.push_back({"View", "Use this view for pictures", {}, [](Editor& e) {
                     if (e.session.run(SaveCamera{"picture", e.session.camera}))
                         e.session.notices.say(ui::NoticeKind::good, "This view is kept",
                                               "Replayed pictures and this scene open in it.");
                 }});
    a.push_back({"View",
                 "Timing",
                 {{ui::key_f1 + 9}},
                 [](Editor& e) { e.timing.open = !e.timing.open; },
                 {},
                 true});
}

void open_tab(Editor& e, Editor::Tab tab)
{
    e.tab = tab;
    e.preferences.show_dock = true;
    e.only_view = false;
}

void window_actions(std::vector<Action>& a)
{
    a.push_back({"View",
                 "Side panels",
                 {{'N'}},
                 [](Editor& e) { e.preferences.show_dock = !e.preferences.show_dock; },
                 {},
                 true});
    a.push_back({"View", "History", {}, [](Editor& e) { open_tab(e, Editor::Tab::history); }});
    a.push_back({"View", "Log", {}, [](Editor& e) { open_tab(e, Editor::Tab::log); }});
    a.push_back({"View", "Next panel", {{ui::key_f1 + 5}}, [](Editor& e) {
                     using Panel = Editor::Panel;
                     e.show_focus = true;
                     e.preferences.show_dock = true;
                     e.only_view = false;
                     e.panel = e.panel == Panel::view       ? Panel::outliner
                               : e.panel == Panel::outliner ? Panel::dock
                                                            : Panel::view;
                 }});
    a.push_back({"View", "Viewport only", {{.key = ui::key_space, .ctrl = true}}, [](Editor& e) {
                     e.only_view = !e.only_view;
                 }});
    a.push_back({"View", "Full screen", {{ui::key_f1 + 10}}, [](Editor& e) {
                     e.full_screen = !e.full_screen;
                 }});
    const auto scaled = [](int direction) {
        return [direction](Editor& e) {
            double& scale = e.preferences.scale;
            scale = direction == 0 ? 1 : next_scale(scale, direction);
        };
    };
    a.push_back({"View",
                 "Larger interface",
                 {ctrl(ui::key_plus), ctrl(ui::key_equal), ctrl(ui::key_equal, true),
                  ctrl(ui::key_plus, true), ctrl(ui::key_keypad_plus)},
                 scaled(1),
                 {[](const Editor& e) { return e.preferences.scale < interface_scales.back(); },
                  "it is the largest"},
                 true});
    a.push_back({"View",
                 "Smaller interface",
                 {ctrl(ui::key_minus), ctrl(ui::key_keypad_minus)},
                 scaled(-1),
                 {[](const Editor& e) { return e.preferences.scale > interface_scales.front(); },
                  "it is the smallest"}});
    a.push_back({"View",
                 "Usual size of the interface",
                 {ctrl(ui::key_0)},
                 scaled(0),
                 {[](const Editor& e) { return e.preferences.scale != 1; }, "it is at 100 %"}});
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
    file_actions(a);
    edit_actions(a);
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
    view_actions(a);
    window_actions(a);
    for (std::size_t i = 0; i < editor.tools.size(); ++i)
        a.push_back({"Tools", editor.tools[i]->name(), editor.tools[i]->keys(), [i](Editor& e) {
                         e.choose_tool(i);
                         e.active_tool().begin(e.session);
                     }});
    add_help_actions(a);
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

void run_keys(Editor& editor)
{
    const auto escape = [] { return ui::struck({ui::key_escape}); };
    Tool& tool = editor.active_tool();
    if (tool.busy()) { // a gesture has the keyboard: only it and the camera go on
        const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        editor.right_cancelled = editor.right_cancelled || right;
        if (escape() || right)
            tool.cancel(editor.session);
        else
            tool.take_keys(editor.session);
        return;
    }
    if (editor.files.asking()) return;
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) {
        if (escape()) ImGui::ClosePopupToLevel(0, true);
        return;
    }
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
    for (const Action& each : editor.actions) {
        bool hit = false;
        for (const ui::Chord& chord : each.keys) hit = hit || ui::struck(chord);
        if (!hit || !is_enabled(editor, each)) continue;
        each.run(editor);
        return; // one press, one action
    }
}

} // namespace trivar
