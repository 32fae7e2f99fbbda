// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/voxels.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/ink_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/transfer_rows.h"
#include "editor/panels/inspector/volume_level_rows.h"
#include "editor/panels/panels.h"
#include "editor/session/volume_levels.h"
#include "ui/icons.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

void file_row(Editor& editor, const ui::Theme& theme, const VoxelShape& shape, Id id)
{
    const float width = ui::label_row(theme, "File").width;
    const std::string name = std::filesystem::path(shape.path).filename().string();
    if (ui::button(theme, ui::elided(theme.font.body, name, width - theme.px(84)),
                   ui::ButtonKind::plain, {width, theme.size.row}, nullptr, "Replace..."))
        editor.files.ask_relink(id);
    ui::tooltip({shape.path, {}, "Click to take another file, or a folder of slices."});
}

// LastShown keeps the last shown state of the volume data in the inspector, for data that are
// hidden now and so are not evaluated.
struct LastShown {
    std::string path, hash;
    VolumeReading reading;
    Ref<ShownVolume> volume;
};

const ShownVolume* last_shown(Editor& editor, const VoxelShape& shape, Id id)
{
    auto& last = editor.memory.of<LastShown>();
    const auto found = editor.session.evaluated().objects.find(id);
    if (found != editor.session.evaluated().objects.end() && found->second->shape)
        last = {shape.path, shape.hash, shape.reading, found->second->shape->volume};
    else if (last.path != shape.path || last.hash != shape.hash || last.reading != shape.reading)
        last = {};
    return last.volume.get();
}

// A button as wide as the panel.
bool wide_button(const ui::Theme& theme, const char* words, const char* icon)
{
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    return ui::button(theme, words, ui::ButtonKind::plain, {width, theme.size.row}, icon);
}

void add_level(VoxelShape& shape, const LevelRows& of, int& chosen)
{
    const double value = of.shown && of.shown->summary ? next_value(shape, *of.shown->summary)
                         : shape.levels.empty()        ? 0
                                                       : shape.levels.back().value;
    VoxelLevel level = new_level(shape, value);
    if (!shape.levels.empty()) show(level, shows_of(shape.levels.back()));
    shape.levels.push_back(std::move(level));
    chosen = static_cast<int>(shape.levels.size()) - 1;
}

void chosen_rows(ValueRows& rows, const LevelRows& of, VoxelShape& shape, int chosen)
{
    VoxelLevel& level = shape.levels[static_cast<std::size_t>(chosen)];
    const ui::Row name = ui::label_row(rows.theme, "Name", false, "What the level is called.");
    rows.take(ui::text_field(rows.theme, "level name", level.name,
                             fmt::format("Level {}", chosen + 1), name.width));
    const std::string own = of.parameter(chosen);
    rows.choice("Show", static_cast<int>(shows_of(level)), static_cast<int>(LevelShows::both),
                {"Lines", "Surface", "Both"},
                RowWords("Silhouette lines follow the view.",
                         std::vector{own + ".lines", own + ".surface"}),
                [&](int now) {
                    if (now != static_cast<int>(shows_of(level)))
                        show(level, static_cast<LevelShows>(now));
                });
    ui::rows_if(rows.theme, level.surface, "The surface is not shown.", [&] {
        FieldRows<Surfacing> look(rows, level.look, own);
        const Surfacing rest = new_level({}, 0).look;
        look.resting_at(rest.base_color, &Surfacing::base_color);
        look.resting_at(rest.metallic, &Surfacing::metallic);
        look.resting_at(rest.roughness, &Surfacing::roughness);
    });
    ui::rows_if(rows.theme, level.lines, "No lines are drawn.", [&] {
        draw_ink_rows(rows, level.ink, new_level({}, 0).ink, own + ".ink");
        ui::rows_if(rows.theme, shape.order == FieldOrder::cubic,
                    "Only where Order is cubic, in the section Reconstruction.",
                    [&] { FieldRows<VoxelLevel>(rows, level, own)(&VoxelLevel::certified); });
        draw_more_line_rows(rows, level.more, own + ".more");
    });
}

// A corner of the box that is dragged stops before the other one.
void keep_apart(VoxelShape& shape, const VoxelShape& before)
{
    constexpr float least = 0.01f; // share of the grid
    for (int k = 0; k < 3; ++k) {
        float &low = shape.crop_low[k], &high = shape.crop_high[k];
        if (low != before.crop_low[k]) low = std::max(0.0f, std::min(low, high - least));
        if (high != before.crop_high[k]) high = std::min(1.0f, std::max(high, low + least));
    }
}

} // namespace

void draw_volume_data(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const VoxelShape* now = volume_of(session.document(), id);
    if (!now) return;
    VoxelShape s = *now;
    LevelRows of{last_shown(editor, s, id)};
    if (of.shown && of.shown->field) of.unit = of.shown->field->grid().value_unit;
    int chosen = chosen_in(s, id, session.level);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    std::optional<VoxelShape> at_once; // by a button
    if (ui::section(theme, "Volume data", true, fmt::format("{}", s.levels.size()))) {
        if (of.shown) of.scouted = session.level_scouts.of(session.quiet_jobs(), *of.shown);
        draw_level_histogram(rows, of, s, chosen);
        draw_level_list(rows, of, s, chosen);
        ui::gap(theme, 4);
        if (wide_button(theme, "Add level", ui::icon::add)) {
            at_once = s;
            add_level(*at_once, of, chosen);
        }
        ui::gap(theme, 4);
        file_row(editor, theme, s, id);
        ui::gap(theme, 8);
    }
    const auto number = static_cast<std::size_t>(std::max(chosen, 0));
    if (chosen >= 0 && !at_once) {
        const std::string name = s.levels[number].name.empty() ? fmt::format("Level {}", chosen + 1)
                                                               : s.levels[number].name;
        ImGui::PushID("chosen level");
        if (ui::section(theme, "Chosen level", true, name)) {
            ImGui::PushID(chosen);
            chosen_rows(rows, of, s, chosen);
            const bool spare = s.levels.size() > 1 || s.casting.shown; // else one is shown anyway
            if (spare && wide_button(theme, "Remove level", ui::icon::trash)) {
                at_once = s;
                at_once->levels.erase(at_once->levels.begin() + chosen);
                chosen = std::max(0, chosen - 1);
            }
            ui::gap(theme, 8);
            ImGui::PopID();
        }
        ImGui::PopID();
    }
    const bool crops = s.crop_low != VoxelShape{}.crop_low || s.crop_high != VoxelShape{}.crop_high;
    if (ui::section(theme, "Crop", crops)) {
        FieldRows<VoxelShape> fields(rows, s, "shape");
        fields(&VoxelShape::crop_low);
        fields(&VoxelShape::crop_high);
        keep_apart(s, *now);
        ui::gap(theme, 8);
    }
    if (ui::section(theme, "Casting", s.casting.shown)) {
        ImGui::PushID("rows"); // the section has the name of a row
        FieldRows<VolumeCasting> fields(rows, s.casting, "shape.casting");
        fields(&VolumeCasting::shown);
        ui::rows_if(theme, s.casting.shown, "The data are not cast.", [&] {
            auto& point = editor.memory.of<ChosenTransferPoint>();
            if (point.object != id) point = {id};
            draw_transfer(rows, of, s.casting, point.number);
            fields(&VolumeCasting::density);
            fields(&VolumeCasting::shading);
            fields(&VolumeCasting::crop_low);
            fields(&VolumeCasting::crop_high);
        });
        ImGui::PopID();
        ui::gap(theme, 8);
    }
    if (ui::section(theme, "Reconstruction", false)) {
        FieldRows<VoxelShape> fields(rows, s, "shape");
        fields(&VoxelShape::order);
        fields(&VoxelShape::spline);
        fields(&VoxelShape::coarsen);
        fields(&VoxelShape::blur);
        fields(&VoxelShape::body);
        fields(&VoxelShape::scale);
        ui::gap(theme, 8);
    }
    if (ui::section(theme, "Tetrahedra", s.fit.coefficients > 0)) {
        ImGui::PushID("fit"); // the section has the name of a row
        FieldRows<TetrahedraFit> fields(rows, s.fit, "shape.fit");
        fields(&TetrahedraFit::coefficients);
        const bool begun = s.fit.coefficients > 0 && now->fit.coefficients == 0;
        if (begun && s.fit.boundary == 0 && chosen >= 0)
            s.fit.boundary = s.levels[static_cast<std::size_t>(chosen)].value;
        ui::rows_if(theme, s.fit.coefficients > 0, "No tetrahedra are fitted.", [&] {
            fields(&TetrahedraFit::degree);
            fields(&TetrahedraFit::boundary);
        });
        ImGui::PopID();
        ui::gap(theme, 8);
    }
    if (chosen >= 0) session.level = {id, chosen};
    if (at_once) {
        session.cancel();
        session.run(SetVoxels{id, *at_once});
        return;
    }
    propose_edit(editor, rows.edit, [&] { return SetVoxels{id, s}; });
}

} // namespace trivar
