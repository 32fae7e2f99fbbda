// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/facet_surface.h"
#include "core/stages/tiled_base.h"
#include "core/tiles/covered_tiles.h"

#include <functional>

namespace trivar {

// A CoverLayout is a covering of a base at rest, in the space of its model.
struct CoverLayout {
    Ref<LimitBase> limit;                      // null: it lies on the facets
    Ref<FacetSurface> facets;                  // null: it lies on the limit surface
    Ref<Covering> covering;                    // null: there is none
    std::string trouble;                       // why there is none
    bool crowded = false;                      // faces are too small for tiles of that size
    std::vector<SurfacePoint> rest;            // of the covering's nodes
    std::vector<std::uint32_t> piece_of_node;  // of the base
    std::vector<std::uint32_t> piece_of_chart; // the same
    std::vector<std::uint32_t> first_point;    // of each piece in the facets' points
    std::size_t point_count = 0;               // of these points
    std::vector<SurfacePoint> middles;         // of the tiles
};

// `tile_size` is as for a Covering. Trouble is written into the layout.
CoverLayout cover_layout(const TiledPieces& pieces, const Ref<LimitBase>& limit,
                         const TileCover& cover, const glm::dvec2& tile_size);

// The texture coordinates of the charts; nothing where some piece has none. O(#C).
std::optional<ChartUvs> chart_uvs_of(const TiledPieces& pieces, const CoverLayout& layout);

// The surface over the charts as one member of the base stands. `layout` must outlive it.
std::function<SurfacePoint(const ChartPlace&)>
surface_of(const CoverLayout& layout, const TiledPieces& pieces, const std::vector<Part>& parts);

// Returns the covering as one member of its base stands, without heights. In parallel. O(#nodes).
CoveringPose pose_of(const CoverLayout& layout, const TiledPieces& pieces,
                     const std::vector<Part>& parts);

} // namespace trivar
