// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/placement/placement.h"
#include "tests/placement/scenes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

glm::dmat4 raised(double z)
{
    glm::dmat4 m(1);
    m[3].z = z;
    return m;
}

struct Case {
    const char* name;
    Mesh mesh;
    double z = 0;
};

// A floor and one thing on it.
std::vector<Case> cases()
{
    // Smooth noise of several wavelengths, the shortest about one cell of the grid.
    const auto noise = [](double x, double y) {
        return 0.15 * sin(7 * x + 1) * sin(5 * y) + 0.06 * sin(19 * x + 2 * y) * cos(23 * y) +
               0.02 * sin(61 * x) * sin(57 * y + 3 * x);
    };
    return {{"sphere", sphere_mesh(0.5, 60, 40)},
            {"box", box_mesh({0.8, 0.8, 0.6}, {1, 1, 1}), 0.3},
            {"wall thinner than the grid", box_mesh({0.004, 3, 0.3}, {1, 1, 1}), 0.15},
            {"torus", torus_mesh(0.5, 0.15, {80, 40}), 0.1},
            {"needle", cylinder_mesh(0.002, 0.4, 6, 1), 0.2},
            {"noise", height_field(4, 300, noise)}};
}

TEST(Lift, NothingPenetratesMeasuredByOtherRays)
{
    const Ref<RayMesh> floor =
        std::make_shared<const RayMesh>(make_ref(plane_mesh({8, 8}, {2, 2})));
    for (Case& c : cases()) {
        const bool field = c.mesh.positions.size() > 90000;
        std::vector<RayScene::Entry> entries{
            {std::make_shared<const RayMesh>(make_ref(std::move(c.mesh))), raised(c.z), 1}};
        if (!field) entries.push_back({floor, glm::dmat4(1), 2});
        const RayScene scene(entries);
        for (const Camera& camera : {from_above(3), from_the_side(), from_the_side({-3, -3, 2})})
            for (const double stiffness : {0.0, 0.1, 0.25, 1.0})
                for (const double offset : {0.0, 1.0}) {
                    PlacementParameters asked;
                    asked.offset = offset;
                    asked.springs = stiffness > 0;
                    if (asked.springs) asked.stiffness = stiffness;
                    Timings timings;
                    const Placement out =
                        place(stroke_over(camera, {{-1, -0.2, 0}, {0, 0.1, 0.2}, {1, 0, 0}}), asked,
                              snake_box(), scene, timings);
                    const double h = out.report.height_world;
                    EXPECT_LE(out.report.penetration, 1e-3) << c.name;
                    EXPECT_LE(penetration(out.contact, camera, scene, 201), 1e-3 * h)
                        << c.name << " stiffness " << stiffness << " offset " << offset
                        << " perspective " << camera.perspective << " " << camera.eye.x;
                }
    }
}

} // namespace
} // namespace trivar
