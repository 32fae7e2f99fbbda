// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"

#include <string>
#include <vector>

namespace trivar {

// A KnownObject is an object of the scene on which something lies. Both number and name must fit,
// so that another scene's object of that number is not taken for it.
struct KnownObject {
    Id object = 0;
    std::string name;
    bool operator==(const KnownObject&) const = default;
};

struct CopiedMixedTile {
    KnownObject tile;
    double weight = 1;
    bool operator==(const CopiedMixedTile&) const = default;
};

struct CopiedMask {
    TileMask mask; // without its curve
    std::optional<KnownObject> around = {};
    bool operator==(const CopiedMask&) const = default;
};

struct CopiedTiling {
    KnownObject base;
    TileLook look;
    std::vector<TileStroke> strokes;
    double weight = 1;
    std::vector<CopiedMixedTile> others = {};
    std::optional<KnownObject> into = {};
    TileCover cover = {};
    std::vector<CopiedMask> masks = {};
    bool operator==(const CopiedTiling&) const = default;
};

template <> struct FieldsOf<KnownObject> {
    static constexpr std::string_view told_as = "[base](#base)";
    static void fields(auto& k, auto&& field)
    {
        field("object", k.object, "its id", required.names_object());
        field("name", k.name,
              "its name, so that another object of the same id is not mistaken for it", required);
    }
};
template <> struct FieldsOf<CopiedMixedTile> {
    static constexpr std::string_view told_as = "[copied mixed tile](#copied-mixed-tile)";
    static void fields(auto& m, auto&& field)
    {
        field("tile", m.tile, "another copy, or an object of the scene", required);
        field("weight", m.weight, FieldsOf<MixedTile>::weight_help, in_range(0, 1000));
    }
};
template <> struct FieldsOf<CopiedMask> {
    static constexpr std::string_view told_as = "[copied mask](#copied-mask)";
    static void fields(auto& m, auto&& field)
    {
        FieldsOf<TileMask>::own_fields(m.mask, field);
        field("around", m.around, "the object with the curves of a gradient round a curve");
    }
};
template <> struct FieldsOf<CopiedTiling> {
    static constexpr std::string_view told_as = "[tiling](#tiling)";
    static void fields(auto& t, auto&& field)
    {
        field("base", t.base, "what it is painted on: another copy, or an object of the scene");
        field("look", t.look, "what holds for all tiles");
        field("strokes", t.strokes, "the strokes, the first one first");
        field("weight", t.weight, "how often the object itself is there", in_range(0, 1000));
        field("others", t.others,
              "what its tiles are mixed with: other copies, or objects of the scene");
        field("into", t.into, "what its own tiles become by the morph");
        field("cover", t.cover, "how they cover all of it", later);
        field("masks", t.masks, "where there are more of them, larger or higher ones", later);
    }
};

} // namespace trivar
