// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/tiles_fields.h"

namespace trivar {

// The largest number of masks of a layer.
inline constexpr std::size_t most_masks = 16;

// Throws Rejected for a mask that a layer cannot have: of an object without curves, or of one that
// depends on the layer.
void check_mask(const Document& document, Id layer, const TileMask& mask);

struct MaskTiles {
    static constexpr std::string_view
        verb = "mask_tiles",
        summary = "Let a picture or a gradient say where a layer of tiles has more of them, larger "
                  "or higher ones: with one mask more, or one in place of one that it has. Masks "
                  "that drive the same multiply.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 0;
    TileMask mask = {};
    bool operator==(const MaskTiles&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("number", c.number, "which of its masks, the first is 1; 0: a new one",
              in_range(0, most_masks));
        spread(c.mask, field);
    }
};
Document applied(Document document, const MaskTiles& command);
StepTitle title(const MaskTiles& c, const StepDocuments& step);

struct RemoveTileMasks {
    static constexpr std::string_view verb = "remove_tile_masks",
                                      summary = "Remove masks of a layer of tiles.";
    Id object = 0;
    std::vector<int> numbers = {};
    bool operator==(const RemoveTileMasks&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a layer of tiles", required.names_object());
        field("numbers", c.numbers, "which of them, the first is 1; empty: all",
              in_range(1, most_masks));
    }
};
Document applied(Document document, const RemoveTileMasks& command);
StepTitle title(const RemoveTileMasks& c, const StepDocuments& step);

} // namespace trivar
