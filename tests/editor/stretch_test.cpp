// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture.h"
#include "tests/editor/rig.h"

#include <algorithm>

namespace trivar {
namespace {

using testing::Rig;

TEST(Stretch, IsToldBesideTheMedianOfWhatWasPlacedAndKeptAsLongAsTheMesh)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    const EvaluatedObject& placed = *rig.editor.session.evaluated().objects.at(2);
    ASSERT_TRUE(placed.placement);
    Stretches stretches;
    const auto values = stretches.of(placed.parts[0]);
    ASSERT_TRUE(values);
    ASSERT_EQ(values->size(), placed.parts[0].mesh()->vertex_count());
    EXPECT_EQ(stretches.of(placed.parts[0]), values);
    std::vector<float> sorted = *values;
    std::ranges::sort(sorted);
    EXPECT_EQ(sorted[sorted.size() / 2], 1);
    EXPECT_LT(sorted.front(), sorted.back());
    const EvaluatedObject& plane = *rig.editor.session.evaluated().objects.at(1);
    EXPECT_FALSE(stretches.of(plane.parts[0]));
}

TEST(Stretch, IsShownWhereTheSceneSaysSo)
{
    Rig rig;
    rig.two_objects();
    const Session& session = rig.editor.session;
    Stretches stretches;
    const auto picture = [&] {
        return picture_of(session.evaluated(), session.document(), session.camera, stretches);
    };
    EXPECT_FALSE(picture().value_colors);
    RenderSettings settings;
    settings.color_by = ColorBy::stretch;
    ASSERT_TRUE(rig.editor.session.run(SetRender{settings}));
    EXPECT_TRUE(picture().value_colors);
    rig.editor.session.undo();
    EXPECT_FALSE(picture().value_colors);
}

} // namespace
} // namespace trivar
