// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/covered_tiles.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh_copies.h"
#include "core/tiles/fold_limit.h"

#include <algorithm>

namespace trivar {
namespace {

// Hexagons are as wide as four thirds of their rows, and reach beyond them on both sides.
constexpr double hexagon_width = 4.0 / 3, hexagon_reach = 1.0 / 6;
// A vertex as near to the side of the cell as this share of it lies on the side.
constexpr double on_side = 1e-5;

glm::vec3 unit_or_zenith(const glm::dvec3& n)
{
    const double length = glm::length(n);
    return length > 0 ? glm::vec3(n / length) : glm::vec3(0, 0, 1);
}

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

} // namespace

Mesh covered_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                   const Covering& covering, const CoveringPose& pose)
{
    const bool mirrored = glm::determinant(glm::dmat3(to_model)) < 0;
    const auto& tiles = covering.tiles();
    const std::size_t count = mesh.vertex_count();
    Mesh out = copies_of(mesh, tiles.size(), mirrored);
    const InCell from = in_cell(mesh, to_model, cell);
    const bool hexagon = covering.pattern() == TilePattern::hexagon;
    parallel_blocks(tiles.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Covering::Laid& tile = tiles[k];
            // Cells that the tile lies on: few, each made once.
            std::vector<std::pair<std::uint32_t, CellShape>> shapes;
            const auto shape_of = [&](std::uint32_t id) -> const CellShape& {
                for (const auto& [known, shape] : shapes)
                    if (known == id) return shape;
                return shapes.emplace_back(id, CellShape(covering, pose, id)).second;
            };
            const bool turned_over = pose.mirrored[covering.cell(tile.cell).chart] != 0;
            const double factor = pose.factors.empty() ? 1 : pose.factors[k];
            for (std::size_t v = 0; v < count; ++v) {
                glm::dvec2 at(from.at[v]);
                if (turned_over) at.x = 1 - at.x;
                if (hexagon) at.y = snapped(hexagon_width * at.y - hexagon_reach);
                const Covering::Spot spot = covering.spot(tile, at);
                const TilePoint t = shape_of(spot.cell).at(spot.uv, factor * from.at[v].z);
                const std::size_t to = k * count + v;
                out.positions[to] = glm::vec3(t.p) + 0.0f; // no negative zeros
                // The derivatives along the tile's own directions.
                const glm::dvec2 ex = quarter_turned({1, 0}, spot.turns),
                                 ey = quarter_turned({0, 1}, spot.turns);
                const double along = (turned_over ? -1 : 1) * spot.along,
                             across = hexagon ? hexagon_width : 1;
                const glm::dvec3 x = along * (ex.x * t.x + ex.y * t.y),
                                 y = across * (ey.x * t.x + ey.y * t.y), z = factor * t.z;
                if (!out.normals.empty()) {
                    const glm::dvec3& n = from.normals[v];
                    out.normals[to] = unit_or_zenith(
                        n.x * glm::cross(y, z) + n.y * glm::cross(z, x) + n.z * glm::cross(x, y));
                }
                if (!out.tangents.empty()) {
                    const glm::dvec3& a = from.tangents[v];
                    out.tangents[to] = glm::vec4(unit_or_zenith(a.x * x + a.y * y + a.z * z),
                                                 mesh.tangents[v].w * (mirrored ? -1.0f : 1.0f));
                }
            }
        }
    });
    return out;
}

double fold_limit_of(const Covering& covering, std::uint32_t cell, const CoveringPose& pose)
{
    TilePatch patch = covering.patch(cell, pose.points);
    if (pose.mirrored[covering.cell(cell).chart] != 0)
        for (std::size_t j = 0; j < 16; j += 4)
            for (auto* net : {&patch.p, &patch.n}) {
                std::swap((*net)[j], (*net)[j + 3]);
                std::swap((*net)[j + 1], (*net)[j + 2]);
            }
    return fold_limit(patch);
}

} // namespace trivar
