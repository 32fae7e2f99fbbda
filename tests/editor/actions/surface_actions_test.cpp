// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "tests/editor/boxes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

struct TwoBoxes : testing::Boxes {
    using Boxes::Boxes;
    bool can(const char* name) { return is_enabled(editor, action(editor, name)); }
    void run(const char* name)
    {
        ASSERT_TRUE(can(name)) << name;
        action(editor, name).run(editor);
        wait();
    }
    ShadingWay way_of(Id id) const
    {
        return object(editor.session.document(), id).shading.value_or(FaceShading{}).way;
    }
};

TEST(SurfaceActions, ShadeAllThatIsSelectedInOneStep)
{
    TwoBoxes rig;
    rig.editor.session.selected.set({1, 2});
    const std::size_t before = rig.steps();
    rig.run("Shade flat");
    EXPECT_EQ(rig.steps(), before + 1);
    for (const Id id : {1, 2}) EXPECT_EQ(rig.way_of(id), ShadingWay::flat);
    EXPECT_FALSE(rig.can("Shade flat"));
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.can("Clear shading"));
    EXPECT_EQ(rig.way_of(1), ShadingWay::own);
}

TEST(SurfaceActions, ShadeOnlyWhatIsNotShadedSoYet)
{
    TwoBoxes rig;
    rig.editor.session.selected = 1;
    rig.run("Shade by angle");
    rig.editor.session.selected.set({1, 2});
    rig.run("Shade smooth");
    rig.editor.session.selected = 2;
    rig.run("Clear shading");
    EXPECT_EQ(rig.way_of(1), ShadingWay::smooth);
    EXPECT_EQ(rig.way_of(2), ShadingWay::own);
}

TEST(SurfaceActions, NeedASurface)
{
    TwoBoxes rig;
    EXPECT_TRUE(rig.editor.session.run(Group{{1, 2}}));
    rig.editor.session.selected = 3;
    for (const char* name : {"Shade smooth", "Shade flat", "Shade by angle", "Unwrap"})
        EXPECT_FALSE(rig.can(name)) << name;
}

} // namespace
} // namespace trivar
