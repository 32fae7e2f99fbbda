// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/help_actions.h"
#include "editor/actions/words_with_keys.h"
#include "editor/panels/panels.h"
#include "editor/words/markdown.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr const char* own_words =
    "This step is your own. Go on with the scene as you like, or take the step back with @Undo. "
    "**Help > Tutorials** starts the tutorial again.";

std::vector<ui::Run> runs_of(const Editor& editor)
{
    const std::string& note = editor.tutorial.note(editor.session);
    const std::vector<Block> blocks = blocks_of(note.empty() ? own_words : note);
    return blocks.empty() ? std::vector<ui::Run>{} : with_keys(editor, blocks.front().runs);
}

// One dot a step, those that were seen filled.
void paint_dots(const ui::Theme& theme, const ui::Rect& r, std::size_t step, std::size_t count)
{
    constexpr std::size_t most = 24; // beyond that the numbers must do
    if (count > most) return;
    const float pitch = theme.px(10);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 at{r.lo.x + theme.px(4) + pitch * static_cast<float>(i), r.center().y};
        ui::paint_dot(at, (i + 1 == step ? 3.5f : 2.5f) * theme.scale,
                      i < step ? theme.color.accent_text : theme.color.text_off);
    }
}

// Right to left; what cannot be done is not offered.
void card_button(Editor& editor, const ui::Theme& theme, glm::vec2& upper_right, const char* name,
                 const char* words, ui::ButtonKind kind)
{
    const Action& each = action(editor, name);
    if (!is_enabled(editor, each)) return;
    const std::string key = key_text(each);
    const float width = ui::text_width(theme.font.strong, words) +
                        ui::text_width(theme.font.small, key) + theme.px(40);
    upper_right.x -= width;
    ImGui::SetCursorScreenPos({upper_right.x, upper_right.y});
    if (ui::button(theme, words, kind, {width, theme.px(32)}, nullptr, key)) each.run(editor);
    upper_right.x -= theme.px(8);
}

void paint_stroke(const Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    std::vector<glm::vec2> path;
    for (const glm::dvec2 p : editor.tutorial.stroke(editor.session))
        path.push_back(view.lo + glm::vec2(p));
    if (path.size() < 2) return;
    ui::paint_path(path, theme.color.halo, 5 * theme.scale);
    ui::paint_path(path, theme.color.stroke, 3 * theme.scale);
    ui::paint_dot(path.back(), theme.px(6), theme.color.stroke, theme.color.halo,
                  1.5f * theme.scale);
}

} // namespace

ui::Rect draw_tutorial(Editor& editor, ui::Frame& frame, const ui::Rect& view)
{
    const ui::Theme& theme = frame.theme;
    const ui::Palette& c = theme.color;
    paint_stroke(editor, theme, view);
    const Tutorial& tutorial = editor.tutorial;
    const std::size_t step = tutorial.step(editor.session);
    const bool own = tutorial.note(editor.session).empty();
    const std::vector<ui::Run> runs = runs_of(editor);
    const ui::RichStyle style{theme.font.body, theme.font.strong, c.text, c.text, theme.px(22)};
    const float width = std::min(theme.px(600), view.width() - theme.px(24)), pad = theme.px(16);
    const float head = theme.px(44), foot = theme.px(60);
    const float text = ui::rich_height(theme, style, runs, width - 2 * pad);
    const float height = std::min(head + text + foot, view.height() - theme.px(24));
    float left = std::round(view.center().x - width / 2);
    if (!editor.session.notices.all().empty()) // beside them as far as there is room
        left = std::max(view.lo.x + theme.px(12),
                        std::min(left, ui::Notices::left_of(theme, view) - theme.px(12) - width));
    const ui::Rect r =
        ui::rect_at({left, std::round(view.hi.y - height - theme.px(16))}, {width, height});
    ui::paint_card(theme, r);
    ui::lower_area("card", r);
    ImGui::PushClipRect({r.lo.x, r.lo.y}, {r.hi.x, r.hi.y}, true);
    const ui::Rect line = {{r.lo.x + pad, r.lo.y + theme.px(10)}, {r.hi.x - pad, r.lo.y + head}};
    const ui::Rect caption = {line.lo, {line.hi.x, line.lo.y + theme.px(24)}};
    ui::paint_text(theme.font.strong, caption, c.text, tutorial.title());
    ui::paint_text(
        theme.font.small,
        {{caption.lo.x + ui::text_width(theme.font.strong, tutorial.title()) + theme.px(12),
          caption.lo.y},
         caption.hi},
        c.text_2, own ? "" : fmt::format("{} of {}", step, tutorial.count()));
    ui::draw_rich(theme, style, runs, {r.lo.x + pad, r.lo.y + head}, width - 2 * pad);
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(34), r.lo.y + theme.px(8)});
    const bool closes =
        ui::icon_button(theme, "close", ui::icon::close, glm::vec2(theme.size.icon_button),
                        tip_of(editor, action(editor, tutorial_close),
                               "Its scene stays open with all steps done."));
    const float y = r.hi.y - theme.px(16) - theme.px(32);
    if (!own)
        paint_dots(theme, {{r.lo.x + pad, y}, {r.hi.x, y + theme.px(32)}}, step, tutorial.count());
    glm::vec2 corner{r.hi.x - pad, y};
    const bool last = own || step >= tutorial.count();
    card_button(editor, theme, corner, last ? tutorial_close : tutorial_next,
                last ? "Done" : "Next", ui::ButtonKind::primary);
    card_button(editor, theme, corner, tutorial_back, "Back", ui::ButtonKind::plain);
    if (closes) action(editor, tutorial_close).run(editor);
    return r;
}

} // namespace trivar
