// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar::ui {
namespace {

Metrics metrics(float scale)
{
    const auto px = [scale](float v) { return std::round(v * scale); };
    Metrics m{};
    m.unit = px(4);
    m.row = px(24);
    m.row_gap = px(4);
    m.group = px(32);
    m.top_bar = px(40);
    m.options_bar = px(40);
    m.status_bar = px(28);
    m.tool_strip = px(48);
    m.tool_button = px(36);
    m.label = px(112);
    m.outliner = px(256);
    m.icon_button = px(24);
    m.padding = px(12);
    m.rounding = px(6);
    m.rounding_small = px(4);
    m.rounding_card = px(8);
    m.hairline = std::max(1.0f, px(1));
    return m;
}

void set_style(const Palette& c, float scale)
{
    ImGuiStyle s; // start from the defaults, so that applying twice gives the same style
    s.WindowPadding = {12, 12};
    s.FramePadding = {8, 4};
    s.CellPadding = {8, 4};
    s.ItemSpacing = {8, 4};
    s.ItemInnerSpacing = {8, 4};
    s.TouchExtraPadding = {0, 0};
    s.IndentSpacing = 16;
    s.ScrollbarSize = 10;
    s.GrabMinSize = 12;
    s.WindowBorderSize = 0;
    s.ChildBorderSize = 0;
    s.PopupBorderSize = 1;
    s.FrameBorderSize = 0;
    s.TabBorderSize = 0;
    s.WindowRounding = 8;
    s.ChildRounding = 6;
    s.FrameRounding = 4;
    s.PopupRounding = 8;
    s.ScrollbarRounding = 5;
    s.GrabRounding = 3;
    s.TabRounding = 4;
    s.WindowMinSize = {64, 32};
    s.WindowTitleAlign = {0.0f, 0.5f};
    s.WindowMenuButtonPosition = ImGuiDir_None;
    s.ButtonTextAlign = {0.5f, 0.5f};
    s.DisabledAlpha = 0.45f;
    s.ScaleAllSizes(scale);
    s.CurveTessellationTol = 1.0f;
    s.CircleTessellationMaxError = 0.2f;

    const auto set = [&s](ImGuiCol where, Color colour) {
        s.Colors[where] = ImGui::ColorConvertU32ToFloat4(colour);
    };
    const Color none = rgb(0, 0.0f);
    set(ImGuiCol_Text, c.text);
    set(ImGuiCol_TextDisabled, c.text_3);
    set(ImGuiCol_WindowBg, c.panel);
    set(ImGuiCol_ChildBg, none);
    set(ImGuiCol_PopupBg, c.raised);
    set(ImGuiCol_Border, c.raised_rim);
    set(ImGuiCol_BorderShadow, none);
    set(ImGuiCol_FrameBg, c.field);
    set(ImGuiCol_FrameBgHovered, c.field_hover);
    set(ImGuiCol_FrameBgActive, c.field_active);
    set(ImGuiCol_TitleBg, c.header);
    set(ImGuiCol_TitleBgActive, c.header);
    set(ImGuiCol_TitleBgCollapsed, c.header);
    set(ImGuiCol_MenuBarBg, c.header);
    set(ImGuiCol_ScrollbarBg, none);
    set(ImGuiCol_ScrollbarGrab, rgb(0x8F96A1, 0.35f));
    set(ImGuiCol_ScrollbarGrabHovered, rgb(0x8F96A1, 0.60f));
    set(ImGuiCol_ScrollbarGrabActive, rgb(0x8F96A1, 0.80f));
    set(ImGuiCol_CheckMark, c.on_accent);
    set(ImGuiCol_SliderGrab, c.accent_text);
    set(ImGuiCol_SliderGrabActive, c.on_accent);
    set(ImGuiCol_Button, c.field);
    set(ImGuiCol_ButtonHovered, c.field_hover);
    set(ImGuiCol_ButtonActive, c.field_active);
    set(ImGuiCol_Header, c.row_selected);
    set(ImGuiCol_HeaderHovered, c.row_hover);
    set(ImGuiCol_HeaderActive, c.row_selected);
    set(ImGuiCol_Separator, c.line_soft);
    set(ImGuiCol_SeparatorHovered, c.focus);
    set(ImGuiCol_SeparatorActive, c.focus);
    set(ImGuiCol_ResizeGrip, none);
    set(ImGuiCol_ResizeGripHovered, c.focus);
    set(ImGuiCol_ResizeGripActive, c.focus);
    set(ImGuiCol_Tab, none);
    set(ImGuiCol_TabHovered, c.row_hover);
    set(ImGuiCol_TabActive, c.field);
    set(ImGuiCol_TabUnfocused, none);
    set(ImGuiCol_TabUnfocusedActive, c.field);
    set(ImGuiCol_PlotLines, c.accent_text);
    set(ImGuiCol_PlotLinesHovered, c.on_accent);
    set(ImGuiCol_PlotHistogram, c.accent);
    set(ImGuiCol_PlotHistogramHovered, c.accent_hover);
    set(ImGuiCol_TableHeaderBg, c.header);
    set(ImGuiCol_TableBorderStrong, c.line);
    set(ImGuiCol_TableBorderLight, c.line_soft);
    set(ImGuiCol_TableRowBg, none);
    set(ImGuiCol_TableRowBgAlt, rgb(0xFFFFFF, 0.02f));
    set(ImGuiCol_TextSelectedBg, rgb(0x2F6FDE, 0.55f));
    set(ImGuiCol_DragDropTarget, c.focus);
    set(ImGuiCol_NavHighlight, c.focus);
    set(ImGuiCol_NavWindowingHighlight, c.focus);
    set(ImGuiCol_NavWindowingDimBg, c.scrim);
    set(ImGuiCol_ModalWindowDimBg, c.scrim);
    ImGui::GetStyle() = s;
}

} // namespace

float Theme::px(float at_scale_1) const
{
    return std::round(at_scale_1 * scale);
}

float Theme::line(float at_scale_1) const
{
    constexpr float wider = 1.5f;
    return at_scale_1 * scale * (look.high_contrast ? wider : 1.0f) *
           static_cast<float>(look.lines);
}

float combined_scale(double content, double interface)
{
    return static_cast<float>(std::clamp(content * interface, 0.75, 3.0));
}

Theme apply_theme(const ThemeOptions& options)
{
    Theme theme;
    theme.scale = std::clamp(options.scale, 0.75f, 3.0f);
    theme.color = palette_of(options.look);
    theme.look = options.look;
    theme.size = metrics(theme.scale);
    set_style(theme.color, theme.scale);
    theme.font = load_fonts(theme.scale);
    return theme;
}

} // namespace trivar::ui
