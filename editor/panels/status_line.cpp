// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/key_actions.h"
#include "editor/actions/time_actions.h"
#include "editor/panels/panels.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

std::string facts(const Session& session)
{
    if (session.document().objects.empty()) return "Empty scene  ·  m";
    const Members selected(session.document(), session.selected.ids());
    std::size_t vertices = 0;
    for (const auto& [id, object] : session.evaluated().objects)
        if (session.selected == 0 || selected.contain(id))
            for (const Part& part : with_points(object->parts, object->curves))
                vertices += part.vertex_count();
    const std::size_t count = session.document().objects.size();
    const std::string what = session.selected != 0
                                 ? fmt::format("{} selected", session.selected.size())
                                 : fmt::format("{} object{}", count, count == 1 ? "" : "s");
    return fmt::format("{}  ·  {} vertices  ·  m", what, with_commas(vertices));
}

float input_width(const ui::Theme& theme, const std::string& input)
{
    if (input == "left" || input == "middle" || input == "right") return theme.px(12);
    if (input == "wheel") return theme.px(20);
    if (input == "/") return ui::text_width(theme.font.small, input);
    return std::max(theme.px(20), ui::text_width(theme.font.small, input) + theme.px(10));
}

void paint_input(const ui::Theme& theme, glm::vec2 at, float height, const std::string& input)
{
    if (input == "left")
        ui::paint_mouse(theme, at, height, ui::MouseGlyph::left);
    else if (input == "middle")
        ui::paint_mouse(theme, at, height, ui::MouseGlyph::middle);
    else if (input == "right")
        ui::paint_mouse(theme, at, height, ui::MouseGlyph::right);
    else if (input == "wheel")
        ui::paint_mouse(theme, at, height, ui::MouseGlyph::wheel);
    else if (input == "/")
        ui::paint_text(theme.font.small, ui::rect_at(at, {height, height}), theme.color.text_3,
                       "/");
    else
        ui::paint_keycap(theme, at, height, input);
}

std::vector<Hint> open_timeline_hints(const Editor& editor)
{
    const KeysView& keys = editor.timeline.keys;
    if (keys.gesture.by_key)
        return {{{"left"}, "Leave them here"},
                {{"Shift"}, "Finely"},
                {{"Ctrl"}, "Between frames"},
                {{"Esc"}, "Cancel"}};
    const bool any = !animated_ids(editor.session.document()).empty();
    if (any && keys.curves)
        return {{{"left"}, "Drag keys and handles"},
                {{"Alt", "left"}, "Break handles"},
                {{"right"}, "Interpolation"},
                {{"wheel"}, "Zoom"},
                {{"middle"}, "Pan"},
                {{"@Frame all"}, "Show all"}};
    if (!keys.chosen.empty())
        return {{{"left"}, "Drag to move"}, {{"Ctrl", "left"}, "Add or remove"},
                {{"Alt", "left"}, "Copy"},  {{"@Scale"}, "Scale about the frame"},
                {{"@Delete"}, "Delete"},    {{"right"}, "More"}};
    const std::string play = std::string("@") + play_action;
    if (any)
        return {{{"left"}, "Select keys, or draw a box"},
                {{play}, "Play"},
                {{std::string("@") + previous_key_action, "/", std::string("@") + next_key_action},
                 "Go from key to key"},
                {{"wheel"}, "Zoom the ruler"},
                {{"@Frame all"}, "Show all frames"}};
    return {{{"left"}, "Drag to a frame, or drag a bar"},
            {{play}, "Play"},
            {{"wheel"}, "Zoom the ruler"},
            {{"Shift", "wheel"}, "Roll"},
            {{"@Frame all"}, "Show all frames"},
            {{std::string("@") + timeline_action}, "Close"}};
}

std::vector<Hint> timeline_hints(const Editor& editor)
{
    if (editor.preferences.timeline_open) return open_timeline_hints(editor);
    return {{{"left"}, "Drag to a frame"},
            {{std::string("@") + play_action}, "Play"},
            {{std::string("@") + previous_frame_action, "/", std::string("@") + next_frame_action},
             "Frame"},
            {{std::string("@") + timeline_action}, "Open"}};
}

// The keys of a tutorial that do something now.
std::vector<Hint> tutorial_hints(const Editor& editor)
{
    std::vector<Hint> hints;
    const auto add = [&](const char* name, const char* verb) {
        if (is_enabled(editor, action(editor, name)))
            hints.push_back({{std::string("@") + name}, verb});
    };
    add(tutorial_next, "Next step");
    add(tutorial_back, "Step back");
    add(tutorial_close, "Leave the tutorial");
    hints.push_back({{"middle"}, "Orbit"});
    hints.push_back({{"wheel"}, "Zoom"});
    return hints;
}

// Returns the meaning of buttons and keys at the mouse; in the viewport the tool knows. Empty: none
// apply.
std::vector<Hint> hints_here(Editor& editor, const Layout& layout)
{
    const std::vector<Hint> of_tool = editor.active_tool().hints(editor.session);
    if (editor.active_tool().busy()) return of_tool;
    if (ImGui::GetTopMostPopupModal()) return {}; // a dialog says its own
    if (editor.timeline.hovered) return timeline_hints(editor);
    const ImGuiIO& io = ImGui::GetIO();
    if (const ImGuiInputTextState* typed = ImGui::GetInputTextState(ImGui::GetActiveID());
        typed && typed->ID != 0 && !typed->Stb.single_line)
        return {{{"Enter"}, "New line"}, {{"Ctrl", "Enter"}, "Apply"}, {{"Esc"}, "Restore"}};
    if (io.WantTextInput)
        return {{{"Enter"}, "Apply"}, {{"Tab"}, "Go to the next field"}, {{"Esc"}, "Restore"}};
    const glm::vec2 mouse{io.MousePos.x, io.MousePos.y};
    const bool sideways = ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeEW;
    if (sideways && (layout.inspector.contains(mouse) || layout.options.contains(mouse)))
        return {{{"left"}, "Drag to change"},
                {{"Shift"}, "Finely"},
                {{"Ctrl"}, "In steps"},
                {{"left"}, "Click to type"}};
    const bool over_dock =
        layout.dock && (layout.outliner.contains(mouse) || layout.inspector.contains(mouse));
    if (!over_dock && editor.tutorial.runs(editor.session)) return tutorial_hints(editor);
    if (!layout.dock) return of_tool;
    const bool rows = !editor.session.document().objects.empty();
    if (layout.outliner.contains(mouse) && rows)
        return {{{"left"}, "Select"},
                {{"Ctrl", "left"}, "Add or remove"},
                {{"left"}, "Drag to order"},
                {{"@Rename"}, "Rename"},
                {{"right"}, "Open the menu"}};
    if (!layout.inspector.contains(mouse)) return of_tool;
    switch (editor.tab) {
    case Editor::Tab::history: return {{{"left"}, "Go to this step"}, {{"wheel"}, "Scroll"}};
    case Editor::Tab::log: return {{{"left"}, "Choose lines"}, {{"Ctrl", "C"}, "Copy them"}};
    case Editor::Tab::inspector: return {{{"wheel"}, "Scroll"}};
    }
    return of_tool;
}

} // namespace

std::vector<std::string> inputs_now(const Editor& editor, const Hint& hint)
{
    std::vector<std::string> inputs = hint.inputs;
    // Two fingers orbit there.
    if (hint.verb == "Zoom" && editor.preferences.mouse.device == "trackpad")
        inputs.insert(inputs.begin(), "Ctrl");
    for (std::string& input : inputs) {
        if (!input.starts_with('@')) continue;
        input = key_text(action(editor, input.substr(1)));
        if (input.empty()) return {};
    }
    return inputs;
}

void draw_status_line(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.status;
    begin_panel("status line", r, c.base);
    const std::string right = facts(editor.session);
    const float room = r.hi.x - theme.px(36) - ui::text_width(theme.font.small, right);
    ui::paint_text(theme.font.small, {r.lo, r.hi - glm::vec2(theme.px(12), 0)}, c.text_2, right,
                   ui::Align::right);
    float x = r.lo.x + theme.px(12);
    for (const Hint& hint : hints_here(editor, layout)) {
        const std::vector<std::string> inputs = inputs_now(editor, hint);
        if (inputs.empty() && !hint.inputs.empty()) continue;
        // A name in it must not push the others out; the hint for the present gesture is shown
        // whole.
        const bool tells = hint.inputs.empty();
        const std::string verb = ui::elided(
            theme.font.small, hint.verb, tells ? std::max(room - x, theme.px(64)) : theme.px(240));
        float width = ui::text_width(theme.font.small, verb) + theme.px(2);
        for (const std::string& input : inputs) width += input_width(theme, input) + theme.px(4);
        if (x + width > room) break; // hints drop from the right, facts never
        for (const std::string& input : inputs) {
            paint_input(theme, {x, r.lo.y}, r.height(), input);
            x += input_width(theme, input) + theme.px(4);
        }
        x += theme.px(2);
        ui::paint_text(theme.font.small, {{x, r.lo.y}, r.hi}, tells ? c.text : c.text_2, verb);
        float verb_width = ui::text_width(theme.font.small, verb);
        // It grows in steps, so that the others do not dance with its digits.
        if (tells) verb_width = theme.px(32) * std::ceil(verb_width / theme.px(32));
        x += verb_width + theme.px(18);
    }
    ImGui::End();
}

} // namespace trivar
