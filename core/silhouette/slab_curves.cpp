// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/slab_curves.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/polish.h"
#include "core/silhouette/silhouette_curves.h"

#include <limits>

namespace trivar {

SlabCurves::SlabCurves(const ViewPoint& view, const SilhouetteOptions& options)
    : view_(view),
      options_(options)
{
    check(view);
}

void SlabCurves::add(const ScalarField<float>& field, const LevelMesh& level, int end)
{
    // Bricks behind the slab are there for the numbers of their vertices.
    std::size_t bricks = 0;
    while (bricks < level.bricks.size() && level.bricks[bricks].middle.z < static_cast<float>(end))
        ++bricks;
    const std::uint32_t own = bricks == 0 ? 0 : level.bricks[bricks - 1].vertex_end;
    if (level.positions.size() > std::numeric_limits<std::uint32_t>::max() - first_vertex_)
        throw Rejected("the level has more than 4,294,967,295 places on the edges of the grid; "
                       "coarser data have fewer");
    std::vector<CrossedTriangle> triangles = finder_.crossed(level, view_, bricks);
    add_crossings(field, level, triangles);
    border_.add(field, level, bricks, first_vertex_);
    const std::uint64_t ahead = std::uint64_t{first_vertex_} << 32 | first_vertex_;
    for (CrossedTriangle& triangle : triangles) {
        triangle.in += ahead;
        triangle.out += ahead;
    }
    triangles_.push_back(std::move(triangles));
    first_vertex_ += own;
}

void SlabCurves::add_crossings(const ScalarField<float>& field, const LevelMesh& level,
                               std::span<const CrossedTriangle> triangles)
{
    const std::size_t before = points_.size();
    const std::uint64_t ahead = std::uint64_t{first_vertex_} << 32 | first_vertex_;
    for (const CrossedTriangle& triangle : triangles)
        for (const std::uint64_t edge : {triangle.in, triangle.out}) {
            if (!number_.number(edge + ahead).second) continue;
            const auto a = static_cast<std::uint32_t>(edge >> 32),
                       b = static_cast<std::uint32_t>(edge);
            places_.push_back(place_on_edge(level.positions[a], level.positions[b],
                                            finder_.product_at(a), finder_.product_at(b)));
            points_.push_back({.p = places_.back(), .edge = edge + ahead});
        }
    parallel_blocks(points_.size() - before, 256, [&](std::size_t begin, std::size_t end) {
        finish(field, level.level, view_, options_.polished,
               std::span(points_).subspan(before + begin, end - begin));
    });
}

Silhouettes SlabCurves::curves()
{
    // Points are left out by where the mesh has them, as those of a whole volume are.
    const EdgeChains chains = edge_chains(triangles_);
    std::vector<glm::vec3> places;
    places.reserve(chains.edges.size());
    for (const std::uint64_t edge : chains.edges) places.push_back(places_[number_.find(edge)]);
    Silhouettes out = curves_of(chains, places, options_.spacing);
    for (SilhouettePoint& point : out.points) point = points_[number_.find(point.edge)];
    triangles_.clear();
    places_.clear();
    points_.clear();
    number_ = {};
    return out;
}

} // namespace trivar
