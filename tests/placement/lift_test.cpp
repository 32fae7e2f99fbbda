// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/placement/scenes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

TEST(Lift, NothingPenetratesMeasuredByOtherRays)
{
    for (const NamedScene& scene : scenes_to_cover())
        for (const Camera& camera : {from_above(3), from_the_side(), from_the_side({-3, -3, 2})})
            for (const double stiffness : {0.0, 0.1, 0.25, 1.0})
                for (const double offset : {0.0, 1.0}) {
                    PlacementParameters asked;
                    asked.offset = offset;
                    asked.springs = stiffness > 0;
                    if (asked.springs) asked.stiffness = stiffness;
                    const Placement out = placed(stroke_to_cover(camera), scene.scene, asked);
                    const double h = out.report.height_world;
                    EXPECT_LE(out.report.penetration, 1e-3) << scene.name;
                    EXPECT_LE(penetration(out.contact, camera, scene.scene, 201), 1e-3 * h)
                        << scene.name << " stiffness " << stiffness << " offset " << offset
                        << " perspective " << camera.perspective << " " << camera.eye.x;
                }
}

} // namespace
} // namespace trivar
