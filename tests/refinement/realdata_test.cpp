// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "tests/mesh/edges.h"
#include "tests/refinement/bent.h"
#include "tests/refinement/truth.h"
#include "tests/support/fixtures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

class RealDataRefinement : public ::testing::TestWithParam<const char*> {};

// The box of the model is [0, 1]^3 of a volume that bends and ripples.
TEST_P(RealDataRefinement, IsCertifiedAndNoSampleIsFurtherOff)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Model model = read_model(real_data_folder() + "/meshes/" + GetParam());
    const Ref<Mesh> mesh = model.meshes.front();
    const Box box = bounding_box(*mesh);
    const double size = glm::length(box.size());
    Embedding embedding;
    embedding.to_uvw = glm::scale(glm::dmat4(1), 1.0 / glm::max(box.size(), glm::dvec3(1e-9))) *
                       glm::translate(glm::dmat4(1), -box.lo);
    const Knots knots = Knots::uniform(4, 7);
    const Lattice lattice{random_volume({knots, Knots::uniform(3, 6), knots}, 7, 0.1 * size),
                          glm::inverse(embedding.to_uvw)};
    const double tolerance = 2e-3 * size;
    const RefinementResult out =
        refine({{mesh, embedding}}, lattice, {.tolerance_world = tolerance});
    EXPECT_EQ(out.not_certified(), 0u);
    EXPECT_LE(out.bound, tolerance);
    EXPECT_LE(drawn_error(*out.parts[0].mesh, embedding, lattice, 4), out.bound);
    const EdgeCount before = count_edges(*mesh), after = count_edges(*out.parts[0].mesh);
    EXPECT_TRUE(before.open + before.crowded > 0 || after.open + after.crowded == 0);
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataRefinement,
                         ::testing::Values("suzanne.obj", "fandisk.obj", "spot.obj", "teapot.obj",
                                           "camel.off"));

} // namespace
} // namespace trivar
