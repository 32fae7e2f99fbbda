// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/lattice_points.h"

#include "editor/hands/last_shaping.h"
#include "editor/hands/lattice_round.h"
#include "editor/hands/point_choice.h"
#include "editor/hands/selected_placement.h"
#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {

void LatticePointsTool::add_falloff_options(std::vector<ui::Option>& options,
                                            const ui::Theme& theme, const Lattice& volume)
{
    options.push_back(
        ui::enum_option(ui::choice, theme, "Falloff", 96, "falloff", falloff_, falloff_names,
                        "How the motion fades from the selected points to the radius."));
    options.push_back({"Radius", 88,
                       [&](float field) {
                           double metres = radius(volume);
                           if (ui::number_field(theme, "radius", metres,
                                                {.lo = 1e-6, .hi = 1e6, .unit = "m"},
                                                field) != ui::Edit::none)
                               radius_m_ = metres;
                       },
                       "How far the motion reaches."});
}

void LatticePointsTool::options(Session& session, const ui::Theme& theme, float width)
{
    const EvaluatedObject* laid = selected_volume(session);
    std::vector<ui::Option> options;
    if (!laid && session.selected != 0) {
        options.push_back({"", 190,
                           [&](float field) {
                               if (ui::button(theme, lattice_action, ui::ButtonKind::plain,
                                              {field, theme.size.row}))
                                   put_lattice_round_selection(session);
                           },
                           "Puts a lattice round the selected objects that bends them."});
        return ui::option_bar(theme, options, width);
    }
    if (laid) add_proportional_option(options, theme);
    if (laid && proportional_) add_falloff_options(options, theme, laid->placement->volume);
    const bool box = laid && is_lattice(session.document(), laid->id);
    options.push_back(
        {"Mirror", 84,
         [&, box](float field) {
             const ImVec2 at = ImGui::GetCursorScreenPos();
             const float each = field / 3;
             for (int a = 0; a < 3; ++a) {
                 ImGui::SetCursorScreenPos({at.x + static_cast<float>(a) * each, at.y});
                 if (ui::button(theme, std::string(1, (box ? "XYZ" : "UVW")[a]),
                                mirror_[a] ? ui::ButtonKind::primary : ui::ButtonKind::plain,
                                {each - theme.px(4), theme.size.row}))
                     mirror_[a] = !mirror_[a];
             }
         },
         "Mirrors the motion to the other side of the middle along these axes."});
    options.push_back(ui::check_option(theme, "Guard", "guard", guard_,
                                       "Stops an edit before the volume would fold."));
    if (laid) {
        const glm::ivec3 n = point_count(laid->placement->volume);
        const std::string words = fmt::format("{} of {} × {} × {}", chosen_.size(), n.x, n.y, n.z);
        options.push_back({"Points", 128,
                           [&theme, words](float field) {
                               const ImVec2 at = ImGui::GetCursorScreenPos();
                               ui::name_text(theme.font.body,
                                             ui::rect_at({at.x, at.y}, {field, theme.size.row}),
                                             theme.color.text_2, words);
                           },
                           "Selected control points, of those along, across and up."});
        if (!chosen_.empty())
            options.push_back({"", 150,
                               [&](float field) {
                                   if (ui::button(theme, allow_folds_action, ui::ButtonKind::plain,
                                                  {field, theme.size.row}))
                                       allow_folds(session, object_, held(session));
                               },
                               "Everything that the selected points bend may fold from then on."});
    }
    ui::option_bar(theme, options, width);
}

const char* LatticePointsTool::axes_words(const Session& session) const
{
    const EvaluatedObject* laid = selected_volume(session);
    const bool box = laid && is_lattice(session.document(), laid->id);
    return box ? "Along an axis" : "Along, across, up";
}

std::vector<Hint> LatticePointsTool::hints(const Session& session) const
{
    if (!selected_volume(session))
        return {{{}, "Select a placed object or a lattice, or put a lattice round the selection"},
                {{"left"}, "Select"},
                {{"Esc"}, "Select"}};
    std::vector<Hint> hints = PointsTool::hints(session);
    if (!gesture_)
        hints.insert(hints.end() - 4,
                     {{{"Double click"}, "Row"}, {{"Shift", "Double click"}, "Plane"}});
    return hints;
}

} // namespace trivar
