// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/edit_actions.h"

#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "core/steps/laying/attaching.h"
#include "editor/actions/chords.h"
#include "editor/actions/left_behind.h"
#include "editor/actions/log_lines.h"
#include "editor/actions/menu.h"
#include "editor/commands/clipboard.h"
#include "editor/editor.h"
#include "editor/hands/parts_tool.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// A group's members go where it goes.
std::vector<Id> chosen(const Editor& e)
{
    return topmost(e.session.document(), e.session.selected.ids());
}

// The chosen ones that are not locked; a notice where there is none.
std::vector<Id> deletable(Editor& e, const char* title)
{
    std::vector<Id> ids = chosen(e);
    std::erase_if(ids, [&](Id id) { return locked(e.session.document(), id); });
    if (ids.empty())
        e.session.notices.say(ui::NoticeKind::warning, title,
                              "The selected objects are locked. Unlock them first.");
    return ids;
}

void copy_objects(Editor& e, const std::vector<Id>& ids, const char* verb)
{
    ImGui::SetClipboardText(clipboard_text(e.session, ids).c_str());
    e.session.notices.say(ui::NoticeKind::good,
                          said_of(e.session.document(), ids) +
                              (ids.size() == 1 ? " was " : " were ") + verb,
                          {}, of_clipboard);
}

// Returns the selected objects that lie on a stroke: attached ones, or others.
std::vector<Id> laid(const Editor& e, bool attached)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids()) {
        const auto& step = object(e.session.document(), id).stroke;
        const auto shown = e.session.evaluated().objects.find(id);
        if (step && !step->round && step->attach.has_value() == attached &&
            shown != e.session.evaluated().objects.end() && shown->second->placement)
            out.push_back(id);
    }
    return out;
}

void attach_selected(Editor& e)
{
    for (const Id id : laid(e, false)) attach_as_it_lies(e, id);
}

// Each stays where it is now, in the world.
void detach_selected(Editor& e)
{
    for (const Id id : laid(e, true)) {
        const PlacementStep step = *object(e.session.document(), id).stroke;
        const Ref<EvaluatedObject> shown = e.session.evaluated().objects.at(id);
        const glm::dmat4 to_world = stroke_to_world(*shown);
        Sketch sketch = stroke_now(*shown, step);
        sketch.camera = carried(sketch.camera, to_world);
        if (!e.session.run(
                EditPlacement{id, carried(step.parameters, to_world), std::move(sketch), {}}))
            return;
    }
}

void cut_objects(Editor& e)
{
    const std::vector<Id> ids = deletable(e, "Nothing was cut");
    if (ids.empty()) return;
    copy_objects(e, ids, "cut");
    delete_objects(e, ids);
}

void add_clipboard_actions(std::vector<Action>& a)
{
    const Menu edit(a, "Edit");
    edit("Cut", {ctrl('X')}, cut_objects, something_selected(), true);
    edit("Copy", {ctrl('C')},
         [](Editor& e) {
             if (!copy_log_lines(e)) copy_objects(e, chosen(e), "copied");
         },
         {[](const Editor& e) { return e.session.selected != 0 || log_lines_chosen(e); },
          "select an object first"});
    edit("Paste", {ctrl('V')}, [](Editor& e) {
        const char* text = ImGui::GetClipboardText();
        paste_text(e.session, text ? text : "");
    });
}

} // namespace

void attach_as_it_lies(Editor& e, Id id)
{
    const PlacementStep step = *object(e.session.document(), id).stroke;
    const auto laid = e.session.evaluated().objects.find(id);
    const auto attachment =
        laid == e.session.evaluated().objects.end()
            ? std::nullopt
            : attachment_of(*laid->second, step.sketch, step.parameters.skip_back_faces);
    if (attachment)
        e.session.run(Attach{id, attachment});
    else
        e.session.notices.say(ui::NoticeKind::warning,
                              name_of(e.session.document(), id) + " lies on no object",
                              "Draw a stroke over one, and it is attached to that.", of_a_step);
}

void add_edit_actions(std::vector<Action>& a)
{
    const Menu edit(a, "Edit");
    edit("Undo", {ctrl('Z')}, [](Editor& e) { e.session.undo(); },
         {[](const Editor& e) { return e.session.scene().history().position() > 0; },
          "there is nothing to undo"});
    edit("Redo", {ctrl('Z', true), ctrl('Y')}, [](Editor& e) { e.session.redo(); },
         {[](const Editor& e) {
              const History& h = e.session.scene().history();
              return h.position() < h.steps().size();
          },
          "there is nothing to redo"});
    add_clipboard_actions(a);
    edit(
        "Duplicate", {{.key = 'D', .shift = true}, {.key = 'D', .ctrl = true}},
        [](Editor& e) {
            const Id first = e.session.committed().next_id;
            if (!e.session.run(Duplicate{chosen(e), {0, 0, 0}})) return;
            e.session.select_new(first);
            action(e, "Move").run(e); // else the copies hide in what they are copies of
        },
        something_selected(), true);
    edit(
        "Rename", {{ui::key_f1 + 1}},
        [](Editor& e) {
            const Id id = e.session.selected;
            e.outliner.renaming = id;
            e.outliner.new_name = name_of(e.session.document(), id);
            e.preferences.show_dock = true;
            e.only_view = false;
        },
        something_selected());
    edit(
        "Group", {ctrl('G')},
        [](Editor& e) {
            const Id group = e.session.committed().next_id;
            if (e.session.run(Group{chosen(e)})) e.session.selected = group;
        },
        something_selected());
    edit("Ungroup", {ctrl('G', true)},
         [](Editor& e) { e.session.run(Ungroup{e.session.selected}); },
         {[](const Editor& e) {
              const auto& objects = e.session.document().objects;
              const auto found = objects.find(e.session.selected);
              return found != objects.end() && kind_of(*found->second).holds_others;
          },
          "select a group first"});
    edit("Attach", {}, attach_selected,
         {[](const Editor& e) { return !laid(e, false).empty(); },
          "select a placed object that is not attached first"});
    edit("Detach", {}, detach_selected,
         {[](const Editor& e) { return !laid(e, true).empty(); },
          "select an attached object first"});
    edit("Parent", {ctrl('P')},
         [](Editor& e) {
             e.session.run(SetParent{e.session.selected.but_the_active(), e.session.selected});
         },
         {[](const Editor& e) { return e.session.selected.size() > 1; },
          "select the objects first, and their parent last"});
    edit("Clear parent", {alt('P')},
         [](Editor& e) {
             e.session.run(SetParent{chosen(e), 0});
         },
         {[](const Editor& e) {
              return std::ranges::any_of(
                  chosen(e), [&](Id id) { return object(e.session.document(), id).parent != 0; });
          },
          "select an object with a parent first"});
    edit("Remove from stroke", {}, [](Editor& e) { e.session.run(Unplace{e.session.selected}); },
         {[](const Editor& e) {
              const auto& objects = e.session.document().objects;
              const auto found = objects.find(e.session.selected);
              return found != objects.end() && found->second->stroke.has_value();
          },
          "select a placed object first"});
    edit(
        "Hide or show", {{'H'}},
        [](Editor& e) {
            const auto hidden = [&](Id id) { return object(e.session.document(), id).hidden; };
            const std::vector<Id> ids = chosen(e);
            if (std::all_of(ids.begin(), ids.end(), hidden))
                e.session.run(Show{ids});
            else
                e.session.run(Hide{ids});
        },
        something_selected());
    edit(
        "Lock or unlock", {},
        [](Editor& e) {
            const auto is_locked = [&](Id id) { return object(e.session.document(), id).locked; };
            const std::vector<Id> ids = chosen(e);
            if (std::all_of(ids.begin(), ids.end(), is_locked))
                e.session.run(Unlock{ids});
            else
                e.session.run(Lock{ids});
        },
        something_selected());
    edit(
        "Delete", {{ui::key_delete}, {'X'}},
        [](Editor& e) {
            if (e.tool_parts() && e.tool_parts()->remove(e.session)) return;
            const std::vector<Id> ids = deletable(e, "Nothing was deleted");
            if (!ids.empty()) delete_objects(e, ids);
        },
        something_selected());
    edit(
        "Find in the outliner", {ctrl('F')},
        [](Editor& e) {
            e.preferences.show_dock = true;
            e.only_view = false;
            e.outliner.focus_filter = true;
        },
        something_there());
    edit("Repeat last", {{.key = 'R', .shift = true}},
         [](Editor& e) {
             const auto command = repeated(e.session);
             if (!command) return;
             const Id first = e.session.committed().next_id;
             if (e.session.run(*command)) e.session.select_new(first);
         },
         {[](const Editor& e) { return repeated(e.session).has_value(); },
          "the last step cannot be repeated on the selection"});
    edit("Adjust last", {{ui::key_f1 + 8}},
         [](Editor& e) { e.adjustment.open = !e.adjustment.open; },
         {[](const Editor& e) { return e.adjustment.step != 0; }, "the last step has no numbers"});
}

} // namespace trivar
