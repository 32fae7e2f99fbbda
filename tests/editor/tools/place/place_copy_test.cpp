// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "tests/editor/laid.h"

namespace trivar {
namespace {

using testing::LaidRig;

struct CopyRig : LaidRig {
    CopyRig() : LaidRig({1300, 760}) // with room for all options
    {
        editor.session.selected = 2;
        key({'D'});
    }
    // Beside the first one, with Alt held from some way on.
    void draw_beside(bool alt, float up = 40)
    {
        const glm::vec2 c = layout().view.center();
        draw({c + glm::vec2(-70, -up), c + glm::vec2(70, -up)}, false);
        if (alt) hold(ui::key_left_alt);
        wait();
        seen = editor.session.document();
        screen.input().push(ui::press(ui::Button::left, false));
        frames(2);
        if (alt) hold(ui::key_left_alt, false);
        wait();
    }
    Document seen; // while the stroke was drawn
};

TEST(PlaceCopy, AltLaysACopyAndTheFirstStaysInOneStep)
{
    CopyRig rig;
    PlacementParameters p = rig.step().parameters;
    p.offset = 1;
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
    rig.wait();
    const Object first = object(rig.editor.session.document(), 2);
    const std::size_t steps = rig.steps();
    rig.draw_beside(true);
    EXPECT_TRUE(rig.seen.objects.contains(3)) << "the copy is seen while it is drawn";
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_EQ(object(rig.editor.session.document(), 2), first);
    ASSERT_TRUE(rig.is_laid(3));
    EXPECT_EQ(rig.step(3).parameters.offset, 1) << "it lies as the first does";
    EXPECT_TRUE(rig.step(3).attach) << "and goes with what it was drawn on";
    EXPECT_GT(glm::distance(rig.middle(3), rig.middle(2)), 0.2);
    EXPECT_EQ(rig.editor.session.selected, 3);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.editor.session.document().objects.contains(3));
}

TEST(PlaceCopy, WithoutAltTheStrokeMovesIt)
{
    CopyRig rig;
    const glm::dvec3 was = rig.middle();
    const std::size_t steps = rig.steps();
    rig.draw_beside(false);
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_FALSE(rig.editor.session.document().objects.contains(3));
    EXPECT_GT(glm::distance(rig.middle(), was), 0.2);
}

TEST(PlaceCopy, TheOptionsBarTurnsItRoundAndStaysChosen)
{
    CopyRig rig;
    // The second segment of "New stroke", right of the model.
    const ui::Rect bar = rig.layout().options;
    bool chosen = false;
    for (float x = bar.lo.x + 470; x < bar.hi.x && !chosen; x += 12) {
        rig.click({x, bar.center().y});
        for (const Hint& hint : rig.editor.active_tool().hints(rig.editor.session))
            chosen = chosen || hint.verb.find("lay a copy of Box") != std::string::npos;
    }
    ASSERT_TRUE(chosen);
    rig.move(rig.layout().view.center() + glm::vec2(0, 100));
    rig.draw_beside(false);
    ASSERT_TRUE(rig.is_laid(3));
    rig.draw_beside(true, 75);
    EXPECT_FALSE(rig.editor.session.document().objects.contains(4)) << "Alt moves then";
    rig.editor.session.undo();
    rig.wait();
    rig.editor.session.selected = 3;
    rig.draw_beside(false, 75);
    EXPECT_TRUE(rig.is_laid(4)) << "one after the other";
}

} // namespace
} // namespace trivar
