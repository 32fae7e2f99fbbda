// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "tests/support/fixtures.h"
#include "tests/unwrap/surfaces.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

class RealDataUnwrapping : public ::testing::TestWithParam<std::tuple<const char*, UnwrapMethod>> {
};

} // namespace

TEST_P(RealDataUnwrapping, TurnsNoTriangleOverAndStretchesLittle)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const auto [name, method] = GetParam();
    const Model model = read_model(real_data_folder() + "/meshes/" + name);
    std::vector<UnwrapInput> meshes;
    for (const Ref<Mesh>& mesh : model.meshes) meshes.push_back({mesh});
    const Unwrapped out = unwrapped(meshes, {.method = method});
    std::size_t turned = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Mesh mesh = with_uvs(*meshes[m].mesh, out.uvs[m]);
        for (const glm::uvec3& t : triangles(mesh)) {
            const glm::dvec2 a = mesh.uvs[0][t.x], b = glm::dvec2(mesh.uvs[0][t.y]) - a,
                             c = glm::dvec2(mesh.uvs[0][t.z]) - a;
            turned += !(b.x * c.y - b.y * c.x > 0);
        }
    }
    RecordProperty("charts", static_cast<int>(out.facts.charts));
    RecordProperty("filled", std::to_string(out.facts.filled));
    RecordProperty("angle", std::to_string(out.facts.angle));
    RecordProperty("length", std::to_string(out.facts.length));
    EXPECT_EQ(turned, 0u);
    EXPECT_GT(out.facts.filled, 0.35);
    EXPECT_LT(out.facts.angle, 1.5);
    EXPECT_LT(out.facts.length, 2.5);
}

INSTANTIATE_TEST_SUITE_P(
    RealData, RealDataUnwrapping,
    ::testing::Combine(::testing::Values("camel.off", "fandisk.obj", "mountain.obj", "spot.obj",
                                         "stanford-bunny.obj", "teapot.obj"),
                       ::testing::Values(UnwrapMethod::conformal, UnwrapMethod::rigid)));

} // namespace trivar::testing
