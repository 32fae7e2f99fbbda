// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_set.h"

#include "core/mesh/later_mesh.h"
#include "core/mesh/primitives.h"
#include "tests/patches/patches.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

constexpr TileCell unit_box_cell{{0, 0, -0.5}, 1, 1};

// Returns units that reach beyond the unit square, as a posed model may, and some that do not fill
// it.
std::vector<Mesh> some_units()
{
    std::vector<Mesh> out;
    for (const glm::dvec3 size :
         {glm::dvec3(1), glm::dvec3(0.3, 0.9, 2), glm::dvec3(1.4, 1.2, 0.5)})
        out.push_back(in_unit_cell(
            transformed(sphere_mesh(0.5, 20, 10),
                        glm::dmat4(glm::dmat3(size.x, 0, 0, 0, size.y, 0, 0, 0, size.z))),
            glm::dmat4(1), unit_box_cell));
    return out;
}

TEST(TileSets, HaveBoxesOfTheirHullsThatHoldEveryVertex)
{
    for (const Mesh& unit : some_units()) {
        const Box box = bounding_box(unit);
        for (const PlacedTile& tile : random_tiles(50)) {
            const Box hull = hull_box(tile, box),
                      exact = bounding_box(bent_tiles(unit, {&tile, 1}));
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(hull.lo[axis], exact.lo[axis]);
                EXPECT_GE(hull.hi[axis], exact.hi[axis]);
            }
            EXPECT_LT(glm::length(hull.size()), 3 * glm::length(exact.size()));
        }
    }
}

TEST(TileSets, AreFramedByAsMuchAsIfAllWereBent)
{
    for (const Mesh& unit : some_units()) {
        const std::vector<PlacedTile> tiles = random_tiles(200);
        const Ref<TileModel> model = tile_model(unit);
        const Box box = tile_set(model, make_ref(PlacedTiles(tiles)))->box,
                  truth = bounding_box(bent_tiles(unit, tiles));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(box.lo[axis], truth.lo[axis], 1e-6);
            EXPECT_NEAR(box.hi[axis], truth.hi[axis], 1e-6);
        }
        Box outer;
        for (const glm::dvec3& p : outer_points(*model, PlacedTiles(tiles))) outer.add(p);
        EXPECT_LT(glm::length(outer.size() - truth.size()), 0.02 * glm::length(truth.size()));
    }
}

TEST(TileSets, StretchNoEdgeMoreThanTheirBoundSays)
{
    for (const Mesh& unit : some_units()) {
        const Box box = bounding_box(unit);
        for (const PlacedTile& tile : random_tiles(30)) {
            const Mesh bent = bent_tiles(unit, {&tile, 1});
            const double bound = stretch_bound(tile, box);
            double most = 0;
            for (std::size_t c = 0; c + 1 < unit.corners.size(); ++c) {
                const std::uint32_t a = unit.corners[c], b = unit.corners[c + 1];
                const double before = glm::distance(unit.positions[a], unit.positions[b]);
                if (before > 0)
                    most = std::max(most,
                                    glm::distance(bent.positions[a], bent.positions[b]) / before);
            }
            EXPECT_LE(most, bound * (1 + 1e-5));
            EXPECT_LT(bound, 8 * most);
        }
    }
}

TEST(TileSets, AreBentOnlyWhenSomebodyAsks)
{
    const Ref<TileModel> model = tile_model(some_units().front());
    const Ref<TileSet> set = tile_set(model, make_ref(PlacedTiles(random_tiles(10))));
    const LaterMesh mesh(set->mesh), same(set->mesh);
    EXPECT_EQ(set->vertex_count(), 10 * model->mesh->vertex_count());
    EXPECT_EQ(mesh, same);
    EXPECT_FALSE(mesh == LaterMesh(model->mesh));
    EXPECT_FALSE(mesh.ready());
    EXPECT_EQ(mesh->vertex_count(), set->vertex_count());
    EXPECT_EQ(mesh->face_count(), set->face_count());
    EXPECT_TRUE(mesh.ready());
    EXPECT_TRUE(same.ready());
    EXPECT_EQ(mesh, LaterMesh(*set->mesh));
}

TEST(TileSets, HaveLevelsWithFewerTrianglesAndKnownErrors)
{
    const Ref<TileModel> model = tile_model(
        in_unit_cell(torus_mesh(0.35, 0.15, {48, 24}), glm::dmat4(1), {{0, 0, -0.15}, 1, 0.3}));
    const std::vector<TileLevel>& levels = *model->levels;
    ASSERT_GE(levels.size(), 5u);
    EXPECT_EQ(levels.front().mesh, model->mesh);
    EXPECT_EQ(levels.front().error, 0);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        EXPECT_LT(levels[i].mesh->vertex_count(), levels[i - 1].mesh->vertex_count());
        EXPECT_GE(levels[i].error, levels[i - 1].error);
        EXPECT_LT(levels[i].error, 0.5);
    }
    EXPECT_LT(levels[2].error, 0.03);
    const Ref<TileModel> cube = tile_model(box_mesh({1, 1, 1}, {1, 1, 1}));
    EXPECT_EQ(cube->levels->size(), 1u);
}

} // namespace
} // namespace trivar
