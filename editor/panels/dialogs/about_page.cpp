// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/about.h"
#include "editor/panels/dialogs/preferences_pages.h"
#include "gpu/context.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {

void draw_about_page(Editor&, const ui::Theme& theme, const ui::Rect& r)
{
    ui::fact_row(theme, "Trivar", program_version() + ", GPL-3.0-or-later");
    ui::fact_row(theme, "Build", program_build());
    ui::fact_row(theme, "Graphics", gpu::describe_context());
    ui::gap(theme, 12);
    const float left = ImGui::GetCursorScreenPos().x + theme.size.padding;
    const float version = left + theme.px(160), licence = version + theme.px(88);
    const auto line = [&](const ImFont* font, ui::Color color, const Library& words) {
        const float y = ImGui::GetCursorScreenPos().y;
        const ui::Rect row = {{left, y}, {r.hi.x, y + theme.px(20)}};
        ui::paint_text(font, row, color, words.name);
        ui::paint_text(font, {{version, y}, row.hi}, color, words.version);
        ui::paint_text(font, {{licence, y}, row.hi}, color, words.licence);
        ImGui::Dummy({1, theme.px(20) - ImGui::GetStyle().ItemSpacing.y});
    };
    line(theme.font.small_strong, theme.color.text_3, {"LIBRARY", "VERSION", "LICENCE"});
    for (const Library& each : libraries()) line(theme.font.body, theme.color.text_2, each);
}

void copy_about()
{
    ImGui::SetClipboardText(about_text(gpu::describe_context()).c_str());
}

} // namespace trivar
