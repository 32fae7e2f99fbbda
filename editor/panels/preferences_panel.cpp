// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr const char* pages[] = {"Interface", "Viewport", "Key map"};

void draw_page_names(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    auto& dialog = editor.preferences_dialog;
    const int shown = dialog.page;
    float y = r.lo.y + theme.px(12);
    for (int i = 0; i < std::ssize(pages); ++i) {
        const ui::Rect row = {{r.lo.x + theme.px(12), y},
                              {r.hi.x - theme.px(12), y + theme.px(32)}};
        ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
        if (ImGui::InvisibleButton(pages[i], {row.width(), row.height()})) {
            dialog.page = i;
            dialog.asking.clear();
        }
        const bool on = shown == i;
        if (on || ImGui::IsItemHovered())
            ui::paint_box(row, on ? c.row_selected : c.row_hover, theme.size.rounding);
        ui::paint_text(on ? theme.font.strong : theme.font.body,
                       {row.lo + glm::vec2(theme.px(12), 0), row.hi}, on ? c.text : c.text_2,
                       pages[i]);
        y += theme.px(34);
    }
    ui::paint_box({{r.hi.x - theme.size.hairline, r.lo.y}, r.hi}, c.line_soft);
}

void foot_note(const ui::Theme& theme, const ui::Rect& r, const std::string& text)
{
    ui::gap(theme, 12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    float y = at.y;
    for (const std::string& words :
         ui::wrapped(theme.font.small, text, r.width() - 2 * theme.size.padding)) {
        ui::paint_text(theme.font.small,
                       {{at.x + theme.size.padding, y}, {r.hi.x, y + theme.px(18)}},
                       theme.color.text_3, words);
        y += theme.px(18);
    }
}

void draw_interface_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y + theme.px(12)});
    ImGui::BeginChild("interface", {r.width(), r.height() - theme.px(12)});
    int nearest = 0;
    std::vector<std::string> names;
    const auto off = [&](int i) {
        return std::abs(interface_scales[static_cast<std::size_t>(i)] - p.scale);
    };
    for (int i = 0; i < std::ssize(interface_scales); ++i) {
        if (off(i) < off(nearest)) nearest = i;
        names.push_back(
            fmt::format("{:.0f} %", 100 * interface_scales[static_cast<std::size_t>(i)]));
    }
    const float width = std::min(theme.px(420), ui::label_row(theme, "Size").width);
    if (ui::segments(theme, "scale", nearest, names, width) == ui::Edit::changed)
        p.scale = interface_scales[static_cast<std::size_t>(nearest)];
    int light = p.look.light ? 1 : 0;
    if (ui::segments(theme, "theme", light, {"Dark", "Light"},
                     std::min(theme.px(280), ui::label_row(theme, "Theme").width)) ==
        ui::Edit::changed)
        p.look.light = light == 1;
    ui::label_row(theme, "Contrast");
    ui::check_box(theme, "contrast", p.look.high_contrast, "high: no quiet text, wider lines");
    ui::label_row(theme, "Overlays");
    ui::check_box(theme, "hues", p.look.other_hues, "in hues for colour-blind eyes");
    ui::label_row(theme, "Side panels");
    ui::check_box(theme, "dock", p.show_dock, "outliner and inspector at the right");
    ui::label_row(theme, "Hints");
    ui::check_box(theme, "hints", p.hints, "what to do first, at the foot of the picture");
    ui::label_row(theme, "Motion");
    ui::check_box(theme, "motion", p.reduced_motion, "reduced: what would move is there at once");
    foot_note(theme, r,
              "The size is times the monitor's own scale. Panels are as wide as the lines between "
              "them are dragged; a double click on a line restores it.");
    ImGui::EndChild();
}

void draw_viewport_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y + theme.px(12)});
    ImGui::BeginChild("viewport", {r.width(), r.height() - theme.px(12)});
    int backdrop = p.backdrop_as_in_pictures ? 1 : 0;
    const float width = std::min(theme.px(280), ui::label_row(theme, "Backdrop").width);
    if (ui::segments(theme, "backdrop", backdrop, {"With grid", "As in pictures"}, width) ==
        ui::Edit::changed)
        p.backdrop_as_in_pictures = backdrop == 1;
    constexpr std::array qualities{"automatic", "draft", "standard", "high"};
    int quality = static_cast<int>(std::ranges::find(qualities, p.quality) - qualities.begin()) %
                  static_cast<int>(qualities.size());
    const float room = std::min(theme.px(380), ui::label_row(theme, "Quality").width);
    if (ui::segments(theme, "quality", quality, {"Automatic", "Draft", "Standard", "High"}, room) ==
        ui::Edit::changed)
        p.quality = qualities[static_cast<std::size_t>(quality)];
    int deform = static_cast<int>(gpu::deform_named(p.deform).value_or(gpu::DeformBy::processor));
    const float wide = std::min(theme.px(380), ui::label_row(theme, "Deform").width);
    if (ui::segments(theme, "deform", deform, {"Processor", "One phase", "Two phases"}, wide) ==
        ui::Edit::changed)
        p.deform = gpu::deform_names[static_cast<std::size_t>(deform)];
    foot_note(
        theme, r,
        "The window has a quiet backdrop of its own, with a grid and the axes. As in "
        "pictures it is the one of the scene's look: the window then shows what a picture "
        "will show. The quality is that of what is at rest. What moves is drawn as well as it "
        "keeps up with the hand, but no better. Placed objects are deformed by the processor, or "
        "by "
        "the graphics card: in one phase as they are drawn, in two phases once before.");
    ImGui::EndChild();
}

void reset_page(Editor& editor)
{
    Preferences& p = editor.preferences;
    const Preferences usual;
    auto& dialog = editor.preferences_dialog;
    if (dialog.page == dialog.of_viewport) {
        p.backdrop_as_in_pictures = usual.backdrop_as_in_pictures;
        p.quality = usual.quality;
        p.deform = usual.deform;
        return;
    }
    if (dialog.page == dialog.of_interface) {
        p.scale = usual.scale;
        p.dock = usual.dock;
        p.outliner = usual.outliner;
        p.show_dock = usual.show_dock;
        p.hints = usual.hints;
        p.look = usual.look;
        p.reduced_motion = usual.reduced_motion;
        return;
    }
    p.keys.clear();
    use_keys(editor.actions, p.keys);
    dialog.asking.clear();
    dialog.given.clear();
}

} // namespace

void draw_preferences(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.preferences_dialog;
    if (!dialog.open) return;
    const ui::Palette& c = theme.color;
    const ui::Rect r = ui::begin_dialog(theme, "preferences", {theme.px(840), theme.px(620)});
    const float head = theme.px(56), foot = theme.px(60), left = theme.px(184);
    const float pad = theme.px(24);
    // Read before the page, which takes the key that is waited for.
    const bool leave = dialog.asking.empty() && ImGui::IsKeyPressed(ui::key_escape, false);
    ui::paint_text(theme.font.title, {r.lo + glm::vec2(pad, 0), {r.hi.x, r.lo.y + head}}, c.text,
                   "Preferences");
    ui::paint_box({{r.lo.x, r.lo.y + head}, {r.hi.x, r.lo.y + head + theme.size.hairline}},
                  c.line_soft);
    const float y0 = r.lo.y + head + theme.size.hairline, y1 = r.hi.y - foot;
    draw_page_names(editor, theme, {{r.lo.x, y0}, {r.lo.x + left, y1}});
    const ui::Rect page = {{r.lo.x + left + theme.px(12), y0}, {r.hi.x - theme.px(12), y1}};
    if (dialog.page == dialog.of_interface)
        draw_interface_page(editor, theme, page);
    else if (dialog.page == dialog.of_viewport)
        draw_viewport_page(editor, theme, page);
    else
        draw_key_map(editor, theme, page);
    ui::paint_box({{r.lo.x, y1}, {r.hi.x, y1 + theme.size.hairline}}, c.line_soft);
    const float y = std::round(y1 + (foot - theme.px(32)) / 2);
    ImGui::SetCursorScreenPos({r.lo.x + theme.px(16), y});
    const std::string reset = dialog.page == dialog.of_keys ? "Reset key map" : "Reset this page";
    const float width = ui::text_width(theme.font.body, reset) + theme.px(56);
    if (ui::button(theme, reset, ui::ButtonKind::plain, {width, theme.px(32)}, ui::icon::reset))
        reset_page(editor);
    ImGui::SetCursorScreenPos({r.hi.x - pad - theme.px(88), y});
    const bool done =
        ui::button(theme, "Done", ui::ButtonKind::primary, {theme.px(88), theme.px(32)});
    if (done || leave) {
        const int shown = dialog.page;
        dialog = {};
        dialog.page = shown;
        ImGui::CloseCurrentPopup();
    }
    ui::end_dialog();
}

} // namespace trivar
