// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/tile_files.h"

#include "core/commands/objects/import.h"

namespace trivar {

WithTileFiles with_tile_files(Document document, Id layer, std::vector<MixedTile> others,
                              const std::vector<TileFile>& files)
{
    WithTileFiles out{std::move(document), layer, std::move(others)};
    for (const TileFile& each : files) {
        const Id id = out.document.next_id;
        out.document =
            applied(std::move(out.document), ImportModel{each.file, each.name, Transform{}});
        if (out.layer == 0)
            out.layer = id;
        else
            out.others.push_back({id, 1});
    }
    return out;
}

} // namespace trivar
