// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/tiles.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspector_tiles.h"
#include "editor/session/scene_facts.h"
#include "ui/icons.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <limits>

namespace trivar {
namespace {

// The stroke whose numbers are shown.
struct OpenStroke {
    Id layer = 0;
    int number = 0; // from 1 on; 0: none
};

std::string words_of_stroke(const TileStroke& stroke)
{
    const auto length = [](double metres) { return ui::short_number(metres) + " m"; };
    const std::size_t taken = std::max<std::size_t>(1, stroke.samples.size() - 1);
    switch (stroke.brush) {
    case TileBrush::scatter: return "Scatter, tiles of " + length(stroke.size);
    case TileBrush::line: return "Line, tiles of " + length(stroke.size);
    case TileBrush::fill: return "Fill, tiles of " + length(stroke.size);
    case TileBrush::erase: return "Erase";
    case TileBrush::comb: return "Comb";
    case TileBrush::resize: return stroke.strength < 0 ? "Make smaller" : "Make larger";
    case TileBrush::raise: return stroke.strength < 0 ? "Lower" : "Raise";
    case TileBrush::grab: return taken == 1 ? "Move a tile" : fmt::format("Move {} tiles", taken);
    case TileBrush::strand: return "Strand, tiles of " + length(stroke.size);
    case TileBrush::color: return stroke.strength < 0 ? "Take colour away" : "Colour";
    case TileBrush::morph: return stroke.strength < 0 ? "Morph back" : "Morph";
    case TileBrush::adjust: {
        const std::string what =
            stroke.samples.size() == 1 ? "a tile" : fmt::format("{} tiles", stroke.samples.size());
        return (stroke.factor == 0 ? "Remove " : stroke.factor == 1 ? "Turn " : "Scale ") + what;
    }
    }
    return {};
}

// A stroke with buttons that turn it off and remove it; a click on its name shows its numbers.
void stroke_row(Editor& editor, const ui::Theme& theme, Id id, int number, const TileStroke& stroke)
{
    Session& session = editor.session;
    auto& open = editor.memory.of<OpenStroke>();
    const bool is_open = open.layer == id && open.number == number;
    ImGui::PushID(number);
    const std::optional<int> pressed =
        ui::list_row(theme,
                     {.name = fmt::format("{}  {}", number, words_of_stroke(stroke)),
                      .color = stroke.hidden ? theme.color.text_3 : theme.color.text_2,
                      .icon = is_open ? ui::icon::open : ui::icon::closed,
                      .tip = ui::Tip{is_open ? "Hide the numbers of this stroke"
                                             : "Show the numbers of this stroke"}},
                     {{"stroke off",
                       stroke.hidden ? ui::icon::hidden : ui::icon::eye,
                       {stroke.hidden ? "Turn this stroke on" : "Turn this stroke off",
                        {},
                        "The strokes after it act on what is left."}},
                      {"remove stroke",
                       ui::icon::trash,
                       {"Remove this stroke", {}, "The other strokes stay."}}});
    ImGui::PopID();
    if (pressed == -1) open = is_open ? OpenStroke{} : OpenStroke{id, number};
    if (pressed == 0) {
        TileStroke other = stroke;
        other.hidden = !other.hidden;
        session.run(EditTileStroke{id, number, std::move(other)});
    }
    if (pressed == 1) {
        session.run(RemoveTileStrokes{id, {number}});
        open = {};
    }
}

// `limit`: the height of the layer up to which no tile of the stroke folds.
void stroke_numbers(Editor& editor, const ui::Theme& theme, Id id, int number,
                    const TileStroke& stroke, double layer_height, double limit)
{
    ImGui::PushID(number);
    TileStroke changed = stroke;
    ValueRows rows{theme};
    FieldRows<TileStroke> fields(rows, changed, "");
    const TileBrush brush = stroke.brush;
    const bool lays = lays_tiles(brush);
    if (brush == TileBrush::strand) {
        fields(&TileStroke::size);
        fields(&TileStroke::width);
        if (layer_height > 0) rows.stop = just_below(stroke.height * limit / layer_height);
        fields(&TileStroke::height);
        fields(&TileStroke::taper);
        fields(&TileStroke::apart);
        fields(&TileStroke::seed);
    } else if (lays) {
        fields(&TileStroke::size);
        fields(&TileStroke::spacing);
        if (layer_height > 0) rows.stop = just_below(stroke.height * limit / layer_height);
        fields(&TileStroke::height);
        fields(&TileStroke::size_variation);
        fields(&TileStroke::heading);
        ui::rows_if(theme, stroke.heading == TileHeading::to_point,
                    "Only for the heading To point.", [&] { fields(&TileStroke::point); });
        fields(&TileStroke::turn_variation_deg);
        if (brush == TileBrush::fill) fields(&TileStroke::area);
        fields(&TileStroke::seed);
    } else if (brush == TileBrush::adjust) {
        fields(&TileStroke::turn_deg);
        fields(&TileStroke::factor);
    } else if (brush != TileBrush::grab) {
        if (brush != TileBrush::erase) fields(&TileStroke::strength);
        if (brush == TileBrush::color) {
            glm::vec4 color(glm::vec3(stroke.color), 1);
            rows.row("Colour", color, glm::vec4(1),
                     RowWords("that the materials are multiplied by"),
                     [&](float width) { return ui::color_field(theme, "Colour", color, width); });
            changed.color = glm::dvec3(glm::vec3(color));
        }
    }
    if (brush == TileBrush::scatter ||
        (!lays && brush != TileBrush::adjust && brush != TileBrush::grab))
        fields(&TileStroke::radius);
    fields(&TileStroke::mirror);
    if (lays && brush != TileBrush::strand)
        ui::rows_if(theme, stroke.mirror != TileMirror::none, "The stroke has no mirror.",
                    [&] { fields(&TileStroke::mirrors_tiles); });
    propose_edit(editor, rows.edit, [&] { return EditTileStroke{id, number, changed}; });
    ui::gap(theme, 4);
    ImGui::PopID();
}

} // namespace

void draw_tile_strokes(Editor& editor, const ui::Theme& theme, Id id, const Tiling& tiling)
{
    const auto shown = editor.session.evaluated().objects.find(id);
    for (std::size_t i = 0; i < tiling.strokes.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        const TileStroke& stroke = *tiling.strokes[i];
        stroke_row(editor, theme, id, number, stroke);
        const auto& open = editor.memory.of<OpenStroke>();
        if (open.layer != id || open.number != number) continue;
        double limit = std::numeric_limits<double>::infinity();
        if (shown != editor.session.evaluated().objects.end() &&
            i < shown->second->stroke_limits.size())
            limit = shown->second->stroke_limits[i];
        stroke_numbers(editor, theme, id, number, stroke, tiling.look.height, limit);
    }
}

} // namespace trivar
