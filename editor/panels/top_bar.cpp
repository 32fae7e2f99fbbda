// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "editor/panels/panels.h"

#include "editor/session/done_titles.h"
#include "editor/session/scene_names.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// The mark: three planes of a lattice.
void paint_mark(const ui::Theme& theme, glm::vec2 at)
{
    for (int k = 0; k < 3; ++k) {
        const auto n = static_cast<float>(k);
        const auto p = [&](float x, float y) {
            return at + glm::vec2(2.5f * n + x, 4 * n + y) * theme.scale;
        };
        ui::paint_path({p(8, 0), p(16, 4), p(8, 8), p(0, 4)},
                       ui::faded(theme.color.lattice, k == 0   ? 1
                                                      : k == 1 ? 0.65f
                                                               : 0.4f),
                       1.4f * theme.scale, true);
    }
}

struct State {
    std::string name, words;
    ui::Color color;
};
State state_of(const Editor& editor, const ui::Palette& c)
{
    const SceneFile& scene = editor.session.scene();
    const bool named = !scene.path().empty();
    const std::string name = title_of(scene);
    if (!scene.trouble().empty()) return {name, "Not saved", c.bad};
    if (named) return {name, "All changes saved", c.text_3};
    if (scene.look_only()) return {name, "Follows the file", c.text_3};
    const bool nothing = scene.as_opened();
    return {name, nothing ? "No changes" : "Not saved yet", nothing ? c.text_3 : c.warn};
}

// Draws the button that leads to every command, and to its key. Returns where it begins.
float search_button(Editor& editor, const ui::Theme& theme, const ui::Rect& bar)
{
    const ui::Palette& c = theme.color;
    const Action& find = action(editor, palette_action);
    const bool narrow = bar.width() < theme.px(760);
    const float width = theme.px(narrow ? 36 : bar.width() < theme.px(1200) ? 128 : 208);
    const ui::Rect r = {{bar.hi.x - theme.px(12) - width, bar.lo.y + theme.px(6)},
                        {bar.hi.x - theme.px(12), bar.hi.y - theme.px(6)}};
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    if (ImGui::InvisibleButton("search", {r.width(), r.height()})) find.run(editor);
    ui::paint_box(r, ImGui::IsItemHovered() ? c.field_hover : c.field, theme.size.rounding);
    ui::tooltip({"Find a command", key_text(find), "Finds any command by name and shows its key."});
    const ui::Rect in = {r.lo + glm::vec2(theme.px(8), 0), r.hi - glm::vec2(theme.px(8), 0)};
    if (narrow) {
        ui::paint_text(theme.font.body, r, c.text_2, ui::icon::search, ui::Align::center);
        return r.lo.x;
    }
    const float left = in.lo.x + theme.px(22);
    const bool roomy = width > theme.px(160);
    ui::paint_text(theme.font.body, in, c.text_2, ui::icon::search);
    ui::paint_text(theme.font.body, {{left, in.lo.y}, in.hi}, c.text_2,
                   roomy ? "Search commands" : "Search");
    ui::paint_text(theme.font.small, in, c.text_2, key_text(find), ui::Align::right);
    return r.lo.x;
}

// Words the step that the button would undo or redo: "Undo Width of Snake 0.24 m".
std::string words_of_step(const Session& session, bool undo)
{
    const History& history = session.scene().history();
    const std::size_t step = history.position() + (undo ? 0 : 1); // counted from 1
    if (step == 0 || step > history.steps().size()) return {};
    const Document& before = step == 1 ? history.start() : history.steps()[step - 2].result;
    const History::Step& done = history.steps()[step - 1];
    return " " + done_title(session, done.command, before, done.result).text();
}

} // namespace

void draw_top_bar(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.top;
    begin_panel("top bar", r, c.header);
    paint_mark(theme, {theme.px(13), theme.px(12)});
    const glm::vec2 square(theme.size.icon_button);
    const float search = search_button(editor, theme, r);
    // Where there is little room menus stand closer, and then buttons that have a key leave.
    const MenuBarWidths menus = menu_bar_widths(theme);
    constexpr float least_spread = 0.35f;
    const float least_end =
        r.lo.x + theme.px(menus_left_px) + menus.names + least_spread * menus.between;
    float buttons = search - theme.px(24) - 3 * square.x - theme.px(4);
    const bool steps = least_end <= buttons;
    if (!steps) buttons = search - theme.px(12) - square.x;
    const bool record = least_end <= buttons;
    if (!record) buttons = search - theme.px(8);
    const float room_of_menus = buttons - r.lo.x - theme.px(menus_left_px);
    const float menus_end = draw_menu_bar(
        editor, theme, r, std::clamp((room_of_menus - menus.names) / menus.between, 0.1f, 1.0f));

    const State state = state_of(editor, c);
    const float left = menus_end + theme.px(16);
    const float words = ui::text_width(theme.font.small, state.words);
    const float room = buttons - left - words - theme.px(28);
    const float least = theme.px(40), whole = ui::text_width(theme.font.strong, state.name);
    const bool has_words = room > least; // they go first, then the name
    const float name = std::min(whole, has_words ? room : buttons - left - theme.px(12));
    const float total = name + (has_words ? theme.px(12) + words : 0);
    const float x = std::max(left, std::round((layout.view.lo.x + layout.view.hi.x - total) / 2));
    if (name >= std::min(whole, least))
        ui::name_text(theme.font.strong, {{x, r.lo.y}, {x + name, r.hi.y}}, c.text, state.name);
    if (has_words)
        ui::paint_text(theme.font.small, {{x + total - words, r.lo.y}, r.hi}, state.color,
                       state.words);
    float at = buttons;
    for (const char* what : {"Undo", "Redo"}) {
        if (!steps) break;
        ImGui::SetCursorScreenPos({at, r.lo.y + theme.px(8)});
        const Action& each = action(editor, what);
        const char* icon = each.name == "Undo" ? ui::icon::undo : ui::icon::redo;
        const std::string step = words_of_step(editor.session, each.name == "Undo");
        ui::Tip tip = tip_of(editor, each);
        tip.name += step;
        if (ui::icon_button(theme, what, icon, square, tip, {.enabled = is_enabled(editor, each)}))
            each.run(editor);
        at += square.x + theme.px(4);
    }
    if (record)
        draw_record_button(editor, theme, {steps ? at + theme.px(4) : at, r.lo.y + theme.px(8)});
    ImGui::End();
}

} // namespace trivar
