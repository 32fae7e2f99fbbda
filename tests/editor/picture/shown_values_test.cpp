// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/refine.h"
#include "core/commands/objects/view.h"
#include "editor/picture/picture.h"
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
    ShownValues shown;
    const auto values = shown.stretch_of(placed.parts[0]);
    ASSERT_TRUE(values);
    ASSERT_EQ(values->size(), placed.parts[0].mesh()->vertex_count());
    EXPECT_EQ(shown.stretch_of(placed.parts[0]), values);
    std::vector<float> sorted = *values;
    std::ranges::sort(sorted);
    EXPECT_EQ(sorted[sorted.size() / 2], 1);
    EXPECT_LT(sorted.front(), sorted.back());
    const EvaluatedObject& plane = *rig.editor.session.evaluated().objects.at(1);
    EXPECT_FALSE(shown.stretch_of(plane.parts[0]));
}

TEST(Stretch, IsShownWhereTheSceneSaysSo)
{
    Rig rig;
    rig.two_objects();
    const Session& session = rig.editor.session;
    ShownValues values;
    const auto picture = [&] {
        return picture_of(session.evaluated(), session.document(), session.view.camera, values);
    };
    EXPECT_FALSE(picture().value_colors);
    RenderSettings settings;
    settings.color_by = ColorBy::stretch;
    ASSERT_TRUE(rig.editor.session.run(SetRender{settings}));
    EXPECT_TRUE(picture().value_colors);
    rig.editor.session.undo();
    EXPECT_FALSE(picture().value_colors);
}

TEST(Error, IsToldByTheToleranceAndIsTheSameWhoeverBoundsTheTriangles)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    const Session& session = rig.editor.session;
    ShownValues shown;
    const auto placed = [&]() -> const EvaluatedObject& {
        return *session.evaluated().objects.at(2);
    };
    const Refining coarse{.tolerance = 100};
    const auto values = shown.error_of(placed(), 0, coarse);
    ASSERT_TRUE(values);
    ASSERT_EQ(values->size(), placed().parts[0].rest->vertex_count());
    EXPECT_EQ(shown.error_of(placed(), 0, coarse), values);
    EXPECT_NE(shown.error_of(placed(), 0, {.tolerance = 10}), values);
    EXPECT_NE(shown.error_of(placed(), 0, {.tolerance = 100, .method = BoundMethod::thesis}),
              values);
    const std::vector<float> before = *values;

    ASSERT_TRUE(rig.editor.session.run(Refine{{2}, coarse})); // nothing has to be split
    rig.wait();
    ASSERT_TRUE(placed().refined);
    EXPECT_EQ(*shown.error_of(placed(), 0, coarse), before);
}

TEST(Error, IsAtMostTheToleranceWhereAllIsCertified)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    const Refining fine{.tolerance = 1e-4};
    ASSERT_TRUE(rig.editor.session.run(Refine{{2}, fine}));
    rig.wait();
    const EvaluatedObject& placed = *rig.editor.session.evaluated().objects.at(2);
    ShownValues shown;
    const auto values = shown.error_of(placed, 0, fine);
    ASSERT_TRUE(values);
    ASSERT_EQ(values->size(), placed.parts[0].rest->vertex_count());
    EXPECT_LE(std::ranges::max(*values), 1);
    EXPECT_EQ(shown_tolerance(rig.editor.session.document()), 1e-4);
}

TEST(Error, IsShownWhereTheSceneSaysSoFromDarkToLight)
{
    Rig rig;
    rig.two_objects();
    const Session& session = rig.editor.session;
    ASSERT_TRUE(rig.editor.session.run(SetRender{{.color_by = ColorBy::error}}));
    ShownValues values;
    const gpu::Picture picture =
        picture_of(session.evaluated(), session.document(), session.view.camera, values);
    ASSERT_TRUE(picture.value_colors);
    EXPECT_FALSE(picture.value_colors->diverging);
}

} // namespace
} // namespace trivar
