// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/help_actions.h"
#include "editor/panels/help/welcome.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <imgui.h>

namespace trivar {
namespace {

// Drawn by the program; a test compares it with what the program draws.
std::string picture_of_sample(const Editor& editor, const std::string& path)
{
    const std::filesystem::path name = std::filesystem::path(path).stem();
    return (std::filesystem::path(editor.memory.of<SamplePictures>().folder) / name).string() +
           ".png";
}

void draw_sample(Editor& editor, const ui::Theme& theme, const ui::Rect& r, float high,
                 const Sample& sample)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    const bool clicked = ImGui::InvisibleButton(sample.path.c_str(), {r.width(), r.height()});
    const bool hovered = ImGui::IsItemHovered();
    const ui::Rect picture = {r.lo, {r.hi.x, r.lo.y + high}};
    paint_picture(editor, theme, picture, picture_of_sample(editor, sample.path));
    ui::paint_rim(picture, hovered ? c.focus : c.raised_rim, theme.size.rounding,
                  hovered ? 1.5f * theme.scale : theme.size.hairline);
    const float y = picture.hi.y + theme.px(6);
    ui::paint_text(theme.font.strong, {{r.lo.x, y}, {r.hi.x, y + theme.px(20)}}, c.text,
                   ui::elided(theme.font.strong, sample.title, r.width()));
    ui::paint_text(theme.font.small, {{r.lo.x, y + theme.px(19)}, {r.hi.x, y + theme.px(37)}},
                   c.text_3, ui::elided(theme.font.small, sample.words, r.width()));
    if (is_chosen(editor, theme, picture, clicked)) editor.files.open_scene(sample.path);
}

} // namespace

float draw_caption(const ui::Theme& theme, const ui::Rect& column, float y, const char* words)
{
    ui::paint_text(theme.font.small_strong, {{column.lo.x, y}, {column.hi.x, y + theme.px(20)}},
                   theme.color.text_3, words);
    return y + theme.px(28);
}

bool text_link(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
               const std::string& words, ui::Align align)
{
    const ImFont* font = theme.font.body;
    const float width = std::min(row.width(), ui::text_width(font, words));
    const float x = align == ui::Align::right ? row.hi.x - width : row.lo.x;
    const ui::Rect r = {{x, row.lo.y}, {x + width, row.hi.y}};
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    const bool clicked = ImGui::InvisibleButton(words.c_str(), {r.width(), r.height()});
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        const float base = r.center().y + theme.px(7);
        ui::paint_line({r.lo.x, base}, {r.hi.x, base}, theme.color.accent_text,
                       theme.size.hairline);
    }
    ui::paint_text(font, r, theme.color.accent_text, ui::elided(font, words, row.width()));
    const glm::vec2 beside{theme.px(4), -theme.px(1)};
    return is_chosen(editor, theme, {r.lo - beside, r.hi + beside}, clicked);
}

void draw_samples(Editor& editor, const ui::Theme& theme, const ui::Rect& column,
                  const std::vector<Sample>& samples)
{
    const float y = draw_caption(theme, column, column.lo.y + theme.px(4), "SAMPLE SCENES");
    const ui::Rect head = {{column.lo.x + theme.px(120), column.lo.y},
                           {column.hi.x, column.lo.y + theme.px(28)}};
    if (has_tour(editor) &&
        text_link(editor, theme, head, "Take the one-minute tour", ui::Align::right))
        begin_tour(editor);
    const float gap = theme.px(16), wide = std::floor((column.width() - gap) / 2);
    const float pitch = std::floor((column.hi.y - y) / 2);
    const float high = std::min(std::round(wide * 0.85f), pitch - theme.px(52));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const glm::vec2 at{column.lo.x + (wide + gap) * static_cast<float>(i % 2),
                           y + pitch * static_cast<float>(i / 2)};
        draw_sample(editor, theme, ui::rect_at(at, {wide, high + theme.px(44)}), high, samples[i]);
    }
}

} // namespace trivar
