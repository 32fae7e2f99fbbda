// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/facet_surface.h"
#include "core/mesh/height_sheet.h"
#include "core/mesh/primitives.h"
#include "core/tiles/covered_tiles.h"
#include "tests/limit/cages.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// Hills that fit where the picture is repeated.
GreyImage hills()
{
    constexpr int n = 64;
    GreyImage image{{n, n}, {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const double u = (i + 0.5) / n, v = 1 - (j + 0.5) / n, turn = glm::two_pi<double>();
            image.values.push_back(
                static_cast<float>(0.5 + 0.3 * std::sin(turn * u) * std::cos(2 * turn * v) +
                                   0.2 * std::cos(turn * (u + v))));
        }
    return image;
}

// The largest distance of a vertex of a surface that is covered by heights, one sheet for each
// chart, from P + h N: P and the unit normal N of the surface evaluated there, h the picture's.
double off_conventional(const ChartSurface& surface, double height)
{
    const HeightSheet sheet{.height = height, .segments = 12};
    const GreyImage image = hills();
    const Mesh tile = height_sheet(image, sheet);
    const Covering covering(surface, {.pattern = TilePattern::grid, .per_face = 1}, {1, 1});
    CoveringPose pose;
    pose.points = covering.points(surface);
    pose.heights.assign(pose.points.size(), 1); // of one metre of the sheet
    pose.mirrored.assign(surface.net().size(), 0);
    const CoverCell cell{{-0.5, -0.5, 0}, {1, 1, height}};
    const Mesh all = covered_tiles(tile, glm::dmat4(1), cell, covering, pose);
    double most = 0;
    for (std::size_t k = 0; k < covering.tiles().size(); ++k)
        for (std::size_t v = 0; v < tile.vertex_count(); ++v) {
            const glm::dvec2 at = glm::dvec2(tile.positions[v]) + 0.5;
            const Covering::Spot spot = covering.spot(covering.tiles()[k], at);
            const ChartPlace place{covering.cell(spot.cell).chart, spot.uv};
            const double h = height * grey_at(image, at, sheet.edge);
            const glm::dvec3 wanted = surface.position(place) + h * surface.normal(place);
            most = std::max(
                most,
                glm::distance(wanted, glm::dvec3(all.positions[k * tile.vertex_count() + v])));
        }
    return most;
}

TEST(Displacement, IsTheConventionalOneOnAPlane)
{
    const FacetSurface plane(cage_of(plane_mesh({4, 3}, {4, 3}), glm::dmat4(1)));
    EXPECT_LT(off_conventional(plane, 0.2), 1e-6);
}

TEST(Displacement, IsTheConventionalOneOnTheFacesOfATorus)
{
    const FacetSurface torus(cage_of(torus_mesh(0.5, 0.2, {96, 48}), glm::dmat4(1)));
    EXPECT_LT(off_conventional(torus, 0.05), 1e-6);
}

TEST(Displacement, IsTheConventionalOneOnTheFacesOfASphere)
{
    const FacetSurface sphere(cage_of(sphere_mesh(0.5, 64, 32), glm::dmat4(1)));
    EXPECT_LT(off_conventional(sphere, 0.05), 1e-6);
}

TEST(Displacement, IsTheConventionalOneOnALimitSurface)
{
    const LimitSurface torus = limit_of(torus_mesh(0.5, 0.2, {96, 48}));
    EXPECT_LT(off_conventional(torus, 0.05), 1e-6);
}

} // namespace
} // namespace trivar
