// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_tiles.h"

#include "core/base/number_text.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/document/fields/mix_fields.h"
#include "core/document/fields/view_fields.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/inspector_masks.h"
#include "editor/panels/inspector/key_gutter.h"
#include "editor/panels/inspector/tile_cell.h"
#include "editor/tools/tiles/cover.h"
#include "ui/icons.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <limits>

namespace trivar {
namespace {

// Rows for the objects of a mix, each with its weight and, but for the layer's own, a button that
// takes it out.
void mix_rows(Editor& editor, const ui::Theme& theme, Id layer, const Tiling& tiling)
{
    Session& session = editor.session;
    MixTiles mixed{layer, tiling.weight, tiling.others};
    ui::Edit edit = ui::Edit::none;
    const float side = theme.size.row;
    const auto weight_row = [&](Id id, double& weight, float taken) {
        ImGui::PushID(static_cast<int>(id));
        const ui::Row at = ui::label_row(theme, object(session.document(), id).name, false,
                                         std::string(FieldsOf<MixedTile>::weight_help));
        const ui::Edit one = ui::number_field(theme, "weight", weight,
                                              {.lo = 0, .hi = 1000, .step = 0.1}, at.width - taken);
        if (one != ui::Edit::none) edit = one;
        ImGui::PopID();
    };
    ui::fact_row(theme, "Mixed from", fmt::format("{} objects", mixed.others.size() + 1),
                 theme.color.text, "each tile is one of them; the numbers say how often");
    weight_row(layer, mixed.weight, 0);
    for (std::size_t i = 0; i < mixed.others.size(); ++i) {
        const Id id = mixed.others[i].object;
        weight_row(id, mixed.others[i].weight, side + theme.px(4));
        ImGui::SameLine(0, theme.px(4));
        ImGui::PushID(static_cast<int>(id));
        if (ui::icon_button(theme, "take out", ui::icon::trash, {side, side},
                            {"Take this object out of the mix", {}, {}})) {
            MixTiles without{layer, tiling.weight, tiling.others};
            without.others.erase(without.others.begin() + static_cast<long>(i));
            session.run(without);
        }
        ImGui::PopID();
    }
    propose_edit(editor, edit, [&] { return mixed; });
}

void draw_cover(Editor& editor, const ui::Theme& theme, Id id, const Tiling& tiling,
                const KeyGutter& keys)
{
    TileCover cover = tiling.cover;
    ValueRows rows{theme, &keys};
    FieldRows<TileCover> fields(rows, cover, "tiles.cover");
    fields(&TileCover::pattern);
    const bool covers = cover.pattern != TilePattern::none,
               by_texture = cover.pattern == TilePattern::texture;
    ui::rows_if(theme, by_texture, "Only for the pattern Texture.", [&] {
        fields(&TileCover::columns);
        fields(&TileCover::rows);
    });
    ui::rows_if(theme, covers && !by_texture, "Only for patterns of cells.", [&] {
        fields(&TileCover::size);
        fields(&TileCover::per_face);
        fields(&TileCover::even_height);
    });
    ui::rows_if(theme, covers, "There is no pattern.", [&] {
        fields(&TileCover::height_variation);
        ui::rows_if(theme, cover.height_variation > 0, "The heights do not vary.",
                    [&] { fields(&TileCover::seed); });
    });
    // The first time, tiles get a size that fits what they cover.
    if (tiling.cover == TileCover{} && cover.pattern != TilePattern::none)
        if (const double length = usual_tile_length(editor.session, tiling.base); length > 0)
            cover.size = length;
    propose_edit(editor, rows.edit, [&] { return CoverWithTiles{id, tiling.base, cover}; });
}

bool has_stroke_of(const Tiling& tiling, TileBrush brush)
{
    return std::ranges::any_of(
        tiling.strokes, [&](const Ref<TileStroke>& stroke) { return stroke->brush == brush; });
}

void limit_row(const ui::Theme& theme, double limit)
{
    const bool any = std::isfinite(limit);
    ui::fact_row(theme, "Fold limit", any ? ui::short_number(limit) + " x" : "none",
                 any ? theme.color.text : theme.color.text_3,
                 "the height up to which no tile folds, as the base is bent now; a drag of the "
                 "height stops there, and goes on if you pull further");
}

} // namespace

double just_below(double limit)
{
    return limit * (1 - 1e-9);
}

void draw_tiles(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Tiles")) return;
    Session& session = editor.session;
    const Tiling tiling = *object(session.document(), id).tiles;
    if (const auto base = session.document().objects.find(tiling.base);
        base != session.document().objects.end())
        ui::fact_row(theme, tiling.strokes.empty() ? "Covers" : "Painted on", base->second->name,
                     theme.color.text, "the object that carries the tiles");
    else
        bind_row(editor, theme, tiling.strokes.empty() ? "Covers" : "Painted on", id);
    TileLook look = tiling.look;
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<TileLook> fields(rows, look, "tiles");
    fields(&TileLook::scale);
    const auto shown = session.evaluated().objects.find(id);
    const EvaluatedObject* effects =
        shown != session.evaluated().objects.end() ? shown->second.get() : nullptr;
    const double limit = effects ? effects->height_limit : std::numeric_limits<double>::infinity();
    rows.stop = just_below(limit);
    fields(&TileLook::height);
    limit_row(theme, limit);
    fields(&TileLook::sink);
    const bool strands = has_stroke_of(tiling, TileBrush::strand),
               lines = has_stroke_of(tiling, TileBrush::line),
               single = lines || has_stroke_of(tiling, TileBrush::scatter) ||
                        has_stroke_of(tiling, TileBrush::fill),
               apart = single || tiling.cover.pattern != TilePattern::none || !strands;
    if (apart)
        fields(&TileLook::turn_deg);
    else
        ui::fact_row(theme, "Turn", "by Roll", theme.color.text_3,
                     "the tiles of a strand hang together, so they turn about its path alone");
    fields(&TileLook::guard);
    if (!tiling.strokes.empty() && apart) fields(&TileLook::keep_overlaps);
    fields(&TileLook::growth);
    fields(&TileLook::growth_softness);
    fields(&TileLook::wave);
    ui::rows_if(theme, look.wave != 0, "Wave is 0.", [&] {
        fields(&TileLook::wave_phase);
        fields(&TileLook::wave_length);
        fields(&TileLook::wave_direction);
        fields(&TileLook::wave_variation);
    });
    if (strands) {
        fields(&TileLook::overlap);
        fields(&TileLook::roll_deg);
        fields(&TileLook::alternate_deg);
    }
    if (apart) {
        fields(&TileLook::slide_x);
        fields(&TileLook::slide_y);
    } else
        ui::fact_row(theme, "Slide", "by Slide along", theme.color.text_3,
                     "the tiles of a strand hang together, so they slide along its path alone");
    if (lines || strands) fields(&TileLook::slide_along);
    rows.take(draw_tile_cell(session, theme, id, look));
    fields(&TileLook::cell_x0);
    fields(&TileLook::cell_x1);
    fields(&TileLook::cell_y0);
    fields(&TileLook::cell_y1);
    fields(&TileLook::base_level);
    const Object& layer = object(session.document(), id);
    if (tiling.into != 0) {
        ui::fact_row(theme, "Become", object(session.document(), tiling.into).name,
                     theme.color.text, "what the tiles become as the morph goes from 0 to 1");
        fields(&TileLook::morph);
        fields(&TileLook::morph_variation);
    }
    const bool plays = !layer.playing.clip.empty();
    if (plays) fields(&TileLook::clip_variation);
    if (plays || tiling.into != 0)
        ui::rows_if(theme, look.morph_variation > 0 || look.clip_variation > 0,
                    "Nothing varies from tile to tile.", [&] { fields(&TileLook::phases); });
    if (!tiling.others.empty()) mix_rows(editor, theme, id, tiling);
    propose_edit(editor, rows.edit, [&] { return SetTiles{{id}, look}; });
    if (tiling.base != 0) draw_cover(editor, theme, id, tiling, keys);
    if (!tiling.strokes.empty())
        ui::fact_row(theme, "Overlapping",
                     effects ? fmt::format("{} of {}", with_commas(effects->overlapping),
                                           with_commas(effects->painted))
                             : "",
                     theme.color.text,
                     "painted tiles that overlap another one by more than a tenth of their side");
    draw_masks(editor, theme, id, tiling, keys);
    draw_tile_strokes(editor, theme, id, tiling);
    ui::gap(theme, 8);
}

} // namespace trivar
