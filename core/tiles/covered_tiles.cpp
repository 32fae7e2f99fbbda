// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/covered_tiles.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/base/unit.h"
#include "core/mesh/mesh_copies.h"
#include "core/patches/pinch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace trivar {
namespace {

// Hexagons are as wide as four thirds of their rows, and reach beyond them on both sides.
constexpr double hexagon_width = 4.0 / 3, hexagon_reach = 1.0 / 6;
// A vertex as near to the side of the cell as this share of it lies on the side.
constexpr double on_side = 1e-5;
constexpr glm::dvec3 zenith{0, 0, 1};

// Onto 0 or 1 where it is there but for rounding.
double onto_side(double t)
{
    if (std::abs(t) < on_side) return 0;
    if (std::abs(t - 1) < on_side) return 1;
    return snapped(t);
}

// The mesh in the cell: x and y fill the unit square, z is in lengths of the tile over the base.
struct InCell {
    std::vector<glm::dvec3> at, normals, tangents;
};

InCell in_cell(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell)
{
    InCell out;
    const glm::dvec3 size = glm::max(cell.size, glm::dvec3(1e-9));
    // To the cell, about its middle; both axes are stretched, and z is in lengths.
    const double length = cell.turns % 2 == 0 ? size.x : size.y;
    const glm::dmat3 to_cell(1 / size.x, 0, 0, 0, 1 / size.y, 0, 0, 0, 1 / length);
    const glm::dmat3 linear = to_cell * glm::dmat3(to_model),
                     cofactor = glm::transpose(glm::inverse(linear));
    const auto turned = [&](const glm::dvec3& v) {
        return glm::dvec3(quarter_turned({v.x, v.y}, cell.turns), v.z);
    };
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::dvec3 p = glm::dvec3(to_model * glm::dvec4(mesh.positions[v], 1));
        const glm::dvec3 share = to_cell * (p - cell.lo);
        const glm::dvec2 about =
            quarter_turned(cell.scale * (glm::dvec2(share) - 0.5), cell.turns) + 0.5;
        const double sunk = share.z - cell.sink * size.z / length;
        const double x = onto_side(about.x), y = onto_side(about.y);
        const bool on_outline = x == 0 || x == 1 || y == 0 || y == 1;
        out.at.emplace_back(x, y, on_outline ? snapped(sunk) : sunk);
    }
    for (const glm::vec3& n : mesh.normals) {
        const glm::dvec3 there = cofactor * glm::dvec3(n);
        out.normals.push_back(turned({there.x / cell.scale, there.y / cell.scale, there.z}));
    }
    for (const glm::vec4& t : mesh.tangents) {
        const glm::dvec3 there = linear * glm::dvec3(t);
        out.tangents.push_back(turned({cell.scale * there.x, cell.scale * there.y, there.z}));
    }
    return out;
}

// The heights at the corners of a cell, and their bilinear mean with its derivatives; the same bits
// for a side that runs the other way.
struct CornerHeights {
    double a, b, c, d; // as the corners are numbered
    glm::dvec3 at(const glm::dvec2& uv) const
    {
        const double s = 1 - uv.x, t = 1 - uv.y;
        const double low = s * a + uv.x * b, high = s * d + uv.x * c;
        return {t * low + uv.y * high, t * (b - a) + uv.y * (c - d), high - low};
    }
};

class CellShape {
public:
    CellShape(const Covering& covering, const CoveringPose& pose, std::uint32_t cell)
        : patch_(covering.patch(cell, pose.points))
    {
        const auto corners = covering.corners(cell);
        heights_ = {pose.heights[corners[0]], pose.heights[corners[1]], pose.heights[corners[2]],
                    pose.heights[corners[3]]};
    }
    double height(const glm::dvec2& uv) const { return heights_.at(uv).x; }
    // With z in lengths of the tile.
    TilePoint at(const glm::dvec2& uv, double z) const
    {
        const glm::dvec3 height = heights_.at(uv);
        TilePoint out = symmetric_tile_point(patch_, {uv.x, uv.y, height.x * z});
        out.x += height.y * z * out.z;
        out.y += height.z * z * out.z;
        out.z *= height.x;
        return out;
    }

private:
    TilePatch patch_;
    CornerHeights heights_{};
};

// A TileOnCells finds the points of one tile on its cells: few, each made once.
class TileOnCells {
public:
    TileOnCells(const Covering& covering, const CoveringPose& pose, std::uint32_t tile)
        : covering_(covering),
          pose_(pose),
          tile_(covering.tiles()[tile]),
          turned_over_(pose.mirrored[covering.cell(tile_.cell).chart] != 0),
          scale_(pose.scales.empty() ? 1 : pose.scales[tile]),
          factor_(pose.factors.empty() ? 1 : pose.factors[tile])
    {
    }
    // x and y fill the unit square; z is in lengths of the tile, before its own factor.
    TilePoint at(const glm::dvec3& p) { return at(spot(p), p.z); }
    TilePoint at(const Covering::Spot& spot, double z)
    {
        const TilePoint t = shape_of(spot.cell).at(spot.uv, factor_ * z);
        const auto [x, y] = own_directions(spot);
        return {t.p, x.x * t.x + x.y * t.y, y.x * t.x + y.y * t.y, factor_ * t.z};
    }
    Covering::Spot spot(glm::dvec2 at) const
    {
        if (scale_ != 1) at = 0.5 + scale_ * (at - 0.5);
        if (turned_over_) at.x = 1 - at.x;
        if (hexagon()) at.y = snapped(hexagon_width * at.y - hexagon_reach);
        return covering_.spot(tile_, at);
    }
    double height(const Covering::Spot& spot) // metres in the world per length
    {
        return factor_ * shape_of(spot.cell).height(spot.uv);
    }
    // Returns the way that a place goes in its cell along the tile's own x and y.
    std::pair<glm::dvec2, glm::dvec2> own_directions(const Covering::Spot& spot) const
    {
        const double along = (turned_over_ ? -1 : 1) * spot.along,
                     across = hexagon() ? hexagon_width : 1;
        return {scale_ * along * quarter_turned({1, 0}, spot.turns),
                scale_ * across * quarter_turned({0, 1}, spot.turns)};
    }
    std::vector<std::uint32_t> cells() const
    {
        std::vector<std::uint32_t> out;
        for (const auto& [cell, shape] : shapes_) out.push_back(cell);
        return out;
    }

private:
    bool hexagon() const { return covering_.pattern() == TilePattern::hexagon; }
    const CellShape& shape_of(std::uint32_t id)
    {
        for (const auto& [known, shape] : shapes_)
            if (known == id) return shape;
        return shapes_.emplace_back(id, CellShape(covering_, pose_, id)).second;
    }

    const Covering& covering_;
    const CoveringPose& pose_;
    const Covering::Laid& tile_;
    bool turned_over_;
    double scale_, factor_;
    std::vector<std::pair<std::uint32_t, CellShape>> shapes_;
};

// Returns a place of the surface, by the same numbers from all cells that have it: corners are
// nodes, and a place on a side that two charts share belongs to the first of them.
SurfacePoint shared_place(const Covering& covering, const CoveringPose& pose,
                          const HeightsOverUvs& heights, const Covering::Spot& spot)
{
    const auto ends = [](double t) { return t == 0 || t == 1; };
    if (ends(spot.uv.x) && ends(spot.uv.y)) {
        const std::size_t corner =
            spot.uv.y == 0 ? (spot.uv.x == 0 ? 0 : 1) : (spot.uv.x == 0 ? 3 : 2);
        return pose.points[covering.corners(spot.cell)[corner]];
    }
    ChartPlace at{covering.cell(spot.cell).chart, covering.in_chart(spot.cell, spot.uv)};
    const int edge = at.uv.y == 0 ? 0 : at.uv.x == 1 ? 1 : at.uv.y == 1 ? 2 : at.uv.x == 0 ? 3 : -1;
    if (edge >= 0 && heights.net.across(at.chart, edge).chart < at.chart)
        at = heights.net.beyond(at, edge);
    return heights.surface(at);
}

// The normal where heights have that slope along the tile's x and y over what is shaded by `up`,
// as long as heights are: where they are even it is that one.
glm::vec3 displaced_normal(const TilePoint& at, const glm::dvec2& slope, const glm::dvec3& up)
{
    const double length = glm::length(up);
    if (!(length > 0)) return glm::vec3(unit_or(glm::cross(at.x, at.y), zenith));
    const glm::dvec3 n = up / length;
    const auto flat = [&](const glm::dvec3& v) { return v - glm::dot(v, n) * n; };
    const glm::dvec3 x = flat(at.x), y = flat(at.y), around = glm::cross(x, y);
    const double longest = std::max(glm::dot(x, x), glm::dot(y, y));
    if (!(glm::length(around) > 1e-6 * longest)) return glm::vec3(n); // a pole
    return glm::vec3(unit_or(glm::cross(x + slope.x * up, y + slope.y * up), zenith));
}

} // namespace

Mesh covered_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                   const Covering& covering, const CoveringPose& pose)
{
    std::vector<std::uint32_t> all(covering.tiles().size());
    std::iota(all.begin(), all.end(), 0u);
    return covered_tiles(mesh, to_model, cell, covering, pose, all);
}

Mesh covered_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                   const Covering& covering, const CoveringPose& pose,
                   std::span<const std::uint32_t> tiles)
{
    const bool mirrored = glm::determinant(glm::dmat3(to_model)) < 0;
    const std::size_t count = mesh.vertex_count();
    Mesh out = copies_of(mesh, tiles.size(), mirrored);
    const InCell from = in_cell(mesh, to_model, cell);
    parallel_blocks(tiles.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            TileOnCells tile(covering, pose, tiles[k]);
            for (std::size_t v = 0; v < count; ++v) {
                auto [p, x, y, z] = tile.at(from.at[v]);
                if (is_pinched(x, y)) {
                    const glm::dvec2 to_middle = 0.5 - glm::dvec2(from.at[v]);
                    const TilePoint inside =
                        tile.at(from.at[v] + glm::dvec3(double(pinch_inside) * to_middle, 0));
                    x = inside.x, y = inside.y, z = inside.z;
                }
                const std::size_t to = k * count + v;
                out.positions[to] = glm::vec3(p) + 0.0f; // no negative zeros
                if (!out.normals.empty()) {
                    const glm::dvec3& n = from.normals[v];
                    out.normals[to] = glm::vec3(unit_or(
                        n.x * glm::cross(y, z) + n.y * glm::cross(z, x) + n.z * glm::cross(x, y),
                        zenith));
                }
                if (!out.tangents.empty()) {
                    const glm::dvec3& a = from.tangents[v];
                    out.tangents[to] =
                        glm::vec4(glm::vec3(unit_or(a.x * x + a.y * y + a.z * z, zenith)),
                                  mesh.tangents[v].w * (mirrored ? -1.0f : 1.0f));
                }
            }
        }
    });
    return out;
}

Mesh displaced_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                     const Covering& covering, const CoveringPose& pose,
                     std::span<const std::uint32_t> tiles, const HeightsOverUvs& heights)
{
    const std::size_t count = mesh.vertex_count();
    Mesh flat = mesh;
    for (glm::vec3& p : flat.positions) p.z = 0;
    flat.tangents.clear();
    if (flat.uvs.empty()) flat.uvs.resize(1);
    flat.uvs.resize(1);
    flat.uvs.front().resize(count);
    Mesh out = copies_of(flat, tiles.size(), glm::determinant(glm::dmat3(to_model)) < 0);
    const InCell from = in_cell(flat, to_model, cell);
    const double length = std::max(cell.turns % 2 == 0 ? cell.size.x : cell.size.y, 1e-9),
                 per_metre = to_model[2].z / length, step = 1.0 / heights.sheet.segments;
    parallel_blocks(tiles.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            TileOnCells tile(covering, pose, tiles[k]);
            for (std::size_t v = 0; v < count; ++v) {
                const Covering::Spot spot = tile.spot(from.at[v]);
                const auto& uvs = heights.uvs[covering.cell(spot.cell).chart];
                const auto uv_at = [&](const glm::dvec2& in_cell) {
                    return uv_in_chart(uvs, covering.in_chart(spot.cell, in_cell));
                };
                const auto height = [&](double du, double dv) {
                    return per_metre *
                           heights.sheet.at(heights.image, uv_at(spot.uv + glm::dvec2(du, dv)));
                };
                const glm::dvec2 slope = glm::dvec2(height(step, 0) - height(-step, 0),
                                                    height(0, step) - height(0, -step)) /
                                         (2 * step);
                const double high = from.at[v].z + height(0, 0);
                const TilePoint t = tile.at(spot, high);
                const SurfacePoint foot = shared_place(covering, pose, heights, spot);
                const glm::dvec3 p = foot.p + tile.height(spot) * high * foot.normal;
                const auto [along, across] = tile.own_directions(spot);
                const std::size_t to = k * count + v;
                out.positions[to] = glm::vec3(p) + 0.0f; // no negative zeros
                out.uvs.front()[to] = glm::vec2(uv_at(spot.uv));
                if (!out.normals.empty())
                    out.normals[to] =
                        displaced_normal(t, {glm::dot(slope, along), glm::dot(slope, across)},
                                         tile.height(spot) * foot.normal);
            }
        }
    });
    return out;
}

glm::dmat4 to_unit_cell(const CoverCell& cell)
{
    const glm::dvec3 size = glm::max(cell.size, glm::dvec3(1e-9));
    const glm::dvec3 factor(1 / size.x, 1 / size.y, 1 / size.x);
    glm::dmat4 out(1);
    for (int k = 0; k < 3; ++k) {
        out[k][k] = factor[k];
        out[3][k] = -factor[k] * cell.lo[k];
    }
    return out;
}

PatchedTile patched_tile(const CoverCell& cell, const Covering& covering, const CoveringPose& pose,
                         std::uint32_t tile)
{
    ensure(cell.turns == 0, "a turned cell is no patch");
    TileOnCells on_cells(covering, pose, tile);
    const auto at = [&](double x, double y) {
        return on_cells.at({0.5 + cell.scale * (x - 0.5), 0.5 + cell.scale * (y - 0.5), 0});
    };
    const double top = cell.size.z / std::max(cell.size.x, 1e-9), sunk = cell.sink * top;
    PatchedTile out{{{}, 1, -sunk}};
    TilePatch& patch = out.tile.patch;
    for (std::size_t k = 0; k < 16; ++k) {
        const TilePoint t = at(patch_nodes[k % 4], patch_nodes[k / 4]);
        patch.p[k] = t.p;
        patch.n[k] = t.z;
    }
    patch.p = through_nodes(patch.p);
    patch.n = through_nodes(patch.n);
    const double high = std::max(std::abs(top - sunk), std::abs(sunk)),
                 length = glm::distance(at(0, 0.5).p, at(1, 0.5).p);
    for (const double y : {0.1, 0.5, 0.9})
        for (const double x : {0.1, 0.5, 0.9}) {
            const TilePoint is = tile_point(patch, {x, y, 0}), wanted = at(x, y);
            const double off = glm::distance(is.p, wanted.p) + high * glm::distance(is.z, wanted.z);
            out.off = std::max(out.off, std::isfinite(off) && length > 0
                                            ? off / length
                                            : std::numeric_limits<double>::infinity());
        }
    out.cells = on_cells.cells();
    return out;
}

TilePatch upright_patch(const Covering& covering, std::uint32_t cell, const CoveringPose& pose)
{
    TilePatch patch = covering.patch(cell, pose.points);
    if (pose.mirrored[covering.cell(cell).chart] != 0)
        for (std::size_t j = 0; j < 16; j += 4)
            for (auto* net : {&patch.p, &patch.n}) {
                std::swap((*net)[j], (*net)[j + 3]);
                std::swap((*net)[j + 1], (*net)[j + 2]);
            }
    return patch;
}

} // namespace trivar
