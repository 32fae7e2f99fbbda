// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/lists/palette_rows.h"

#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// The name with the letters that matched in the accent; returns where it ends.
float paint_matched(const ui::Theme& theme, const ui::Rect& in, const std::string& name,
                    const RankedName& ranked, ui::Color color)
{
    const ImFont* font = theme.font.body;
    float x = in.lo.x;
    for (std::size_t i = 0; i < name.size();) {
        const auto matched = [&](std::size_t at) {
            return std::ranges::binary_search(ranked.letters, at);
        };
        std::size_t end = i + 1;
        while (end < name.size() && matched(end) == matched(i)) ++end;
        const std::string part = name.substr(i, end - i);
        ui::paint_text(font, {{x, in.lo.y}, in.hi}, matched(i) ? theme.color.accent_text : color,
                       part);
        x += ui::text_width(font, part);
        i = end;
    }
    return x;
}

float caps_width(const ui::Theme& theme, const std::vector<std::string>& caps)
{
    float width = 0;
    for (const std::string& cap : caps) width += ui::keycap_width(theme, cap) + theme.px(4);
    return width;
}

void paint_entry(const ui::Theme& theme, const ui::Rect& row, const PaletteEntry& entry,
                 const RankedName& ranked, bool chosen)
{
    const ui::Palette& c = theme.color;
    const bool can = entry.why_not.empty();
    if (chosen)
        ui::paint_box({row.lo + glm::vec2(theme.px(8), 0), row.hi - glm::vec2(theme.px(8), 0)},
                      c.row_selected, theme.size.rounding);
    const float caps = caps_width(theme, entry.key_caps);
    const ui::Color quiet = chosen ? c.text_2 : c.text_3;
    ui::paint_text(theme.font.body, {row.lo + glm::vec2(theme.px(20), 0), row.hi}, quiet,
                   entry.icon);
    const float left = row.lo.x + theme.px(52), right = row.hi.x - theme.px(20) - caps;
    const std::string name = ui::elided(theme.font.body, entry.name, right - left);
    if (name != entry.name) ui::tooltip({entry.name});
    const float end = paint_matched(theme, {{left, row.lo.y}, {right, row.hi.y}}, name, ranked,
                                    can ? c.text : quiet);
    const float room = right - theme.px(12) - end - theme.px(12);
    if (room > theme.px(40))
        ui::paint_text(theme.font.small, {{end + theme.px(12), row.lo.y}, row.hi}, quiet,
                       ui::elided(theme.font.small, can ? entry.note : entry.why_not, room));
    float x = row.hi.x - theme.px(20) - caps + theme.px(4);
    for (const std::string& cap : entry.key_caps)
        x += ui::paint_keycap(theme, {x, row.lo.y}, row.height(), cap) + theme.px(4);
}

} // namespace

std::optional<std::size_t> draw_rows(const ui::Theme& theme, const ui::Rect& r,
                                     const PaletteRows& list, std::optional<std::size_t>& chosen,
                                     bool chosen_by_key)
{
    const ui::Palette& c = theme.color;
    const float row = theme.px(36), caption = theme.px(28);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("list", {r.width(), r.height()});
    const ImVec2 top = ImGui::GetCursorScreenPos();
    std::optional<std::size_t> clicked;
    float y = top.y;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    for (std::size_t i = 0; i < list.found.size(); ++i) {
        const bool first = i == 0, others = i > 0 && list.found[i - 1].recent;
        if (first || (others && !list.found[i].recent)) {
            const char* words = list.found[i].recent ? "RECENT" : list.caption;
            ui::paint_text(theme.font.small_strong,
                           {{r.lo.x + theme.px(20), y}, {r.hi.x, y + caption}}, c.text_3, words);
            y += caption;
        }
        const ui::Rect at = {{r.lo.x, y}, {r.hi.x, y + row}};
        y += row;
        if (i == chosen && chosen_by_key) {
            if (at.lo.y < r.lo.y) ImGui::SetScrollY(ImGui::GetScrollY() + at.lo.y - r.lo.y);
            if (at.hi.y > r.hi.y) ImGui::SetScrollY(ImGui::GetScrollY() + at.hi.y - r.hi.y);
        }
        if (at.hi.y < r.lo.y || at.lo.y > r.hi.y) continue; // scrolled away
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
        if (ImGui::InvisibleButton("entry", {at.width(), at.height()})) clicked = i;
        if (ImGui::IsItemHovered() && (moved.x != 0 || moved.y != 0)) chosen = i;
        ImGui::PopID();
        paint_entry(theme, at, list.entries[list.found[i].index], list.found[i], i == chosen);
    }
    ImGui::SetCursorScreenPos(top);
    ImGui::Dummy({1, y - top.y + theme.px(8)});
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return clicked;
}

void draw_palette_hints(const ui::Theme& theme, const ui::Rect& r, std::vector<PaletteHint> hints)
{
    const ui::Palette& c = theme.color;
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line_soft);
    const auto width_of = [&](const PaletteHint& each) {
        return caps_width(theme, each.caps) + theme.px(4 + 14) +
               ui::text_width(theme.font.small, each.verb);
    };
    float room = r.width() - theme.px(2 * 20 - 14);
    for (const PaletteHint& each : hints) room -= width_of(each);
    while (room < 0 && hints.size() > 2) { // the last one says how to leave
        room += width_of(hints[hints.size() - 2]);
        hints.erase(hints.end() - 2);
    }
    float x = r.lo.x + theme.px(20);
    for (const PaletteHint& each : hints) {
        for (const std::string& cap : each.caps)
            x += ui::paint_keycap(theme, {x, r.lo.y}, r.height(), cap) + theme.px(4);
        x += theme.px(4);
        ui::paint_text(theme.font.small, {{x, r.lo.y}, r.hi}, c.text_2, each.verb);
        x += ui::text_width(theme.font.small, each.verb) + theme.px(14);
    }
}

} // namespace trivar
