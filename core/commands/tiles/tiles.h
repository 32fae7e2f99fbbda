// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/tiles/tile_files.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/tiles_fields.h"

namespace trivar {

// The largest numbers of strokes of one object, and of samples of one stroke.
inline constexpr std::size_t most_tile_strokes = 4096, most_tile_samples = 20'000;

// Throws Rejected for a stroke that cannot be: without samples, with too many of them, with a
// normal that is no direction.
void check(const TileStroke& stroke);

// The document with an object as a layer of tiles. Throws Rejected for strokes that cannot be or
// are too many, and where the object cannot be a tile, or not on that base.
Document with_tiling(Document document, Id id, Tiling tiling);

struct PaintTiles {
    static constexpr std::string_view
        verb = "paint_tiles",
        summary = "Paint copies of an object onto another one with one stroke of a brush. The "
                  "first stroke makes the object a layer of tiles on that other one.";
    static constexpr CommandNature nature{.icon = CommandIcon::place,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    Id base = 0;
    TileStroke stroke;
    std::vector<MixedTile> others = {};
    double overlap = 0;
    std::vector<TileFile> files = {};
    bool operator==(const PaintTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of what becomes the tile; 0: the first of the files",
              required.names_object());
        field("base", c.base, "id of what is painted on", required.names_object());
        spread(c.stroke, field);
        field("others", c.others, FieldsOf<MixedTile>::besides_help);
        field("overlap", c.overlap,
              "how far the tiles of a strand reach into the next ones, in shares of their cells; "
              "of a layer that begins with this stroke",
              in_range(0, 0.45));
        field("files", c.files, FieldsOf<TileFile>::help);
    }
};
Document applied(Document document, const PaintTiles& command);
StepTitle title(const PaintTiles& c, const StepDocuments& step);

struct EditTileStroke {
    static constexpr std::string_view verb = "edit_tile_stroke",
                                      summary = "Change a stroke with which tiles were painted.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    TileStroke stroke;
    bool operator==(const EditTileStroke&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("number", c.number, "which of its strokes, the first is 1",
              required_in_range(1, 1e6));
        spread(c.stroke, field);
    }
};
Document applied(Document document, const EditTileStroke& command);
StepTitle title(const EditTileStroke& c, const StepDocuments& step);

struct RemoveTileStrokes {
    static constexpr std::string_view verb = "remove_tile_strokes",
                                      summary = "Remove strokes with which tiles were painted.";
    Id object = 0;
    std::vector<int> numbers;
    bool operator==(const RemoveTileStrokes&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("numbers", c.numbers, "which of them, the first is 1; empty: all", in_range(1, 1e6));
    }
};
Document applied(Document document, const RemoveTileStrokes& command);
StepTitle title(const RemoveTileStrokes& c, const StepDocuments& step);

struct SetTiles {
    static constexpr std::string_view verb = "set_tiles",
                                      summary = "Change what holds for all tiles of layers.";
    std::vector<Id> objects;
    TileLook look;
    bool operator==(const SetTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of layers of tiles", required.names_object());
        spread(c.look, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetTiles> as_it_is(const Object& object, Id id)
    {
        if (!object.tiles) return {};
        return SetTiles{{id}, object.tiles->look};
    }
};
Document applied(Document document, const SetTiles& command);
StepTitle title(const SetTiles& c, const StepDocuments& step);

struct OfClearTiles {
    static constexpr std::string_view verb = "clear_tiles",
                                      summary = "Make layers of tiles single objects again.",
                                      help = "ids of layers of tiles",
                                      title = "Make {} a single object again";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
};
using ClearTiles = OnObjects<OfClearTiles>;
Document applied(Document document, const ClearTiles& command);

struct CoverWithTiles {
    static constexpr std::string_view
        verb = "cover_with_tiles",
        summary = "Cover all of an object with copies of another one, side by side and without "
                  "gaps. The pattern none takes the cover away; painted tiles stay.";
    static constexpr CommandNature nature{.icon = CommandIcon::place,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    Id base = 0;
    TileCover cover{.pattern = TilePattern::grid};
    std::vector<MixedTile> others = {};
    std::vector<TileFile> files = {};
    bool operator==(const CoverWithTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of what becomes the tile; 0: the first of the files",
              required.names_object());
        field("base", c.base, "id of what is covered", required.names_object());
        spread(c.cover, field);
        field("others", c.others, FieldsOf<MixedTile>::besides_help);
        field("files", c.files, FieldsOf<TileFile>::help);
    }
};
Document applied(Document document, const CoverWithTiles& command);
StepTitle title(const CoverWithTiles& c, const StepDocuments& step);

} // namespace trivar
