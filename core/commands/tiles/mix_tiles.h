// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tile_files.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/tiles_fields.h"

namespace trivar {

// The largest number of objects that the tiles of one layer are mixed from, besides its own.
inline constexpr std::size_t most_mixed = 64;

// The document with a layer's tiles mixed with others in place of those with which they are mixed
// now. Throws Rejected where one of them cannot be a tile of that layer, or comes twice.
Document with_mix(Document document, Id layer, double weight, std::vector<MixedTile> others);

struct MixTiles {
    static constexpr std::string_view verb = "mix_tiles",
                                      summary =
                                          "Mix the tiles of a layer with other objects. Each "
                                          "tile is one of them, chosen by its own seed. Objects "
                                          "that come into the mix are hidden.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    double weight = 1;
    std::vector<MixedTile> others;
    std::vector<TileFile> files = {};
    bool operator==(const MixTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("weight", c.weight, "how often the object itself is there", in_range(0, 1000));
        field("others", c.others, "the other objects; none: the layer is not mixed");
        field("files", c.files,
              "models that are added to the scene in the same step, and mixed in");
    }
};
Document applied(Document document, const MixTiles& command);
StepTitle title(const MixTiles& c, const StepDocuments& step);

// The document with what a layer's own tiles become by its morph; 0: nothing. Throws Rejected as
// with_mix() does.
Document with_morph(Document document, Id layer, Id into);

struct MorphTiles {
    static constexpr std::string_view
        verb = "morph_tiles",
        summary =
            "Let the tiles of a layer become the shape of another object, as far as the morph "
            "of set_tiles says. Both must have the same vertices and faces. The other object "
            "is hidden.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    Id into = 0;
    bool operator==(const MorphTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("into", c.into, "id of another object; 0: tiles stay what they are",
              required.names_object());
    }
};
Document applied(Document document, const MorphTiles& command);
StepTitle title(const MorphTiles& c, const StepDocuments& step);

} // namespace trivar
