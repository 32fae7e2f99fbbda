// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/tangent.h"
#include "core/mesh/primitives.h"
#include "tests/limit/cages.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

constexpr glm::dvec3 axis_z{0, 0, 1};

TileStroke front_stroke(const TileBase& base, TileHeading heading)
{
    TileStroke stroke = stroke_over(base, {-0.4, -3, 0.1}, {0.4, -3, -0.1}, {0, 1, 0}, 20);
    stroke.heading = heading;
    stroke.radius = 0.3;
    stroke.size = 0.1;
    return stroke;
}

std::vector<Tile> laid(const TileBase& base, const TileStroke& stroke,
                       const Lazy<TileCurvature>* curvature = nullptr)
{
    return layout_of(base, {make_ref(TileStroke(stroke))}, {}, curvature).tiles.all();
}

TEST(TileHeadings, AlongTheLeastCurvatureIsTheAxisOfACylinderAndAcrossItTheMost)
{
    const TileBase base = base_of(cylinder_mesh(1, 4, 64, 32));
    for (const TileHeading heading : {TileHeading::least_curvature, TileHeading::most_curvature}) {
        const std::vector<Tile> tiles = laid(base, front_stroke(base, heading));
        ASSERT_GT(tiles.size(), 10u);
        for (const Tile& tile : tiles) {
            const double along = std::abs(tile.x.z);
            if (heading == TileHeading::least_curvature) {
                EXPECT_GT(along, 0.999);
            } else {
                EXPECT_LT(along, 0.04);
            }
        }
    }
}

TEST(TileHeadings, GoOnAlongTheStrokeWhereTheSurfaceBendsAlikeInAllDirections)
{
    for (const Mesh& mesh : {sphere_mesh(1, 64, 32), box_mesh({2, 2, 2}, {4, 4, 4})}) {
        const TileBase base = base_of(mesh);
        for (const Tile& tile : laid(base, front_stroke(base, TileHeading::least_curvature)))
            if (std::abs(base.position(tile.at).z) < 0.5) {
                EXPECT_GT(tile.x.x, 0.6);
            }
    }
}

TEST(TileHeadings, FollowTheCurvatureOfALimitSurfaceExactly)
{
    const std::vector<LimitBase::Piece> pieces{{make_ref(torus_cage()), glm::dmat4(1)}};
    const auto limit = std::make_shared<const LimitBase>(pieces);
    const TileBase& base = limit->triangles();
    const TileCurvature exact{Ref<LimitBase>(limit)};
    std::mt19937 random(3);
    for (int k = 0; k < 200; ++k) {
        const SurfacePlace at = random_place(base, random);
        const glm::dvec3 d = exact.least(base, at);
        if (d == glm::dvec3(0)) continue;
        EXPECT_NEAR(glm::length(d), 1, 1e-9);
        EXPECT_NEAR(glm::dot(d, base.normal(at)), 0, 1e-9);
        // Normal curvatures along it and across, by how normals turn over a short step.
        const ChartPlace place = limit->place(at);
        const SurfaceFrame frame = frame_of(limit->surface().jet(place));
        const glm::dvec3 here = turned_from_to(base.normal(at), frame.normal, d);
        const LimitJet jet = limit->surface().jet(place);
        const glm::dvec2 uv = in_chart(jet, here);
        const double bend = std::abs(glm::dot(uv.x * frame.normal_u + uv.y * frame.normal_v, here));
        EXPECT_NEAR(bend, std::min(std::abs(frame.k1), std::abs(frame.k2)),
                    1e-6 * std::max(std::abs(frame.k1), std::abs(frame.k2)));
    }
}

TEST(TileHeadings, ToAPointThatTheStrokeKeeps)
{
    const TileBase base = base_of(plane_mesh({4, 4}, {5, 5}));
    TileStroke stroke = stroke_over(base, {-1, 0.3, 1}, {1, 0.3, 1}, {0, 0, -1}, 20);
    stroke.heading = TileHeading::to_point;
    stroke.point = {0.2, -1, 0.7}; // as high as it likes
    stroke.size = 0.1;
    stroke.radius = 0.3;
    for (const Tile& tile : laid(base, stroke)) {
        const glm::dvec3 way = stroke.point - base.position(tile.at);
        EXPECT_GT(glm::dot(tile.x, glm::normalize(glm::dvec3(way.x, way.y, 0))), 1 - 1e-9);
    }
}

TEST(TileMirrors, LayEveryTileOnBothSidesWithItsHeadingMirrored)
{
    const TileBase base = base_of(sphere_mesh(1, 64, 32));
    for (const TileBrush brush : {TileBrush::scatter, TileBrush::line, TileBrush::fill}) {
        TileStroke stroke = stroke_over(base, {-0.6, -3, 0.3}, {-0.05, -3, -0.2}, {0, 1, 0}, 20);
        stroke.brush = brush;
        stroke.size = 0.12;
        stroke.radius = 0.25;
        stroke.turn_variation_deg = 40;
        stroke.mirror = TileMirror::x;
        const std::vector<Tile> tiles = laid(base, stroke);
        ASSERT_GT(tiles.size(), 6u);
        std::size_t on_plane = 0;
        for (const Tile& tile : tiles) {
            const glm::dvec3 p = base.position(tile.at);
            const glm::dvec3 image(-p.x, p.y, p.z), x(-tile.x.x, tile.x.y, tile.x.z);
            on_plane += std::abs(p.x) < 1e-6;
            const bool found = std::ranges::any_of(tiles, [&](const Tile& other) {
                return glm::distance(base.position(other.at), image) < 1e-4 &&
                       std::abs(std::abs(glm::dot(other.x, x)) - 1) < 1e-3 &&
                       other.seed == tile.seed && other.size == tile.size;
            });
            EXPECT_TRUE(found) << p.x << " " << p.y << " " << p.z;
        }
        EXPECT_LT(on_plane, tiles.size() / 2);
    }
}

TEST(TileMirrors, ChangeBothSides)
{
    const TileBase base = base_of(sphere_mesh(1, 64, 32));
    TileStroke fill = stroke_over(base, {0.3, -3, 0}, {0.3, -3, 0}, {0, 1, 0}, 1);
    fill.brush = TileBrush::fill;
    fill.size = 0.2;
    TileStroke erase = stroke_over(base, {0.5, -3, 0.2}, {0.5, -3, -0.2}, {0, 1, 0}, 9);
    erase.brush = TileBrush::erase;
    erase.radius = 0.2;
    erase.mirror = TileMirror::x;
    const auto near = [&](const std::vector<Tile>& tiles, double x) {
        return std::ranges::count_if(tiles, [&](const Tile& tile) {
            const glm::dvec3 p = base.position(tile.at);
            return p.y < 0 && std::abs(p.x - x) < 0.19 && std::abs(p.z) < 0.2;
        });
    };
    const std::vector<Tile> all = laid(base, fill),
                            rest = layout_of(base, {make_ref(TileStroke(fill)),
                                                    make_ref(TileStroke(erase))})
                                       .tiles.all();
    for (const double x : {-0.5, 0.5}) {
        EXPECT_GT(near(all, x), 2);
        EXPECT_EQ(near(rest, x), 0);
    }
}

} // namespace
} // namespace trivar::testing
