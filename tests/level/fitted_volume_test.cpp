// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/fitted_volume.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/lines/mesh_shape.h"
#include "core/voxels/coarsened.h"
#include "core/voxels/read_volume.h"
#include "tests/support/fixtures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr int n = 32;
constexpr double radius = 10;
const glm::dvec3 middle(15.5);

// Bone in air: 1000 in a ball, 0 around it, and between them a ramp of a width or a step.
VoxelField ball(double ramp = 1e-9)
{
    VoxelGrid grid;
    grid.size = glm::ivec3(n);
    std::vector<float> samples;
    for (int i = 0; i < n * n * n; ++i)
        samples.push_back(static_cast<float>(
            500 +
            500 * std::clamp(
                      (radius - glm::distance(glm::dvec3(i % n, i / n % n, i / (n * n)), middle)) *
                          2 / ramp,
                      -1.0, 1.0)));
    grid.samples = std::move(samples);
    return {make_ref(std::move(grid)), {}};
}

constexpr TetrahedraFit usual{.coefficients = 900, .boundary = 500};

TEST(FittedVolume, IsSharpAtTheBoundaryAndFlatBesideIt)
{
    const FittedVolume fitted = fitted_volume(ball(), usual);
    EXPECT_LE(fitted.coefficients, 900U);
    EXPECT_GT(fitted.coefficients, 500U);
    EXPECT_LT(fitted.rms, 15);
    for (int i = 0; i < n * n * n; ++i) {
        const glm::dvec3 at(i % n, i / n % n, i / (n * n));
        const double off = glm::distance(at, middle) - radius;
        if (std::abs(off) < 1.2) continue; // where faces are flat and samples are steps
        EXPECT_NEAR(evaluate(fitted.field, at).value, off < 0 ? 1000 : 0, 60) << i;
    }
}

TEST(FittedVolume, HasASurfaceAlongTheBoundaryWithTheOutlineOfIt)
{
    const VoxelField field = ball();
    const Mesh mesh = fitted_surface(fitted_volume(field, usual), field.grid(), 500,
                                     LevelSide::above, glm::dmat4(1));
    ASSERT_GT(mesh.face_count(), 1000U);
    for (const glm::vec3& p : mesh.positions)
        EXPECT_NEAR(glm::distance(glm::dvec3(p), middle), radius, 1.2);
    const MeshShape shape = mesh_shape(mesh, 60);
    EXPECT_TRUE(shape.closed);
    EXPECT_EQ(shape.edges.size(), 0U);
    const Silhouettes seen = outlines(shape.surface, {{0, 0, 1, 0}});
    double length = 0;
    for (std::size_t c = 0; c < seen.count(); ++c)
        for (std::uint32_t i = seen.first[c]; i < seen.first[c + 1]; ++i) {
            EXPECT_NEAR(glm::length(glm::dvec2(glm::vec2(seen.points[i].p)) - glm::dvec2(middle)),
                        radius, 1.2);
            if (i > seen.first[c])
                length +=
                    static_cast<double>(glm::distance(seen.points[i].p, seen.points[i - 1].p));
        }
    EXPECT_NEAR(length, 2 * 3.14159 * radius, 8);
}

// A ball is as its curved faces are, nearer than its flat ones.
TEST(FittedVolume, IsRoundWhereItsFacesAreFlat)
{
    const VoxelField field = ball(2);
    const Mesh mesh = fitted_surface(fitted_volume(field, usual), field.grid(), 500,
                                     LevelSide::above, glm::dmat4(1));
    double least = radius, greatest = 0;
    for (const glm::vec3& p : mesh.positions) {
        const double r = glm::distance(glm::dvec3(p), middle);
        least = std::min(least, r);
        greatest = std::max(greatest, r);
    }
    EXPECT_GT(least, radius - 0.35);
    EXPECT_LT(greatest, radius + 0.35);
}

TEST(FittedVolume, HasTheSameBitsForAnyNumberOfThreads)
{
    const VoxelField field = ball();
    const ThreadLimit one(1);
    const FittedVolume alone = fitted_volume(field, usual);
    const ThreadLimit more(7);
    const FittedVolume again = fitted_volume(field, usual);
    EXPECT_EQ(again.field.values, alone.field.values);
    EXPECT_EQ(again.inside, alone.inside);
}

TEST(FittedVolume, RefusesWhatCannotBeFitted)
{
    const VoxelField field = ball();
    EXPECT_THROW(fitted_volume(field, {.coefficients = 900, .boundary = 5000}), Rejected);
    EXPECT_THROW(fitted_volume(field, {.coefficients = 20, .boundary = 500}), Rejected);
    EXPECT_THROW(fitted_volume(field, {.coefficients = 900, .degree = 4, .boundary = 500}),
                 Rejected);
}

// A CT of a tooth, of half the samples along each axis.
TEST(RealDataFits, FollowATooth)
{
    if (testing::real_data_folder().empty()) GTEST_SKIP() << "no folder of real data";
    const VoxelGrid tooth = coarsened(
        read_volume(testing::real_data_folder() + "/volumes/tooth.nrrd").grid, glm::ivec3(2));
    const VoxelField field(make_ref(tooth), {});
    const FittedVolume fitted =
        fitted_volume(field, {.coefficients = 3000, .degree = 1, .boundary = 110});
    EXPECT_LT(fitted.rms, 20);
    EXPECT_LT(fitted.left_out, tooth.count() / 50);
    const Mesh mesh = fitted_surface(fitted, tooth, 110, LevelSide::above, glm::dmat4(1));
    EXPECT_TRUE(mesh_shape(mesh, 180).closed);
}

} // namespace
} // namespace trivar
