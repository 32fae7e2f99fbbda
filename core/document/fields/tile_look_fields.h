// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<TileLook> {
    static constexpr std::string_view told_as = "values of [set_tiles](#set_tiles)";
    static void fields(auto& l, auto&& field)
    {
        field("scale", l.scale, "factor of the sizes of all tiles",
              in_range(1e-3, 100).in(Unit::times));
        field("height", l.height, "factor of the heights of all tiles",
              in_range(0, 100).in(Unit::times));
        field("sink", l.sink, "how deep tiles stand in their base, as a share of their height",
              in_range(-10, 10).in(Unit::share));
        field("turn_deg", l.turn_deg, "of all tiles about their normals, degrees",
              in_range(-36000, 36000).called("Turn").in(Unit::degrees));
        field("guard", l.guard, "tiles that would fold are lowered until they do not",
              any_value.called("Folds").says("prevented", "allowed"));
        field("growth", l.growth, "share of the painting that has grown, in the order of painting",
              later_in_range(0, 1).resting_at(1).in(Unit::share));
        field("growth_softness", l.growth_softness,
              "share of the painting in which a tile grows to its full size",
              later_in_range(0, 1).resting_at(0.1).called("Softness").in(Unit::share));
        field("wave", l.wave, "by how much heights go up and down, as a share of them",
              later_in_range(0, 10).in(Unit::share));
        field("wave_phase", l.wave_phase, "turns of the wave; keys on it let the wave run",
              later_in_range(-1e6, 1e6).in(Unit::turns));
        field("wave_length", l.wave_length,
              "length of the wave, metres on the model; 0: all tiles move at once",
              later_in_range(0, 1e9).in(Unit::metres).zero_is("all at once"));
        field("wave_direction", l.wave_direction,
              "where the wave goes to, in the model's space; 0: along Z", later);
        field("wave_variation", l.wave_variation,
              "turns by which the phases of tiles differ at random",
              later_in_range(0, 1).in(Unit::turns));
        field("morph", l.morph,
              "how far tiles have become the other shape: 0 not yet, 1 altogether; may go beyond",
              later_in_range(-10, 10).in(Unit::share));
        field("morph_variation", l.morph_variation,
              "share of the morph by which the last tiles are behind the first",
              later_in_range(0, 1).in(Unit::share));
        field("clip_variation", l.clip_variation,
              "share of the clip by which tiles are ahead of each other at random",
              later_in_range(0, 1).in(Unit::share));
        field("phases", l.phases, "in how many different phases of clip and morph tiles are",
              later_in_range(1, 64).resting_at(8).without_keys());
        field("slide_x", l.slide_x, "how far tiles have gone along their own X, in sides",
              later_in_range(-1000, 1000).called("Slide X").in(Unit::sides));
        field("slide_y", l.slide_y, "how far tiles have gone along their own Y, in sides",
              later_in_range(-1000, 1000).called("Slide Y").in(Unit::sides));
        field(
            "slide_along", l.slide_along,
            "how far tiles that were laid in lines have gone along their strokes, in sides; those "
            "that leave the end are not there, and where a stroke closes they go round; tiles of "
            "strands that leave an end come in again at the other one",
            later_in_range(-1000, 1000).called("Slide along").in(Unit::sides));
        field("cell_x0", l.cell_x0,
              "where the unit cell of the tile begins along X, as a share of its box",
              later_in_range(-10, 10).called("Cell from X").in(Unit::share).without_keys());
        field("cell_x1", l.cell_x1, "where it ends along X",
              later_in_range(-10, 10)
                  .resting_at(1)
                  .called("Cell to X")
                  .in(Unit::share)
                  .without_keys());
        field("cell_y0", l.cell_y0, "where it begins along Y",
              later_in_range(-10, 10).called("Cell from Y").in(Unit::share).without_keys());
        field("cell_y1", l.cell_y1, "where it ends along Y",
              later_in_range(-10, 10)
                  .resting_at(1)
                  .called("Cell to Y")
                  .in(Unit::share)
                  .without_keys());
        field("base_level", l.base_level,
              "what of the tile lies on the surface, as a share of the height of its box",
              later_in_range(-10, 10).in(Unit::share).without_keys());
        field("overlap", l.overlap,
              "how far the tiles of a strand reach into the next ones, in shares of their cells",
              later_in_range(0, 0.45).in(Unit::share).without_keys());
        field("roll_deg", l.roll_deg, "turn of the tiles of a strand about its path, degrees",
              later_in_range(-36000, 36000).called("Roll").in(Unit::degrees));
        field("alternate_deg", l.alternate_deg,
              "turn of every other tile of a strand about its path, besides, degrees",
              later_in_range(-360, 360).called("Alternate").in(Unit::degrees).without_keys());
        field("keep_overlaps", l.keep_overlaps,
              "painted tiles that overlap earlier ones by more than a tenth of their side stay",
              later.resting_at(1).called("Overlaps").says("kept", "left out").without_keys());
    }
};

} // namespace trivar
