// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/command.h"
#include "core/scene/tries.h"
#include "editor/panels/panels.h"
#include "editor/session/done_titles.h"
#include "editor/session/scene_names.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

// A line of the list: the state after so many steps in force, the heading of what once followed
// it instead, or a step of such a branch.
struct Line {
    enum Kind { step, fork, other } kind = step;
    std::size_t after = 0;          // steps; of a fork and its steps: where they leave
    std::size_t branch = 0, at = 0; // other: the branch and the step in it
};

// Where the list keeps whether it is open, whatever is being drawn.
ImGuiID fork_id(std::size_t after)
{
    return ImHashData(&after, sizeof after);
}

std::vector<Line> lines_of(const History& history)
{
    std::vector<Line> lines;
    lines.reserve(history.steps().size() + 1);
    std::vector<std::vector<std::size_t>> leaving(
        history.branches().empty() ? 0 : history.steps().size() + 1);
    for (std::size_t b = 0; b < history.branches().size(); ++b)
        if (!is_replaced_try(history, b)) leaving[history.branches()[b].from].push_back(b);
    for (std::size_t i = 0; i <= history.steps().size(); ++i) {
        lines.push_back({Line::step, i});
        if (leaving.empty() || leaving[i].empty()) continue;
        lines.push_back({Line::fork, i});
        if (!ImGui::GetStateStorage()->GetBool(fork_id(i))) continue;
        for (const std::size_t b : leaving[i])
            for (std::size_t k = 0; k < history.branches()[b].steps.size(); ++k)
                lines.push_back({Line::other, i, b, k});
    }
    return lines;
}

const Document& state_after(const History& history, std::size_t steps)
{
    return steps == 0 ? history.start() : history.steps()[steps - 1].result;
}

// Returns the document to which the line leads; null: it leads only to more lines.
const Document* document_of(const History& history, const Line& line)
{
    if (line.kind == Line::fork) return nullptr;
    if (line.kind == Line::step) return &state_after(history, line.after);
    return &history.branches()[line.branch].steps[line.at].result;
}

StepTitle title_of(const Session& session, const Line& line)
{
    const History& history = session.scene().history();
    if (line.kind == Line::fork) {
        std::size_t count = 0;
        for (std::size_t b = 0; b < history.branches().size(); ++b)
            if (const History::Branch& each = history.branches()[b];
                each.from == line.after && !is_replaced_try(history, b))
                count += each.steps.size();
        return {fmt::format("Other steps ({})", count), {}};
    }
    if (line.kind == Line::step) {
        if (line.after == 0) return {"Empty scene", {}};
        const History::Step& done = history.steps()[line.after - 1];
        return done_title(session, done.command, state_after(history, line.after - 1), done.result);
    }
    const std::vector<History::Step>& steps = history.branches()[line.branch].steps;
    const Document& before =
        line.at == 0 ? state_after(history, line.after) : steps[line.at - 1].result;
    return done_title(session, steps[line.at].command, before, steps[line.at].result);
}

const char* icon_of(const Command& command)
{
    switch (nature_of(command).icon) {
    case CommandIcon::add: return ui::icon::add;
    case CommandIcon::import_model: return ui::icon::import;
    case CommandIcon::place: return ui::icon::place;
    case CommandIcon::move: return ui::icon::move;
    case CommandIcon::material: return ui::icon::drop;
    case CommandIcon::rename: return ui::icon::pencil;
    case CommandIcon::hide: return ui::icon::hidden;
    case CommandIcon::show: return ui::icon::eye;
    case CommandIcon::lock: return ui::icon::lock;
    case CommandIcon::unlock: return ui::icon::open_lock;
    case CommandIcon::remove: return ui::icon::trash;
    case CommandIcon::copy: return ui::icon::copy;
    case CommandIcon::group: return ui::icon::group;
    case CommandIcon::camera: return ui::icon::camera;
    case CommandIcon::values: break;
    }
    return ui::icon::sliders;
}

const char* icon_of(const History& history, const Line& line)
{
    if (line.kind == Line::fork)
        return ImGui::GetStateStorage()->GetBool(fork_id(line.after)) ? ui::icon::open
                                                                      : ui::icon::closed;
    if (line.kind == Line::other)
        return icon_of(history.branches()[line.branch].steps[line.at].command);
    return line.after == 0 ? ui::icon::file : icon_of(history.steps()[line.after - 1].command);
}

// Where the mouse was when the list last changed.
struct MouseAtChange {
    std::vector<std::size_t> list;
    glm::vec2 at{0};
};

// Whether the mouse moved since the rows changed: rows that change places under a mouse at rest are
// not the ones that it was put on.
bool has_moved_since_a_change(Editor& editor, const History& history)
{
    constexpr float moved_px = 2;
    const glm::vec2 mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
    auto& last = editor.memory.of<MouseAtChange>();
    const std::vector<std::size_t> now{history.position(), history.steps().size(),
                                       history.branches().size()};
    if (last.list != now) last = {now, mouse};
    return glm::distance(mouse, last.at) > moved_px;
}

struct PointerState {
    bool clicked = false, lingers = false; // the mouse is there for a moment
};
PointerState draw_line(const ui::Theme& theme, const Session& session, const Line& line,
                       const ui::Rect& row)
{
    const History& history = session.scene().history();
    constexpr float patience_s = 0.3f;
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    PointerState pointed;
    pointed.clicked = ImGui::InvisibleButton("step", {row.width(), row.height()});
    const bool step = line.kind == Line::step;
    const bool present = step && line.after == history.position();
    const bool undone = !step || line.after > history.position();
    const ui::Rect band = {row.lo + glm::vec2(theme.px(4), theme.px(1)),
                           row.hi - glm::vec2(theme.px(4), theme.px(1))};
    const bool hovered = ImGui::IsItemHovered();
    pointed.lingers = hovered && GImGui->HoveredIdTimer > patience_s;
    if (present)
        ui::paint_box(band, c.row_selected, theme.size.rounding_small);
    else if (hovered)
        ui::paint_box(band, c.row_hover, theme.size.rounding_small);
    if (step && line.after == history.position() + 1) // what is below is undone
        ui::paint_box({{row.lo.x, row.lo.y}, {row.hi.x, row.lo.y + theme.size.hairline}},
                      c.line_soft);
    const StepTitle title = title_of(session, line);
    const ui::Color quiet = present || hovered ? c.text_2 : c.text_3;
    const float pad = theme.size.padding;
    const float indent = line.kind == Line::other ? theme.px(16) : 0;
    const float left = row.lo.x + pad + theme.px(24) + indent;
    if (line.kind == Line::other && line.at == 0) // each branch begins with a rule
        ui::paint_box({{left, row.lo.y}, {row.hi.x - pad, row.lo.y + theme.size.hairline}},
                      c.line_soft);
    ui::paint_text(theme.font.body, {row.lo + glm::vec2(pad + indent, 0), row.hi}, quiet,
                   icon_of(history, line));
    const ImFont* font = present ? theme.font.strong : theme.font.body;
    const float most = (row.width() - theme.px(60)) / 2;
    const std::string number = ui::elided(theme.font.small, title.number, most);
    const float end =
        row.hi.x - pad - (number.empty() ? 0 : ui::text_width(theme.font.small, number) + pad);
    const std::string words = ui::elided(font, title.words, end - left);
    ui::paint_text(font, {{left, row.lo.y}, row.hi}, undone ? quiet : c.text, words);
    ui::paint_text(theme.font.small, {row.lo, row.hi - glm::vec2(pad, 0)},
                   undone ? quiet : c.text_2, number, ui::Align::right);
    const bool cut = words != title.words || number != title.number;
    if (cut || ImGui::GetIO().MousePos.x < left)
        ui::tooltip({title.text(),
                     {},
                     line.kind == Line::fork
                         ? "Steps that were undone before other steps were made."
                         : "Click to go there; what comes after it is kept."});
    return pointed;
}

void draw_footer(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    const SceneFile& scene = editor.session.scene();
    const std::size_t count = scene.history().steps().size(), now = scene.history().position();
    const std::string number = (now < count ? with_commas(now) + " of " : "") + with_commas(count);
    const char* save = "Save without undone steps...";
    const float width = ui::text_width(theme.font.body, save) + theme.px(24);
    const ui::Rect inside = {r.lo + glm::vec2(theme.size.padding, 0),
                             {r.hi.x - width - theme.px(8), r.hi.y}};
    const auto fits = [&](const std::string& words) {
        return ui::text_width(theme.font.small, words) <= inside.width();
    };
    std::string words = number + (count == 1 ? " step" : " steps");
    if (!fits(words)) words = number;
    const std::string where = words + "  ·  in the scene file";
    if (!scene.path().empty() && scene.trouble().empty() && fits(where)) words = where;
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line);
    ui::paint_text(theme.font.small, inside, c.text_3,
                   ui::elided(theme.font.small, words, inside.width()));
    ImGui::SetCursorScreenPos({r.hi.x - width, r.lo.y + theme.px(6)});
    if (ui::button(theme, save, ui::ButtonKind::quiet, {width, theme.px(28)}))
        editor.files.ask_save_compact();
    ui::tooltip(
        {"Save without undone steps", {}, "Writes only the steps in force, under another name."});
}

} // namespace

void draw_history(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const History& history = editor.session.scene().history();
    const ui::Rect& r = layout.inspector;
    begin_panel("history", r, c.panel);
    const std::size_t count = history.steps().size();
    if (count == 0) {
        ui::empty_state(theme, r, ui::icon::history, "No steps yet",
                        "Steps appear here. Each can be returned to.");
        ImGui::End();
        return;
    }
    const float foot = theme.px(40), height = theme.px(28);
    draw_footer(editor, theme, {{r.lo.x, r.hi.y - foot}, r.hi});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("steps", {r.width(), std::max(1.0f, r.height() - foot)});
    const std::vector<Line> lines = lines_of(history);
    // Follows the present when that moved, and otherwise stays where it was scrolled to.
    const auto now = static_cast<int>(history.position());
    int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("shown"), -1);
    if (shown != now) {
        const auto present = std::ranges::find_if(lines, [&](const Line& line) {
            return line.kind == Line::step && line.after == history.position();
        });
        const float top = height * static_cast<float>(present - lines.begin());
        const float view = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
        if (top < scroll || top + height > scroll + view)
            ImGui::SetScrollY(std::max(0.0f, top - (view - height) / 2));
        shown = now;
    }
    const Line *go_to = nullptr, *previewed = nullptr;
    const bool may_preview = has_moved_since_a_change(editor, history);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const Line& line = lines[static_cast<std::size_t>(i)];
            const PointerState pointed = draw_line(
                theme, editor.session, line, ui::rect_at({r.lo.x, at.y}, {r.width(), height}));
            if (pointed.clicked) go_to = &line;
            if (pointed.lingers && may_preview) previewed = &line;
            ImGui::PopID();
        }
    if (go_to && go_to->kind == Line::fork) {
        bool& open = *ImGui::GetStateStorage()->GetBoolRef(fork_id(go_to->after));
        open = !open;
        go_to = nullptr;
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    Session& session = editor.session;
    const bool elsewhere =
        previewed && !(previewed->kind == Line::step && previewed->after == history.position());
    session.preview(elsewhere && !go_to ? document_of(history, *previewed) : nullptr);
    const bool keys = editor.panel == Editor::Panel::dock && !ImGui::GetIO().WantTextInput &&
                      !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (keys && ImGui::IsKeyPressed(ui::key_up)) session.undo();
    if (keys && ImGui::IsKeyPressed(ui::key_down)) session.redo();
    if (go_to && go_to->kind == Line::step) session.go_to_step(go_to->after);
    if (go_to && go_to->kind == Line::other) session.go_to_branch(go_to->branch, go_to->at + 1);
    ImGui::End();
}

} // namespace trivar
