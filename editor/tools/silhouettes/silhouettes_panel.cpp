// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/level_under.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/volume_levels.h"
#include "editor/tools/silhouettes/silhouettes.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

std::string short_name(const VoxelLevel& level, std::size_t number)
{
    return level.name.empty() ? fmt::format("Level {}", number + 1) : level.name;
}

std::string unit_of(const ShownVolume* shown)
{
    return shown && shown->field ? shown->field->grid().value_unit : std::string();
}

} // namespace

void SilhouettesTool::options(Session& session, const ui::Theme& theme, float width)
{
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* now = volume_of(session.document(), id);
    if (!now || now->levels.empty()) {
        ui::option_bar(
            theme,
            {{now ? "Add a level in the inspector" : "Select volume data, or import some", 1,
              [](float) {}}},
            width);
        return;
    }
    SetVoxels set{id, *now};
    int chosen = chosen_in(*now, id, session.level);
    VoxelLevel& level = set.shape.levels[static_cast<std::size_t>(chosen)];
    ui::Edit edit = ui::Edit::none;
    const auto take = [&](ui::Edit one) {
        if (one != ui::Edit::none) edit = one;
    };
    const ShownVolume* shown = shown_volume_of(session, id);
    std::vector<ui::Option> options;
    options.push_back({"Show", 204,
                       [&](float field) {
                           int shows = static_cast<int>(shows_of(level));
                           const ui::Edit one = ui::segments(theme, "show", shows,
                                                             {"Lines", "Surface", "Both"}, field);
                           if (one == ui::Edit::changed) // all levels, as of one body
                               for (VoxelLevel& each : set.shape.levels)
                                   show(each, static_cast<LevelShows>(shows));
                           take(one);
                       },
                       "What is shown of the levels; the inspector says it for each."});
    if (now->levels.size() > 1)
        options.push_back({"", 104,
                           [&](float field) {
                               std::vector<std::string> names;
                               for (std::size_t i = 0; i < now->levels.size(); ++i)
                                   names.push_back(short_name(now->levels[i], i));
                               int at = chosen;
                               ui::choice(theme, "level", at, names, field);
                               if (at != chosen) session.level = {id, at};
                           },
                           "The level that is worked on."});
    options.push_back({"Level", 92,
                       [&](float field) {
                           ui::NumberStyle style{.lo = -1e30, .hi = 1e30, .unit = unit_of(shown)};
                           if (shown && shown->summary) {
                               style.lo = shown->summary->least;
                               style.hi = style.bar_hi = shown->summary->greatest;
                           }
                           take(ui::number_field(theme, "value", level.value, style, field));
                       },
                       "The value of the data at the level."});
    options.push_back({"Width", 76,
                       [&](float field) {
                           double wide = static_cast<double>(level.ink.width);
                           const ui::Edit one = ui::number_field(
                               theme, "width", wide,
                               {.lo = 0.05, .hi = 100, .unit = "px", .usual = 1}, field);
                           if (one == ui::Edit::changed)
                               for (VoxelLevel& each : set.shape.levels)
                                   each.ink.width = static_cast<float>(wide);
                           take(one);
                       },
                       "Of the lines of all levels."});
    ui::option_bar(theme, options, width);
    if (edit == ui::Edit::changed) edits_ = session.propose(set) || edits_;
    if (edit == ui::Edit::cancelled) {
        edits_ = false;
        session.cancel();
    }
    if (!edits_ || ImGui::IsAnyItemActive()) return;
    edits_ = false;
    if (session.proposing() && !busy()) session.commit();
}

void SilhouettesTool::overlay(const Session& session, const ui::Theme& theme,
                              const ViewportInput& input) const
{
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* shape = volume_of(session.document(), id);
    if (!shape || !visible(session.document(), id)) return;
    const std::string unit = unit_of(shown_volume_of(session, id));
    const int chosen = chosen_in(*shape, id, session.level);
    glm::vec2 at{input.rect.lo.x + theme.px(12),
                 input.rect.hi.y - theme.px(78)}; // above the card of steps
    for (std::size_t i = 0; i < shape->levels.size(); ++i) {
        const VoxelLevel& level = shape->levels[i];
        if (level.hidden) continue;
        std::string words = value_words(level.value, unit);
        if (!level.name.empty()) words = level.name + "  " + words;
        const ui::Rect chip = ui::paint_chip(theme, at, {words, level_color(level)});
        if (static_cast<int>(i) == chosen && shape->levels.size() > 1)
            ui::paint_rim(chip, theme.color.focus, theme.size.rounding, theme.size.hairline);
        at.x = chip.hi.x + theme.px(8);
        if (at.x > input.rect.hi.x - theme.px(120)) break;
    }
    if (!gesture_ || !gesture_->moved || chosen < 0) return;
    const VoxelLevel& level = shape->levels[static_cast<std::size_t>(chosen)];
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    const ui::Rect chip = ui::paint_chip(theme, mouse + glm::vec2(theme.px(16), -theme.px(28)),
                                         {value_words(gesture_->value, unit), level_color(level)});
    if (!gesture_->halted) return; // with a dot like that on the histogram
    ui::paint_rim(chip, theme.color.accent, theme.size.rounding, theme.line(1.5f));
    ui::paint_dot({chip.hi.x, chip.center().y}, theme.scale * 3.5f, theme.color.accent,
                  theme.color.text, 1.5f * theme.scale);
}

} // namespace trivar
