// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/cover_layout.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/tiles/cover_heights.h"

#include <algorithm>

namespace trivar {
namespace {

// The faces of a mesh with all its points; corners that repeat the one before are left out, and
// faces with less than three.
struct FacetCage {
    Cage cage;
    std::vector<std::size_t> from; // #corners: of all corners of the mesh's cage
};
FacetCage facet_cage(const Mesh& mesh, const glm::dmat4& to_model)
{
    Cage all = cage_of(mesh, to_model);
    FacetCage out;
    out.cage.points = std::move(all.points);
    std::size_t first = 0;
    for (const int size : all.face_sizes) {
        std::vector<std::size_t> face;
        const auto at = [&](std::size_t k) { return all.corners[k]; };
        for (std::size_t k = first; k < first + static_cast<std::size_t>(size); ++k)
            if (face.empty() || at(face.back()) != at(k)) face.push_back(k);
        while (face.size() > 1 && at(face.back()) == at(face.front())) face.pop_back();
        first += static_cast<std::size_t>(size);
        if (face.size() < 3) continue;
        out.cage.face_sizes.push_back(static_cast<int>(face.size()));
        for (const std::size_t k : face) out.cage.corners.push_back(at(k));
        out.from.insert(out.from.end(), face.begin(), face.end());
    }
    return out;
}

// The texture coordinates of all corners of a mesh's cage.
std::vector<glm::dvec2> corner_uvs(const Mesh& mesh, const glm::dmat4& to_model)
{
    std::vector<glm::dvec2> out;
    for (const std::uint32_t v : mesh.corners) out.emplace_back(mesh.uvs.front()[v]);
    if (glm::determinant(glm::dmat3(to_model)) < 0) // as cage_of() turns faces round
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            std::reverse(out.begin() + mesh.face_begin[f], out.begin() + mesh.face_begin[f + 1]);
    return out;
}

Ref<FacetSurface> facets_on(const TiledPieces& pieces, CoverLayout& out)
{
    std::vector<Cage> cages;
    for (const TiledPiece& piece : pieces) {
        out.first_point.push_back(static_cast<std::uint32_t>(out.point_count));
        cages.push_back(facet_cage(*piece.mesh, piece.to_model).cage);
        out.point_count += cages.back().points.size();
    }
    const JoinedCages all = joined(cages, 3, 4);
    Ref<FacetSurface> facets = std::make_shared<const FacetSurface>(all.cage);
    for (std::uint32_t c = 0; c < facets->net().size(); ++c)
        out.piece_of_chart.push_back(static_cast<std::uint32_t>(all.piece_of(c)));
    return facets;
}

// Tiles that are shorter than this share of what was asked for are told.
constexpr double crowded_below = 0.5;

// Returns the mean length of cells along their rows.
double mean_length(const Covering& covering, std::span<const SurfacePoint> points)
{
    double sum = 0;
    int count = 0;
    for (const double length : heights_along_rows(covering, points, 1))
        if (length > 0) sum += length, ++count;
    return count > 0 ? sum / count : 0;
}

std::vector<SurfacePoint> middles_of(const Covering& covering, std::span<const SurfacePoint> points)
{
    std::vector<SurfacePoint> out(covering.tiles().size());
    parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Covering::Spot spot = covering.spot(covering.tiles()[k], {0.5, 0.5});
            const TilePoint at = tile_point(covering.patch(spot.cell, points), {spot.uv, 0});
            const double length = glm::length(at.z);
            out[k] = {at.p, length > 0 ? at.z / length : glm::dvec3(0, 0, 1)};
        }
    });
    return out;
}

// The facets with the points of parts in the world.
FacetSurface moved_facets(const CoverLayout& layout, const std::vector<Part>& parts)
{
    std::vector<glm::dvec3> points(layout.point_count, glm::dvec3(0));
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Mesh& mesh = *parts[k].mesh();
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            points[layout.first_point[k] + mesh.point(v)] =
                glm::dvec3(parts[k].to_world * glm::dvec4(mesh.positions[v], 1));
    }
    return layout.facets->moved(points);
}

} // namespace

CoverLayout cover_layout(const TiledPieces& pieces, const Ref<LimitBase>& limit,
                         const TileCover& cover, const glm::dvec2& tile_size)
{
    CoverLayout out;
    try {
        if (limit) {
            out.limit = limit;
            for (std::uint32_t c = 0; c < limit->surface().net().size(); ++c)
                out.piece_of_chart.push_back(static_cast<std::uint32_t>(limit->piece_of(c)));
        } else
            out.facets = facets_on(pieces, out);
        const ChartSurface& surface =
            limit ? static_cast<const ChartSurface&>(limit->surface()) : *out.facets;
        if (surface.net().size() == 0) throw Rejected("what it covers has no faces");
        out.covering = std::make_shared<const Covering>(surface, cover, tile_size);
        out.rest = out.covering->points(surface);
    } catch (const Rejected& error) {
        out.trouble = error.what();
        return out;
    }
    const Covering& covering = *out.covering;
    out.piece_of_node.resize(out.rest.size());
    for (std::uint32_t c = 0; c < covering.cell_count(); ++c)
        for (const std::uint32_t node : covering.cell_nodes(c))
            out.piece_of_node[node] = out.piece_of_chart[covering.cell(c).chart];
    out.middles = middles_of(covering, out.rest);
    out.crowded =
        cover.per_face == 0 && mean_length(covering, out.rest) < crowded_below * cover.size;
    return out;
}

std::optional<ChartUvs> chart_uvs_of(const TiledPieces& pieces, const CoverLayout& layout)
{
    std::vector<Cage> cages;
    std::vector<glm::dvec2> uvs;
    for (const TiledPiece& piece : pieces) {
        if (layout.limit) {
            const Mesh ready = ready_to_subdivide(*piece.cage.cage);
            if (ready.uvs.empty()) return {};
            cages.push_back(cage_of(ready, piece.cage.to_model));
            const std::vector<glm::dvec2> own = corner_uvs(ready, piece.cage.to_model);
            uvs.insert(uvs.end(), own.begin(), own.end());
            continue;
        }
        if (piece.mesh->uvs.empty()) return {};
        FacetCage facets = facet_cage(*piece.mesh, piece.to_model);
        const std::vector<glm::dvec2> own = corner_uvs(*piece.mesh, piece.to_model);
        for (const std::size_t k : facets.from) uvs.push_back(own[k]);
        cages.push_back(std::move(facets.cage));
    }
    const ChartNet& net = layout.limit ? layout.limit->surface().net() : layout.facets->net();
    return chart_uvs(net, joined(cages).cage, uvs);
}

std::function<SurfacePoint(const ChartPlace&)>
surface_of(const CoverLayout& layout, const TiledPieces& pieces, const std::vector<Part>& parts)
{
    if (layout.limit)
        return [&layout, ways = ways_to_world(pieces, parts)](const ChartPlace& at) {
            const LimitSurface& surface = layout.limit->surface();
            return ways[layout.piece_of_chart[at.chart]](
                {surface.position(at), surface.normal(at)});
        };
    return [&layout, mirrored = mirrored_parts(pieces, parts),
            facets = moved_facets(layout, parts)](const ChartPlace& at) -> SurfacePoint {
        const glm::dvec3 normal = facets.normal(at);
        return {facets.position(at), mirrored[layout.piece_of_chart[at.chart]] ? -normal : normal};
    };
}

CoveringPose pose_of(const CoverLayout& layout, const TiledPieces& pieces,
                     const std::vector<Part>& parts)
{
    CoveringPose out;
    const std::vector<char> mirrored = mirrored_parts(pieces, parts);
    for (const std::uint32_t piece : layout.piece_of_chart) out.mirrored.push_back(mirrored[piece]);
    if (layout.limit) {
        const std::vector<RestToWorld> ways = ways_to_world(pieces, parts);
        out.points.resize(layout.rest.size());
        parallel_blocks(out.points.size(), 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n)
                out.points[n] = ways[layout.piece_of_node[n]](layout.rest[n]);
        });
        return out;
    }
    out.points = layout.covering->points(moved_facets(layout, parts));
    for (std::size_t n = 0; n < out.points.size(); ++n)
        if (mirrored[layout.piece_of_node[n]]) out.points[n].normal = -out.points[n].normal;
    return out;
}

} // namespace trivar
