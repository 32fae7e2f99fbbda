// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/hint_steps.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {

std::optional<ui::Rect> draw_hint_card(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const auto card = hint_card(editor);
    if (!card) return {};
    const ui::Palette& c = theme.color;
    const float left = theme.px(58), right = theme.px(16), line = theme.px(18), top = theme.px(10);
    const std::string count = card->number > 0 ? fmt::format("{} of 3", card->number) : "";
    const float beside = ui::text_width(theme.font.small, count) + theme.px(48); // and the cross
    const float most = std::min(theme.px(440), view.width() - theme.px(24));
    const float title = ui::text_width(theme.font.strong, card->title) + beside;
    const float body = ui::text_width(theme.font.body, card->body) + right;
    const float width = std::min(most, left + std::max(title, body));
    const auto lines = ui::wrapped(theme.font.body, card->body, width - left - right);
    const glm::vec2 size{width, theme.px(46) + line * static_cast<float>(lines.size())};
    float x = std::round(view.center().x - width / 2);
    if (!editor.session.notices.all().empty()) { // beside them, or not at all
        x = std::min(x, ui::Notices::left_of(theme, view) - theme.px(12) - width);
        if (x < view.lo.x + theme.px(12)) return {};
    }
    const ui::Rect r = ui::rect_at({x, view.hi.y - size.y - theme.px(16)}, size);
    ui::paint_card(theme, r);
    ui::lower_area("hint", r); // takes the clicks
    ui::paint_text(theme.font.large_icon, {r.lo + glm::vec2(theme.px(16), 0), r.hi}, c.stroke,
                   ui::icon::place);
    const ui::Rect head = {{r.lo.x + left, r.lo.y + top},
                           {r.hi.x - theme.px(40), r.lo.y + top + theme.px(22)}};
    ui::paint_text(theme.font.strong, head, c.text,
                   ui::elided(theme.font.strong, card->title, width - left - beside));
    ui::paint_text(theme.font.small, head, c.text_3, count, ui::Align::right);
    float y = head.hi.y + theme.px(2);
    for (const std::string& each : lines) {
        ui::paint_text(theme.font.body, {{r.lo.x + left, y}, {r.hi.x, y + line}}, c.text_2, each);
        y += line;
    }
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(34), r.lo.y + theme.px(8)});
    if (ui::icon_button(theme, "close hint", ui::icon::close, glm::vec2(theme.size.icon_button),
                        {"Close this hint", {}, "Help brings it back."}))
        close_hint(editor, card->name);
    return r;
}

} // namespace trivar
