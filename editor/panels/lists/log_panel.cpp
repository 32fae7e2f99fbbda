// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/log_lines.h"
#include "editor/commands/run_lines.h"
#include "editor/commands/typed_command.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/sentence.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace trivar {
namespace {

// The next text in quotes, which is taken off the front; empty: none.
std::string_view take_quoted(std::string_view& line)
{
    const std::size_t begin = line.find('"');
    const std::size_t end = begin == line.npos ? begin : line.find('"', begin + 1);
    if (end == line.npos) return {};
    const std::string_view text = line.substr(begin + 1, end - begin - 1);
    line.remove_prefix(end + 1);
    return text;
}

// "rename" and its fields as they stand; of {"undo":true} only the first.
struct Parts {
    std::string_view verb, rest;
};
Parts parts_of(std::string_view line)
{
    std::string_view rest = line;
    const std::string_view key = take_quoted(rest);
    if (key == "undo" || key == "redo") return {key, {}};
    if (key != "do") return {key == "trivar" ? "header" : "check", line};
    const std::string_view verb = take_quoted(rest);
    rest.remove_prefix(std::min(rest.find_first_not_of(", "), rest.size()));
    rest.remove_suffix(rest.size() - std::min(rest.find_last_not_of("} ") + 1, rest.size()));
    return {verb, rest};
}

// Between the number and the copy button.
float room_in(const ui::Theme& theme, float width)
{
    return width - theme.px(48 + 40);
}

// Returns why it was refused, in full.
std::vector<std::string> reasons(const ui::Theme& theme, const LogEntry& entry, float width)
{
    return ui::wrapped(theme.font.mono, ui::sentence(std::string(entry.why)),
                       room_in(theme, width));
}

// Returns the height of a line. It runs for every line of the file in every frame, so it does not
// read long ones to their end.
float height_of(const ui::Theme& theme, const LogEntry& entry, float width)
{
    if (entry.number == 0)
        return theme.px(25) +
               theme.px(17) * static_cast<float>(reasons(theme, entry, width).size());
    constexpr std::size_t longer_than_a_bare_verb = 40;
    std::string_view line = entry.line;
    if (line.size() > longer_than_a_bare_verb && take_quoted(line) == "do") return theme.px(42);
    return parts_of(entry.line).rest.empty() ? theme.px(26) : theme.px(42);
}

void draw_entry(const ui::Theme& theme, const LogEntry& entry, const ui::Rect& row, bool selected)
{
    const ui::Palette& c = theme.color;
    const bool refused = entry.number == 0;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton("line", {row.width(), row.height()});
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    if (selected) ui::paint_box(row, c.row_selected);
    if (hovered)
        ui::paint_box({row.lo + glm::vec2(theme.px(4), 0), row.hi - glm::vec2(theme.px(4), 0)},
                      c.row_hover, theme.size.rounding_small);
    const float line = theme.px(17), top = row.lo.y + theme.px(4);
    const float left = row.lo.x + theme.px(48);
    const float right = left + room_in(theme, row.width());
    const ImFont* font = theme.font.mono;
    const Parts parts = parts_of(entry.line);
    ui::paint_text(font, {{row.lo.x, top}, {row.lo.x + theme.px(36), top + line}},
                   hovered || selected ? c.text_2 : c.text_3,
                   refused ? "–" : std::to_string(entry.number), ui::Align::right);
    ui::paint_text(font, {{left, top}, {right, top + line}}, refused ? c.bad : c.accent_text,
                   ui::elided(font, std::string(parts.verb), right - left));
    if (refused) {
        float y = top;
        for (const std::string& words : reasons(theme, entry, row.width())) {
            y += line;
            ui::paint_text(font, {{left, y}, {right, y + line}}, c.bad, words);
        }
    } else if (!parts.rest.empty()) {
        // Only the visible part is laid out; a stroke has tens of thousands of letters.
        const std::string_view shown = parts.rest.substr(0, 200);
        ui::paint_text(font, {{left, top + line}, {right, top + 2 * line}}, c.text_2,
                       ui::elided(font, std::string(shown), right - left));
    }
    const glm::vec2 square(theme.size.icon_button);
    if (!hovered && !ImGui::IsMouseHoveringRect({right, row.lo.y}, {row.hi.x, row.hi.y})) return;
    ImGui::SetCursorScreenPos({right + theme.px(4), std::round(row.center().y - square.y / 2)});
    if (ui::icon_button(theme, "copy", ui::icon::copy, square,
                        {"Copy this line", {}, "Copies the line of the scene file."}))
        ImGui::SetClipboardText(std::string(entry.line).c_str());
}

// A press takes a line, a drag those between.
void select_lines(Editor& editor, const std::vector<LogEntry>& entries, std::size_t under)
{
    auto& lines = editor.memory.of<LogLines>();
    const bool over = under < entries.size() && ImGui::IsWindowHovered();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && over)
        lines = {.from = under, .to = under, .dragging = true};
    if (lines.dragging && under < entries.size()) lines.to = under;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) lines.dragging = false;
}

void draw_entries(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const Session& session = editor.session;
    const auto& chosen = editor.memory.of<LogLines>();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("lines", {r.width(), std::max(1.0f, r.height())});
    const std::vector<LogEntry> entries = log_entries(session);
    const ImVec2 top = ImGui::GetCursorScreenPos();
    float y = top.y;
    std::size_t under = entries.size();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const float height = height_of(theme, entries[i], r.width());
        const ui::Rect row = {{r.lo.x, y}, {r.hi.x, y + height}};
        y += height;
        if (row.hi.y < r.lo.y || row.lo.y > r.hi.y) continue;
        if (row.contains({mouse.x, mouse.y})) under = i;
        const bool selected = chosen.from && i >= std::min(*chosen.from, chosen.to) &&
                              i <= std::max(*chosen.from, chosen.to);
        ImGui::PushID(static_cast<int>(i));
        draw_entry(theme, entries[i], row, selected);
        ImGui::PopID();
    }
    select_lines(editor, entries, under);
    ImGui::SetCursorScreenPos(top);
    ImGui::Dummy({1, y - top.y});
    // The newest line comes into view when it is written, and stays there in a smaller panel.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const auto count = static_cast<int>(entries.size()), height = static_cast<int>(r.height());
    int& shown = *storage.GetIntRef(ImGui::GetID("shown"), -1);
    int& shown_height = *storage.GetIntRef(ImGui::GetID("height"), -1);
    int& at_end = *storage.GetIntRef(ImGui::GetID("end"), 1);
    const bool more = std::exchange(shown, count) != count;
    const bool resized = std::exchange(shown_height, height) != height;
    if (more || (resized && at_end))
        ImGui::SetScrollY(y - top.y);
    else
        at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1;
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void run_field(Editor& editor)
{
    CommandField& field = editor.command_field;
    field.words.clear();
    field.focus = true;
    field.trouble = run_typed(editor.session, field.text);
    if (!field.trouble.empty()) return;
    field.before.push_back(std::exchange(field.text, {}));
    field.recalled = 0;
}

// Several lines on the clipboard are no text for a field of one: they are run. Whether they were.
bool run_pasted(Editor& editor)
{
    if (!editor.command_field.active || !ImGui::GetIO().KeyCtrl || !ImGui::IsKeyPressed('V', false))
        return false;
    const char* text = ImGui::GetClipboardText();
    if (!text || !holds_lines(text)) return false;
    ImGui::ClearActiveID(); // else the field would take them as one line
    editor.command_field.focus = true;
    run_lines(editor.session, text);
    return true;
}

// Tab continues the word, the arrows bring back what was typed before.
int help_typing(ImGuiInputTextCallbackData* data)
{
    auto& editor = *static_cast<Editor*>(data->UserData);
    CommandField& field = editor.command_field;
    const auto put = [&](const std::string& text) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, text.c_str());
    };
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
        const Completion completion = completed(
            {data->Buf, static_cast<std::size_t>(data->BufTextLen)}, editor.session.committed());
        field.words = completion.words;
        if (completion.words.size() == 1) field.words.clear();
        field.offered = completion.text;
        put(completion.text);
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
        const bool back = data->EventKey == ImGuiKey_UpArrow;
        if (back && field.recalled < field.before.size())
            ++field.recalled;
        else if (!back && field.recalled > 0)
            --field.recalled;
        put(field.recalled == 0 ? "" : field.before[field.before.size() - field.recalled]);
    }
    return 0;
}

// Returns the fault of the typed command, or the possible continuations.
std::vector<std::string> told_by_field(const Editor& editor, const ui::Theme& theme, float width)
{
    constexpr std::size_t most = 4;
    const CommandField& field = editor.command_field;
    std::string words = field.trouble.empty() ? "" : ui::sentence(field.trouble);
    if (words.empty())
        for (const std::string& word : field.words) words += (words.empty() ? "" : "  ") + word;
    std::vector<std::string> lines = ui::wrapped(theme.font.small, words, width);
    if (lines.size() > most) {
        lines.resize(most);
        lines.back() = ui::elided(theme.font.small, lines.back() + " …", width);
    }
    return lines;
}

void draw_field(Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                const std::vector<std::string>& told)
{
    const ui::Palette& c = theme.color;
    CommandField& field = editor.command_field;
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line);
    float y = r.lo.y + theme.px(8);
    for (const std::string& words : told) {
        ui::paint_text(theme.font.small,
                       {{r.lo.x + theme.size.padding, y}, {r.hi.x, y + theme.px(18)}},
                       field.trouble.empty() ? c.text_2 : c.bad, words);
        y += theme.px(18);
    }
    const float left = r.lo.x + theme.size.padding, right = r.hi.x - theme.size.padding;
    const ui::Rect box = {{left, r.hi.y - theme.px(32)}, {right, r.hi.y - theme.px(8)}};
    // A frame of its own, so that a long line does not run below the mark before it.
    ui::paint_box(box, c.field, theme.size.rounding_small);
    ImGui::SetCursorScreenPos({box.lo.x + theme.px(24), box.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, theme.px(5)});
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushFont(theme.font.mono);
    ImGui::SetNextItemWidth(box.width() - theme.px(32));
    if (!run_pasted(editor) && std::exchange(field.focus, false)) ImGui::SetKeyboardFocusHere();
    const std::string was = field.text;
    const bool enter = ImGui::InputText("##command", &field.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue |
                                            ImGuiInputTextFlags_CallbackCompletion |
                                            ImGuiInputTextFlags_CallbackHistory,
                                        help_typing, &editor);
    const bool active = field.active = ImGui::IsItemActive();
    if (!active || field.text != field.offered) field.words.clear();
    if (ImGui::IsItemEdited() && field.text != was) field.trouble.clear();
    ImGui::PopFont();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (active) ui::paint_rim(box, c.focus, theme.size.rounding_small, 1.5f * theme.scale);
    ui::paint_text(theme.font.body, {box.lo + glm::vec2(theme.px(9), 0), box.hi}, c.text_2,
                   ui::icon::closed);
    if (field.text.empty() && !active)
        ui::paint_text(theme.font.body, {box.lo + glm::vec2(theme.px(24), 0), box.hi}, c.text_3,
                       "Type a command, Tab completes");
    if (enter) run_field(editor);
}

} // namespace

void draw_log(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Rect& r = layout.inspector;
    // Copying copies objects once the hand went to them.
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool elsewhere =
        layout.view.contains({mouse.x, mouse.y}) || layout.outliner.contains({mouse.x, mouse.y});
    if (elsewhere && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
        !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId))
        editor.memory.of<LogLines>() = {};
    begin_panel("log", r, theme.color.panel);
    const auto told = told_by_field(editor, theme, r.width() - 2 * theme.size.padding);
    const float foot = theme.px(40) + (told.empty() ? 0 : theme.px(4)) +
                       theme.px(18) * static_cast<float>(told.size());
    draw_entries(editor, theme, {r.lo, {r.hi.x, r.hi.y - foot}});
    draw_field(editor, theme, {{r.lo.x, r.hi.y - foot}, r.hi}, told);
    ImGui::End();
}

} // namespace trivar
