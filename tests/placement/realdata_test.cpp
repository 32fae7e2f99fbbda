// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "core/placement/placement.h"
#include "tests/placement/scenes.h"
#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

class RealDataPlacement : public ::testing::TestWithParam<const char*> {};

TEST_P(RealDataPlacement, AStrokeAcrossTheMeshDoesNotPenetrateIt)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Model model = read_model(real_data_folder() + "/meshes/" + GetParam());
    std::vector<RayScene::Entry> entries;
    for (std::size_t n = 0; n < model.nodes.size(); ++n)
        if (model.nodes[n].mesh >= 0)
            entries.push_back({std::make_shared<const RayMesh>(
                                   model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)]),
                               node_to_model(model, static_cast<int>(n)), 0});
    const RayScene scene(std::move(entries));
    const Box box = scene.bounds();
    const double size = glm::length(box.size());
    for (const glm::dvec3& from : {glm::dvec3(0.3, -1, 0.8), glm::dvec3(-1, -0.5, 0.5)}) {
        Camera camera;
        camera.target = box.center();
        camera.eye = box.center() + 1.5 * size * glm::normalize(from);
        camera.size_px = {1500, 1000};
        const glm::dvec2 middle = project(camera, box.center()).p_px;
        const double reach = 0.12 * size / pixel_size_world(camera, 1.5 * size);
        Timings timings;
        const Placement out = place(stroke(camera, {middle - glm::dvec2(reach, 0), middle,
                                                    middle + glm::dvec2(reach, -20)}),
                                    {}, snake_box(), scene, timings);
        EXPECT_LE(out.report.penetration, 1e-3);
        EXPECT_LE(penetration(out.contact, camera, scene, 301), 1e-3 * out.report.height_world);
        EXPECT_GT(out.report.smallest_jacobian, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataPlacement,
                         ::testing::Values("mountain.obj", "face.obj", "camel.off",
                                           "stanford-bunny.obj"));

} // namespace
} // namespace trivar
