// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/document/fields/import_fields.h"

namespace trivar {

// A TileFile is a model that a command adds to the scene, to be among the tiles of a layer.
struct TileFile {
    ImportedFile file;
    std::string name; // empty: the file's
    bool operator==(const TileFile&) const = default;
};
template <> struct FieldsOf<TileFile> {
    static constexpr std::string_view
        told_as = "[tile file](#tile-file)",
        about = "A model that comes into the scene as a tile.",
        help = "models that are added to the scene in the same step: where object is 0 the first "
               "of them becomes the tile, and the others are mixed with it";
    static void fields(auto& f, auto&& field)
    {
        field("file", f.file, "its file, as of import", required);
        field("name", f.name, "name in the outliner; empty: the file's");
    }
};

// The document with the models of files in it, the layer that a command with them is about, and
// what that is to be mixed with. `layer` 0: the first of them. Throws Rejected for a file without a
// path.
struct WithTileFiles {
    Document document;
    Id layer = 0;
    std::vector<MixedTile> others;
};
WithTileFiles with_tile_files(Document document, Id layer, std::vector<MixedTile> others,
                              const std::vector<TileFile>& files);

} // namespace trivar
