// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "editor/actions/model_actions.h"
#include "editor/panels/help/welcome.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <filesystem>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

constexpr int columns = 6;

std::string picture_of_model(const Editor& editor, const OwnModel& model)
{
    const std::filesystem::path folder = editor.memory.of<SamplePictures>().folder;
    return (folder / model_pictures / model.file).string() + ".png";
}

} // namespace

bool draw_model(Editor& editor, const ui::Theme& theme, const ui::Rect& r, const OwnModel& model,
                bool chosen)
{
    return draw_model_cell(editor, theme, r, model.name, picture_of_model(editor, model), chosen);
}

bool draw_model_cell(Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                     const std::string& name, const std::string& picture_path, bool chosen)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {r.width(), r.height()});
    const bool here = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    const ui::Rect picture = {r.lo, {r.hi.x, r.hi.y - theme.px(22)}};
    paint_picture(editor, theme, picture, picture_path);
    if (picture_path.empty())
        ui::paint_text(theme.font.strong, picture, c.text_2, ui::icon::tiles, ui::Align::center);
    ui::paint_rim(picture, here || chosen ? c.focus : c.raised_rim, theme.size.rounding,
                  chosen ? 2 * theme.scale
                  : here ? 1.5f * theme.scale
                         : theme.size.hairline);
    ui::paint_text(theme.font.body, {{r.lo.x, picture.hi.y}, r.hi}, c.text,
                   ui::elided(theme.font.body, name, r.width()), ui::Align::center);
    return clicked;
}

void draw_model_menu(Editor& editor, const ui::Theme& theme)
{
    const std::vector<OwnModel>& models = own_models();
    const bool there = is_enabled(editor, action(editor, models.front().name));
    if (!ImGui::BeginMenu(models_menu, there)) return;
    const glm::vec2 size{theme.px(112), theme.px(90)}, gap{theme.px(10), theme.px(8)};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Action* chosen = nullptr;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const glm::vec2 place(i % columns, i / columns);
        if (draw_model(editor, theme,
                       ui::rect_at(glm::vec2(at.x, at.y) + place * (size + gap), size), models[i]))
            chosen = &action(editor, models[i].name);
    }
    if (chosen) {
        ImGui::ClosePopupToLevel(0, true);
        chosen->run(editor);
    }
    ImGui::EndMenu();
}

} // namespace trivar
