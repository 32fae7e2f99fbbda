// SPDX-License-Identifier: GPL-3.0-or-later
// The error is never more than is asked for or said, by samples of both meshes.
#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

double both_ways(const Mesh& a, const Mesh& b)
{
    return std::max(sampled_distance(a, b, 1), sampled_distance(b, a, 10));
}

Mesh noisy_sheet(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> noise(-0.05f, 0.05f);
    Mesh mesh = plane_mesh({2, 2}, {16, 16});
    for (glm::vec3& p : mesh.positions) p += glm::vec3(noise(random), noise(random), noise(random));
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

} // namespace

TEST(SimplifyError, IsNotMoreThanWasAskedFor)
{
    for (const Mesh& mesh :
         {bumpy_torus({32, 16}), sphere_mesh(1, 24, 16), noisy_sheet(1), noisy_sheet(2)})
        for (const double error : {0.1, 0.02, 0.004}) {
            const SimplifiedMesh less = to_error(mesh, error);
            EXPECT_LE(both_ways(mesh, *less.mesh), error);
            EXPECT_TRUE(less.error == error || less.mesh->face_count() == mesh.face_count());
        }
}

TEST(SimplifyError, MakesFewerTrianglesOfAGreaterError)
{
    const Mesh torus = bumpy_torus({80, 40});
    std::size_t before = 6400;
    for (const double error : {0.01, 0.03, 0.1}) {
        const std::size_t now = to_error(torus, error).triangles;
        EXPECT_LT(now, before * 3 / 4);
        before = now;
    }
}

TEST(SimplifyError, OfANumberOfTrianglesIsProvenWhereItIsWanted)
{
    const Mesh torus = bumpy_torus({40, 20});
    const auto at = [&](std::size_t n, bool measured) {
        return simplified(make_ref(torus),
                          {.triangles = n, .error = {}, .poses = {}, .measured = measured});
    };
    for (const std::size_t n : {1000, 300}) {
        const SimplifiedMesh less = at(n, true);
        const double sampled = both_ways(torus, *less.mesh);
        EXPECT_LE(sampled, less.error);
        EXPECT_LE(less.error, 1.6 * sampled); // samples miss the worst place by little
        EXPECT_TRUE(std::isinf(at(n, false).error));
    }
}

TEST(SimplifyError, StopsAtTheNumberWhereThatComesFirst)
{
    const Ref<Mesh> torus = make_ref(bumpy_torus({48, 24}));
    const auto both = [&](std::size_t n, double error) {
        return simplified(torus, {.triangles = n, .error = error, .poses = {}}).triangles;
    };
    EXPECT_EQ(both(1000, 1), 1000u);
    EXPECT_EQ(both(10, 0.01), both(0, 0.01));
    EXPECT_GT(both(10, 0.01), 100u);
}

TEST(SimplifyError, BelowSinglePrecisionMovesNothingOutOfItsPlane)
{
    Mesh sheet = plane_mesh({2, 2}, {10, 10});
    for (glm::vec3& p : sheet.positions) p = glm::vec3(p.x, 0.6f * p.y, 0.8f * p.y); // tilted
    const SimplifiedMesh less = to_error(sheet, 0);
    EXPECT_EQ(less.triangles, 2u);
    EXPECT_LE(both_ways(sheet, *less.mesh), less.error);
    EXPECT_LT(less.error, 1e-6);
}

} // namespace trivar::testing
