// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/facet_surface.h"
#include "core/mesh/height_sheet.h"
#include "core/mesh/primitives.h"
#include "core/tiles/covered_tiles.h"
#include "tests/limit/cages.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>
#include <numeric>

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

// A mesh with a picture over all of its UVs: the largest distance of a vertex from P + h(u, v) N,
// by the faces of the mesh themselves.
double off_over_uvs(const Mesh& mesh, double height, int per_face)
{
    const Cage cage = cage_of(mesh, glm::dmat4(1));
    const FacetSurface surface(cage);
    std::vector<glm::dvec2> corner_uvs;
    for (const std::uint32_t v : mesh.corners) corner_uvs.emplace_back(mesh.uvs.front()[v]);
    const ChartUvs uvs = chart_uvs(surface.net(), cage, corner_uvs);
    const HeightSheet sheet{.height = height, .level = 0.25, .segments = 6};
    const GreyImage image = hills();
    const Mesh tile = height_sheet(image, sheet);
    const Covering covering(surface, {.pattern = TilePattern::grid, .per_face = per_face}, {1, 1});
    CoveringPose pose;
    pose.points = covering.points(surface);
    pose.heights.assign(pose.points.size(), 1);
    pose.mirrored.assign(surface.net().size(), 0);
    std::vector<std::uint32_t> tiles(covering.tiles().size());
    std::iota(tiles.begin(), tiles.end(), 0u);
    const Mesh all =
        displaced_tiles(tile, glm::dmat4(1), {{-0.5, -0.5, 0}, {1, 1, height}}, covering, pose,
                        tiles, {image, sheet, uvs, surface.net(), [&](const ChartPlace& at) {
                                    return SurfacePoint{surface.position(at), surface.normal(at)};
                                }});
    EXPECT_EQ(all.vertex_count(), tiles.size() * tile.vertex_count());
    double most = 0;
    for (std::size_t k = 0; k < tiles.size(); ++k)
        for (std::size_t v = 0; v < tile.vertex_count(); ++v) {
            const Covering::Spot spot =
                covering.spot(covering.tiles()[k], glm::dvec2(tile.positions[v]) + 0.5);
            const Covering::Cell& cell = covering.cell(spot.cell);
            const glm::dvec2 at = (glm::dvec2(cell.i, cell.j) + spot.uv) / double(per_face);
            const glm::dvec3 p = surface.position({cell.chart, at});
            // The coordinates of the face there: of four corners bilinear, of three by weights.
            const std::uint32_t* corners = &mesh.corners[mesh.face_begin[cell.chart]];
            const auto uv_of = [&](int i) { return glm::dvec2(mesh.uvs.front()[corners[i]]); };
            glm::dvec2 uv(0);
            if (mesh.face_begin[cell.chart + 1] - mesh.face_begin[cell.chart] == 4)
                uv = glm::mix(glm::mix(uv_of(0), uv_of(1), at.x),
                              glm::mix(uv_of(3), uv_of(2), at.x), at.y);
            else {
                const auto p_of = [&](int i) { return glm::dvec3(mesh.positions[corners[i]]); };
                const glm::dvec3 n = glm::cross(p_of(1) - p_of(0), p_of(2) - p_of(0));
                for (int i = 0; i < 3; ++i) {
                    const glm::dvec3 a = p_of((i + 1) % 3) - p, b = p_of((i + 2) % 3) - p;
                    uv += glm::dot(glm::cross(a, b), n) / glm::dot(n, n) * uv_of(i);
                }
            }
            const double h = height * (grey_at(image, uv, ImageEdge::repeat) - 0.25);
            const glm::dvec3 wanted = p + h * surface.normal({cell.chart, at});
            const std::size_t to = k * tile.vertex_count() + v;
            EXPECT_NEAR(glm::length(all.normals[to]), 1, 1e-5);
            const glm::dvec3 normal(all.normals[to]);
            if (height == 0) {
                EXPECT_NEAR(glm::distance(normal, surface.normal({cell.chart, at})), 0, 1e-6);
            }
            most = std::max({most, glm::distance(wanted, glm::dvec3(all.positions[to])),
                             glm::distance(uv, glm::dvec2(all.uvs.front()[to]))});
        }
    return most;
}

TEST(Displacement, IsTheConventionalOneOverUvs)
{
    EXPECT_LT(off_over_uvs(torus_mesh(0.5, 0.2, {96, 48}), 0.05, 1), 1e-6);
    EXPECT_LT(off_over_uvs(torus_mesh(0.5, 0.2, {7, 5}), 0.05, 2), 1e-6); // however coarse
    EXPECT_LT(off_over_uvs(sphere_mesh(0.5, 64, 32), 0.05, 1), 1e-6);     // triangles at its poles
    EXPECT_LT(off_over_uvs(plane_mesh({1, 1}, {3, 2}), 0.05, 4), 1e-6);
}

TEST(Displacement, ByNothingLooksAsTheSurfaceDoes)
{
    EXPECT_LT(off_over_uvs(torus_mesh(0.5, 0.2, {12, 8}), 0, 1), 1e-6);
    EXPECT_LT(off_over_uvs(sphere_mesh(0.5, 12, 6), 0, 1), 1e-6);
}

TEST(Displacement, FindsTheUvsOfFacesThatAreCut)
{
    // A pentagon and a quad: the corners of all charts lie where the flat map has them.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {4, 0, 0}, {4, 1, 0}};
    add_face(mesh, std::array{0u, 1u, 2u, 3u, 4u});
    add_face(mesh, std::array{1u, 5u, 6u, 2u});
    const glm::dmat2 map(0.1, 0.03, -0.02, 0.2);
    std::vector<glm::dvec2> corner_uvs;
    for (const std::uint32_t v : mesh.corners)
        corner_uvs.push_back(map * glm::dvec2(mesh.positions[v]));
    const Cage cage = cage_of(mesh, glm::dmat4(1));
    const FacetSurface facets(cage);
    const ChartUvs on_facets = chart_uvs(facets.net(), cage, corner_uvs);
    ASSERT_EQ(on_facets.size(), 9u);
    for (std::uint32_t c = 0; c < 9; ++c)
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec2 p(facets.position({c, chart_corner(static_cast<int>(k))}));
            EXPECT_NEAR(glm::distance(on_facets[c][k], map * p), 0, 1e-12) << c << " " << k;
        }
    // The same charts of a limit surface, by the point at which the charts of a face meet.
    const LimitSurface limit(cage);
    const ChartUvs on_limit = chart_uvs(limit.net(), cage, corner_uvs);
    for (std::uint32_t c = 0; c < 9; ++c) {
        glm::dvec2 a(0), b(0);
        for (std::size_t k = 0; k < 4; ++k) a += on_facets[c][k], b += on_limit[c][k];
        EXPECT_NEAR(glm::distance(a, b), 0, 1e-12) << c;
        const glm::dvec2 u = on_limit[c][1] - on_limit[c][0], v = on_limit[c][3] - on_limit[c][0];
        EXPECT_GT(u.x * v.y - u.y * v.x, 0);
        EXPECT_NE(on_limit[c][0], on_limit[c][2]);
    }
}

} // namespace
} // namespace trivar
