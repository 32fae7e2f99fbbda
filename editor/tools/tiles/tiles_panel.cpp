// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/tiles.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

// The order of the option bar; after Fill comes the cover, which is no brush of strokes.
constexpr std::array brushes_in_order{TileBrush::scatter, TileBrush::line,  TileBrush::strand,
                                      TileBrush::fill,    TileBrush::erase, TileBrush::comb,
                                      TileBrush::resize,  TileBrush::raise, TileBrush::color,
                                      TileBrush::morph,   TileBrush::grab};
constexpr int cover_brush = 4; // in that list

} // namespace

void TilesTool::options(Session& session, const ui::Theme& theme, float width)
{
    const ui::NumberStyle length{.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"};
    const bool lays_strokes = lays() && !covers_, strand = lays_strands(),
               line = settings_.brush == TileBrush::line || strand,
               fills = settings_.brush == TileBrush::fill,
               grabs = settings_.brush == TileBrush::grab;
    std::vector<ui::Option> options;
    options.push_back(
        {"Brush", 96,
         [&](float field) {
             const auto now = std::ranges::find(brushes_in_order, settings_.brush);
             int kind = static_cast<int>(now - brushes_in_order.begin());
             kind = covers_ ? cover_brush : kind >= cover_brush ? kind + 1 : kind;
             ui::choice(theme, "brush", kind,
                        {"Scatter", "Line", "Strand", "Fill", "Cover", "Erase", "Comb", "Resize",
                         "Raise", "Colour", "Morph", "Grab"},
                        field);
             covers_ = kind == cover_brush;
             const int stroke = kind > cover_brush ? kind - 1 : kind;
             if (!covers_) settings_.brush = brushes_in_order[static_cast<std::size_t>(stroke)];
         },
         "Scatter, Line and Fill lay tiles, Strand lays them end to end, Cover lays them all over "
         "what is clicked, Grab takes single ones; the others change those under the brush. With "
         "Ctrl, tiles are erased; with Shift, the stroke is straight."});
    double shown_radius = radius(session), shown_size = size(session);
    const auto number = [&](const char* words, const char* id, double& value,
                            const ui::NumberStyle& style, const char* help, auto&& taken) {
        options.push_back({words, 88,
                           [&theme, id, &value, style, taken](float field) {
                               if (ui::number_field(theme, id, value, style, field) !=
                                   ui::Edit::none)
                                   taken();
                           },
                           help});
    };
    if (covers_) {
        if (cover_.pattern != TilePattern::texture)
            number("Size", "size", shown_size, length,
                   "Length of a tile along its row. 0: from the object's size.",
                   [&] { size_ = shown_size; });
        cover_options(options, theme);
        return ui::option_bar(theme, options, width);
    }
    if (!line && !fills && !grabs)
        number(
            "Radius", "radius", shown_radius, length,
            "Size of the brush. 0: from the object's size. The wheel changes it while you paint.",
            [&] { radius_ = shown_radius; });
    const auto nothing = [] {};
    if (lays_strokes) {
        number("Size", "size", shown_size, length,
               strand ? "Length of a tile along the strand; 0 is half of the radius."
                      : "Side of a tile; 0 is half of the radius.",
               [&] { size_ = shown_size; });
    }
    if (strand) {
        const ui::NumberStyle times{.lo = 0.01, .hi = 100, .unit = "x"};
        number("Width", "width", settings_.width, times, "Factor of the width of the strand.",
               nothing);
        number("Height", "height", settings_.height, times, "Factor of the height of the strand.",
               nothing);
        number("Taper", "taper", settings_.taper, ui::percent_style(),
               "Share by which the strand is narrower and lower at its end.", nothing);
        options.push_back(
            {"Ends", 96,
             [&](float field) {
                 int ends = settings_.apart ? 1 : 0;
                 ui::choice(theme, "ends", ends, {"Join", "Stay apart"}, field);
                 settings_.apart = ends == 1;
             },
             "Join: a strand goes on from the end of another one near it, and closes where its own "
             "ends meet."});
    } else if (lays_strokes) {
        number("Spacing", "spacing", settings_.spacing, {.lo = 0.05, .hi = 100, .unit = "x"},
               "Distance between tiles, in sizes.", nothing);
        number("Vary size", "vary", settings_.size_variation, ui::percent_style(),
               "Tiles are smaller by up to this share, at random.", nothing);
        number("Turn", "turn", settings_.turn_variation_deg, {.lo = 0, .hi = 180, .unit = "deg"},
               "Tiles are turned by up to this angle either way, at random.", nothing);
        heading_options(options, theme);
    } else if (settings_.brush != TileBrush::erase && !grabs)
        number("Strength", "strength", settings_.strength, ui::percent_style(-1, 1),
               "Of the brush; with Ctrl it goes the other way.", nothing);
    stroke_options(options, theme);
    ui::option_bar(theme, options, width);
}

void TilesTool::heading_options(std::vector<ui::Option>& options, const ui::Theme& theme)
{
    options.push_back(ui::enum_option(
        ui::choice, theme, "Heading", 124, "heading", settings_.heading,
        {"Along stroke", "Upward", "Random", "Least curvature", "Most curvature", "To a point"},
        "Where the X axis of the tile points: along the stroke, up, anywhere, where "
        "the surface bends least or most, or to a point."));
    if (settings_.heading == TileHeading::to_point)
        options.push_back(
            {"Point", 72,
             [&](float field) {
                 const char* words = picking_ ? "Click it" : point_ ? "Other" : "Pick";
                 if (ui::button(theme, words, ui::ButtonKind::plain, {field, theme.size.row}))
                     picking_ = !picking_;
             },
             "The next click on the surface is the point to which tiles head; until "
             "then it is the origin of what they are painted on."});
}

void TilesTool::stroke_options(std::vector<ui::Option>& options, const ui::Theme& theme)
{
    const TileBrush brush = settings_.brush;
    if (brush == TileBrush::fill)
        options.push_back(
            ui::enum_option(ui::choice, theme, "Area", 88, "area", settings_.area,
                            {"Island", "Material", "Faces", "All"},
                            "What a click fills: all that is connected, all of that material, the "
                            "face alone, or the whole object."));
    if (brush == TileBrush::color)
        options.push_back({"Colour", 96,
                           [&](float field) {
                               glm::vec4 color(glm::vec3(color_), 1);
                               ui::color_field(theme, "colour", color, field);
                               color_ = glm::dvec3(glm::vec3(color));
                           },
                           "The colours of the materials are multiplied by it; Ctrl takes it away "
                           "again."});
    options.push_back(ui::enum_option(
        ui::choice, theme, "Mirror", 64, "mirror", settings_.mirror, {"Off", "X", "Y", "Z"},
        "The stroke works on the other side, too: across this axis of what is "
        "painted on."));
    if (brush != TileBrush::fill && brush != TileBrush::grab)
        options.push_back(ui::enum_option(
            ui::choice, theme, "Weaker by", 72, "pressure", follows_, {"Nothing", "Speed"},
            "What makes tiles smaller or the brush weaker: a fast stroke, or nothing."));
}

void TilesTool::cover_options(std::vector<ui::Option>& options, const ui::Theme& theme)
{
    options.push_back(
        {"Pattern", 96,
         [&](float field) {
             int pattern = static_cast<int>(cover_.pattern) - 1; // without the first one
             ui::choice(theme, "pattern", pattern, {"Grid", "Brick", "Hexagon", "Texture"}, field);
             cover_.pattern = static_cast<TilePattern>(pattern + 1);
         },
         "Brick shifts every other row by half a tile; hexagons reach into the rows beside "
         "theirs; Texture lays one tile on each cell of the texture square."});
    if (cover_.pattern == TilePattern::texture) {
        const auto count = [&](const char* label, const char* id, int& value, const char* help) {
            options.push_back({label, 80,
                               [&theme, id, &value](float field) {
                                   ui::integer_field(theme, id, value, {.lo = 1, .hi = 2000},
                                                     field);
                               },
                               help});
        };
        count("Columns", "columns", cover_.columns, "Number of cells across the texture square.");
        count("Rows", "rows", cover_.rows, "Number of cells up the texture square.");
    } else
        options.push_back(
            {"Per face", 88,
             [&](float field) {
                 ui::integer_field(theme, "per face", cover_.per_face,
                                   {.lo = 0, .hi = 1000, .zero = "by size"}, field);
             },
             "Number of tiles along each side of a face of what is covered; 0: as the size says."});
    options.push_back({"Vary height", 88,
                       [&](float field) {
                           ui::number_field(theme, "vary height", cover_.height_variation,
                                            ui::percent_style(), field);
                       },
                       "Tiles are lower by up to this share, at random."});
    options.push_back({"Seed", 72,
                       [&](float field) {
                           ui::integer_field(theme, "seed", cover_.seed, {.lo = 0, .hi = 1e9},
                                             field);
                       },
                       "Another number gives other random heights."});
}

} // namespace trivar
