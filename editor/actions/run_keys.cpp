// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/run_keys.h"

#include "editor/actions/actions.h"
#include "editor/actions/lent_tool.h"
#include "editor/actions/start_card.h"
#include "editor/editor.h"
#include "ui/input.h"
#include "ui/sentence.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {

namespace {

// Space emulates the middle button, so its own action fires on release, if nothing else happened.
bool space_was_tapped(Editor& editor)
{
    auto& space = editor.memory.of<HeldSpace>();
    if (ui::struck({ui::key_space})) space = {.down = true};
    if (!space.down) return false;
    const ImGuiIO& io = ImGui::GetIO();
    space.used = space.used || editor.active_tool().busy() || editor.files.asking() ||
                 std::ranges::count(io.MouseDown, true) > 0 || ImGui::IsAnyItemActive() ||
                 ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
    space.down = ui::is_down(ui::key_space);
    return !space.down && !space.used;
}

struct OpenPopups { // as the frame before ended
    int count = 0;
};

// Menus and drop-downs, but not the dialog that they belong to, which takes the next Esc.
void close_menus()
{
    const ImVector<ImGuiPopupData>& open = GImGui->OpenPopupStack;
    int dialogs = 0;
    while (dialogs < open.Size && open[dialogs].Window &&
           (open[dialogs].Window->Flags & ImGuiWindowFlags_Modal) != 0)
        ++dialogs;
    if (dialogs == open.Size) return;
    ImGui::ClosePopupToLevel(dialogs, true);
    ui::swallow_keys();
}

} // namespace

void remember_popups(Editor& editor)
{
    editor.memory.of<OpenPopups>().count = GImGui->OpenPopupStack.Size;
}

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
    if (escape() && GImGui->OpenPopupStack.Size < editor.memory.of<OpenPopups>().count) {
        ui::swallow_keys(); // a menu closed itself by this very Esc, as the frame began
        return;
    }
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) {
        if (escape()) close_menus();
        return;
    }
    if (editor.files.asking()) return;
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
    const Action* greyed = nullptr; // the first that cannot run
    for (const Action& each : editor.actions) {
        if (each.keys_in != KeysIn::anywhere && each.keys_in != here) continue;
        const auto chord = std::ranges::find_if(each.keys, [&](const ui::Chord& one) {
            if (space_waits && one == ui::Chord{ui::key_space}) return space_tapped;
            return ui::struck(one, each.repeats) && !tool.awaits(one) &&
                   !ui::hands().keeps(one.key);
        });
        if (chord == each.keys.end()) continue;
        if (!is_enabled(editor, each)) {
            if (!greyed) greyed = &each;
            continue;
        }
        const std::size_t tool_before = editor.tool;
        const int key = chord->key; // the action may give it to another
        each.run(editor);
        lend_tool_while_held(editor, key, tool_before);
        return; // one press, one action
    }
    if (greyed && !greyed->enabled.otherwise.empty())
        editor.session.notices.say(ui::NoticeKind::warning, greyed->name + " is not possible now",
                                   ui::sentence(greyed->enabled.otherwise), "a greyed key");
}

} // namespace trivar
