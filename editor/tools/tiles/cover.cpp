// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/cover.h"

#include "core/base/rounded.h"
#include "core/stages/tiled_base.h"

#include <algorithm>

namespace trivar {

double usual_tile_length(const Session& session, Id base)
{
    constexpr double tiles_along = 25;
    const auto shown = session.evaluated().objects.find(base);
    if (shown == session.evaluated().objects.end() || shown->second->parts.empty()) return 0;
    const EvaluatedObject& object_shown = *shown->second;
    const Part& part = object_shown.parts.front();
    const RestToWorld way(part,
                          mesh_to_model(object_shown, object(session.document(), base), part));
    const glm::dvec3 extent = object_shown.bounds->size();
    const double scale = way.scale({0, 0, 0});
    if (!(scale > 0)) return 0;
    return rounded(std::max({extent.x, extent.y, extent.z, 1e-6}) / scale / tiles_along, 2);
}

std::optional<CoverWithTiles> cover_wish(const Session& session)
{
    const std::vector<Id> chosen = session.selected.ids();
    if (chosen.size() != 2 || session.committing()) return {};
    const Document& document = session.document();
    const Id tile = chosen[0], base = chosen[1];
    const Object& o = object(document, tile);
    if (!kind_of(o).has_surface || o.stroke || locked(document, tile) ||
        !kind_of(document, base).has_surface)
        return {};
    if (o.tiles && o.tiles->base != 0 && o.tiles->base != base) return {};
    const double length = usual_tile_length(session, base);
    if (!(length > 0)) return {};
    return CoverWithTiles{tile, base, {.pattern = TilePattern::grid, .size = length}};
}

} // namespace trivar
