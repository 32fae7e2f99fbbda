// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/option_bar.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar::ui {
namespace {

float label_width(const Theme& theme, const Option& option)
{
    return text_width(theme.font.body, option.words) + theme.px(8);
}

void draw(const Theme& theme, const Option& option, glm::vec2 at, float label)
{
    paint_text(theme.font.body, rect_at(at, {label, theme.size.row}), theme.color.text_2,
               option.words);
    tooltip_in(rect_at(at, {label + theme.px(option.width), theme.size.row}),
               {option.words, {}, option.help});
    ImGui::SetCursorScreenPos({at.x + label, at.y});
    option.field(theme.px(option.width));
}

} // namespace

void option_bar(const Theme& theme, const std::vector<Option>& options, float room_px)
{
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    const float between = theme.px(16), button = theme.size.icon_button;
    std::vector<float> widths;
    float all = -between;
    for (const Option& each : options) {
        widths.push_back(label_width(theme, each) + theme.px(each.width) + between);
        all += widths.back();
    }
    std::size_t fit = options.size();
    if (all > room_px) {
        float used = 0;
        for (fit = 0; fit < options.size() && used + widths[fit] + button <= room_px; ++fit)
            used += widths[fit];
    }
    float x = begin.x;
    for (std::size_t i = 0; i < fit; ++i) {
        draw(theme, options[i], {x, begin.y}, label_width(theme, options[i]));
        x += widths[i];
    }
    if (fit == options.size()) return;
    ImGui::SetCursorScreenPos({x, begin.y});
    if (icon_button(theme, "more", icon::more, glm::vec2(button), {"More settings"}))
        ImGui::OpenPopup("more settings");
    float label = 0, field = 0;
    for (std::size_t i = fit; i < options.size(); ++i) {
        label = std::max(label, label_width(theme, options[i]));
        field = std::max(field, theme.px(options[i].width));
    }
    const float pad = theme.px(12), pitch = theme.size.row + theme.size.row_gap;
    const auto rows = static_cast<float>(options.size() - fit);
    ImGui::SetNextWindowPos({x, begin.y + theme.px(32)});
    ImGui::SetNextWindowSize({label + field + 2 * pad, rows * pitch + 2 * pad});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    if (ImGui::BeginPopup("more settings")) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        for (std::size_t i = fit; i < options.size(); ++i)
            draw(theme, options[i], {at.x, at.y + pitch * static_cast<float>(i - fit)}, label);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

} // namespace trivar::ui
