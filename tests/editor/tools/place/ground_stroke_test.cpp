// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/parameters.h"
#include "core/placement/placement.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

const PlacementStep& step_of(const Rig& rig, Id id)
{
    return *object(rig.editor.session.committed(), id).stroke;
}

// A box, alone or beside a small plane, seen from the front and above.
struct GroundRig : Rig {
    explicit GroundRig(bool plane)
    {
        if (plane) {
            AddPlane floor;
            floor.shape.size = {1, 1};
            EXPECT_TRUE(editor.session.run(floor));
        }
        AddBox box;
        box.shape.size = {0.6, 0.2, 0.2};
        box.transform.translation = {0, 1, 0.1};
        EXPECT_TRUE(editor.session.run(box));
        editor.session.view.camera.eye = {0.5, -6, 4};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
        key({'D'});
    }
    void stroke(double from_x, double to_x, double y = -0.3)
    {
        draw({seen_at({from_x, y, 0}), seen_at({to_x, y, 0})});
        wait();
    }
};

TEST(GroundStroke, LaysAnObjectThatStandsAlone)
{
    GroundRig rig(false);
    rig.stroke(-0.8, 0.8);
    ASSERT_EQ(rig.steps(), 2u);
    EXPECT_TRUE(step_of(rig, 1).parameters.on_ground);
    EXPECT_TRUE(step_of(rig, 1).onto.empty());
    const Placement& placement = *rig.editor.session.evaluated().objects.at(1)->stroke_placement();
    EXPECT_EQ(placement.report.missed_share, 0);
    for (const StripNode& node : placement.nodes) EXPECT_NEAR(node.p_world.z, 0, 1e-9);
}

TEST(GroundStroke, FallsOnTheGroundWhereItBeginsThere)
{
    GroundRig rig(true);
    rig.stroke(-1.2, 0.3);
    ASSERT_EQ(rig.steps(), 3u);
    EXPECT_TRUE(step_of(rig, 2).parameters.on_ground);
    rig.stroke(-0.4, 0.45, 0.3); // a stroke from an object lies as it always did
    ASSERT_EQ(rig.steps(), 4u);
    EXPECT_FALSE(step_of(rig, 2).parameters.on_ground);
}

} // namespace
} // namespace trivar
