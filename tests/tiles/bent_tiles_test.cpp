// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/primitives.h"
#include "core/patches/tile_set.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

std::vector<PlacedTile> some_tiles(const TileBase& base, int count)
{
    const BasePose pose = at_rest(base);
    std::mt19937 random(1);
    std::vector<PlacedTile> out;
    for (int k = 0; k < count; ++k) {
        const SurfacePlace at = random_place(base, random);
        const Tile tile{at, random_tangent(base, at, random), 0.3};
        out.push_back({patch_of(base, pose, chart_of(base, tile, 0, 1)), 0.3, -0.01});
    }
    return out;
}

// A model of side 1 that stands on its middle, over tiles.
Mesh bent(const Mesh& stud, std::span<const PlacedTile> tiles,
          const glm::dmat4& to_model = glm::dmat4(1))
{
    return bent_tiles(in_unit_cell(stud, to_model, {{0, 0, -0.5}, 1, 1}), tiles);
}

TEST(BentTiles, LieWhereTheirPatchesSay)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {90, 40}));
    const Mesh stud = cylinder_mesh(0.5, 1, 12, 3);
    const std::vector<PlacedTile> tiles = some_tiles(base, 30);
    const Mesh all = bent(stud, tiles);
    ASSERT_EQ(all.vertex_count(), 30 * stud.vertex_count());
    ASSERT_EQ(all.face_count(), 30 * stud.face_count());
    for (std::size_t k = 0; k < tiles.size(); ++k)
        for (std::size_t v = 0; v < stud.vertex_count(); ++v) {
            const glm::dvec3 q = glm::dvec3(stud.positions[v]) + glm::dvec3(0.5);
            const glm::dvec3 truth = tile_point(tiles[k].patch, {q.x, q.y, 0.3 * q.z - 0.01}).p;
            EXPECT_LT(glm::distance(glm::dvec3(all.positions[k * stud.vertex_count() + v]), truth),
                      1e-6);
        }
    validate(all, "bent");
}

TEST(BentTiles, HaveNormalsOfTheBentSurface)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {90, 40}));
    const Mesh stud = sphere_mesh(0.5, 64, 32); // its own normals are those of its faces, nearly
    const Mesh all = bent(stud, some_tiles(base, 5));
    const std::vector<glm::vec3> faces = smooth_normals(all);
    double least = 1;
    for (std::size_t v = 0; v < all.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(all.normals[v]), 1, 1e-5);
        least = std::min(least, static_cast<double>(glm::dot(all.normals[v], faces[v])));
    }
    EXPECT_GT(least, 0.97);
}

TEST(BentTiles, AreTheSameForAnyNumberOfThreads)
{
    const TileBase base = base_of(sphere_mesh(1, 48, 24));
    const Mesh stud = box_mesh({1, 1, 1}, {3, 3, 3});
    const std::vector<PlacedTile> tiles = some_tiles(base, 100);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return bent(stud, tiles);
    };
    EXPECT_EQ(with(1), with(2));
}

TEST(BentTiles, OfAMirroredModelStillFaceOutward)
{
    const TileBase base = base_of(plane_mesh({4, 4}, {8, 8}));
    const Mesh cube = box_mesh({1, 1, 1}, {1, 1, 1});
    const glm::dmat4 mirror(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const Mesh all = bent(cube, some_tiles(base, 1), mirror);
    for (std::size_t f = 0; f < all.face_count(); ++f)
        EXPECT_GT(
            glm::dot(area_normal(all, f), glm::dvec3(all.normals[all.corners[all.face_begin[f]]])),
            0);
}

} // namespace
} // namespace trivar
