// SPDX-License-Identifier: GPL-3.0-or-later
// The graphics card finds the silhouettes that the processor finds.
#include "core/silhouette/silhouette_finder.h"
#include "gpu/silhouette/device_silhouettes.h"
#include "tests/gpu/support.h"
#include "tests/silhouette/scenes.h"

#include <epoxy/gl.h>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::Sampled;
using trivar::testing::some_views;

class DeviceSilhouetteTest : public WithContext {
protected:
    void SetUp() override
    {
        if (epoxy_gl_version() < 43) GTEST_SKIP() << "no compute shaders";
    }
    Programs programs_;
};

void expect_same(const Silhouettes& a, const Silhouettes& b)
{
    ASSERT_EQ(a.first, b.first);
    ASSERT_EQ(a.closed, b.closed);
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        ASSERT_EQ(a.points[i].edge, b.points[i].edge);
        ASSERT_EQ(a.points[i].p, b.points[i].p);
    }
}

TEST_F(DeviceSilhouetteTest, AreTheCurvesOfTheProcessorBitByBit)
{
    DeviceSilhouettes device;
    SilhouetteFinder find, from_device;
    for (const char* function : {"torus", "gauss", "waves", "noise"}) {
        const Sampled scene(function, function == std::string("noise") ? 14 : 48);
        const Ref<LevelMesh> mesh = make_ref(scene.level());
        ASSERT_TRUE(DeviceSilhouettes::fits(*mesh));
        device.take(mesh);
        for (const ViewPoint& view : some_views(scene.from.size, 12))
            expect_same(find(scene.field, *mesh, view),
                        from_device(scene.field, *mesh, view, device.crossed(programs_, view)));
    }
}

TEST_F(DeviceSilhouetteTest, AreNoneOfAnEmptyLevel)
{
    const Sampled scene("gauss", 16);
    DeviceSilhouettes device;
    device.take(make_ref(scene.level(1e6)));
    EXPECT_TRUE(device.crossed(programs_, {{0, 0, 1, 0}}).empty());
}

} // namespace
} // namespace trivar::gpu::testing
