// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

constexpr float strip_pad_px = 6, least_pad_px = 2, tool_gap_px = 4;

// Puts the tools into columns of a height; returns how many there are.
int arrange_tools(Layout& l, const ui::Theme& theme, float height, int tools)
{
    constexpr float lowest = 0.66f; // of its height, before there are two columns
    const float full = theme.size.tool_button, count = static_cast<float>(tools);
    const float high = std::floor((height - 2 * theme.px(least_pad_px)) / count);
    const float button = l.tool_height = high >= lowest * full ? std::min(high, full) : full;
    l.tool_pad = std::clamp(std::floor((height - count * button) / 2), theme.px(least_pad_px),
                            theme.px(strip_pad_px));
    const float room = height - 2 * l.tool_pad;
    const auto fit = [&](float gap) {
        return std::max(1, static_cast<int>((room + gap) / (button + gap)));
    };
    // Before there are two columns, buttons stand closer.
    const float close = std::floor((room - count * button) / std::max(count - 1, 1.0f));
    l.tool_gap = std::min(close >= 0 ? close : theme.px(tool_gap_px), theme.px(tool_gap_px));
    const int columns = (tools + fit(l.tool_gap) - 1) / fit(l.tool_gap);
    l.tool_rows = (tools + columns - 1) / columns;
    return columns;
}

} // namespace

ui::Rect Layout::tool_place(const ui::Theme& theme, std::size_t tool) const
{
    const auto rows = static_cast<std::size_t>(tool_rows);
    const glm::vec2 button(theme.size.tool_button, tool_height);
    const glm::vec2 pitch = button + glm::vec2(theme.px(tool_gap_px), tool_gap);
    return ui::rect_at(strip.lo + glm::vec2(theme.px(strip_pad_px), tool_pad) +
                           pitch * glm::vec2(tool / rows, tool % rows),
                       button);
}

Layout layout_of(const ui::Theme& theme, glm::vec2 size_px, const Preferences& preferences,
                 std::size_t tools, bool only_view)
{
    const ui::Metrics& m = theme.size;
    const float line = m.hairline, width = size_px.x, height = size_px.y;
    Layout l;
    l.status = {{0, height - m.status_bar}, {width, height}};
    if (only_view) {
        l.dock = false;
        l.view = {{0, 0}, {width, l.status.lo.y - line}};
        return l;
    }
    const float y0 = m.top_bar + line, y1 = height - m.status_bar - line;
    const int columns = arrange_tools(l, theme, y1 - y0, std::max(1, static_cast<int>(tools)));
    const float strip =
        m.tool_strip + static_cast<float>(columns - 1) * (m.tool_button + theme.px(tool_gap_px));
    // The width of the dock is the one that the person chose, as far as a small window has room.
    const float dock = std::round(std::min(theme.px(static_cast<float>(preferences.dock)),
                                           std::max(theme.px(256), width * 0.34f)));
    l.dock = preferences.show_dock && width > dock + strip + theme.px(160);
    const float right = l.dock ? width - dock : width;
    l.top = {{0, 0}, {width, m.top_bar}};
    l.strip = {{0, y0}, {strip, y1}};
    const float left = strip + line, view_right = l.dock ? right - line : right;
    l.options = {{left, y0}, {view_right, y0 + m.options_bar}};
    // The picture keeps as much as a hand can work in.
    const float kept = std::min(theme.px(least_view), (y1 - y0) / 3) + m.options_bar + 2 * line;
    const float asked =
        preferences.timeline_open
            ? std::min(theme.px(static_cast<float>(preferences.timeline)), y1 - y0 - kept)
            : 0;
    l.timeline = {{left, y1 - std::round(std::max(asked, theme.px(40)))}, {view_right, y1}};
    l.view = {{left, l.options.hi.y + line}, {view_right, l.timeline.lo.y - line}};
    // The inspector keeps room for some rows.
    const float column = y1 - y0, rows = theme.px(40 + 150);
    const float most = std::round(std::clamp(column - rows, 0.35f * column, 0.6f * column));
    const float outliner = std::min(theme.px(static_cast<float>(preferences.outliner)), most);
    l.outliner = {{right, y0}, {width, y0 + outliner}};
    l.tabs = {{right, l.outliner.hi.y + line}, {width, l.outliner.hi.y + line + theme.px(40)}};
    l.inspector = {{right, l.tabs.hi.y}, {width, y1}};
    return l;
}

void begin_panel(const char* name, const ui::Rect& rect, ui::Color color, bool scrolls)
{
    ImGui::SetNextWindowPos({rect.lo.x, rect.lo.y});
    ImGui::SetNextWindowSize({std::max(1.0f, rect.width()), std::max(1.0f, rect.height())});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, color);
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                             ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoBringToFrontOnFocus;
    // One that appears must not take what the hand holds.
    if (ImGui::IsAnyItemActive()) flags |= ImGuiWindowFlags_NoFocusOnAppearing;
    if (!scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

} // namespace trivar
