// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/left_behind.h"

#include "core/commands/command.h"
#include "editor/actions/actions.h"
#include "tests/editor/laid.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;

// On boxes 1 and 2, of which 2 is merely passed, and with a box 4 below, lies 3.
Document laid_on_a_box(bool both_touched)
{
    Document document;
    for (int i = 0; i < 4; ++i) document = after(document, AddBox{});
    Sketch sketch;
    sketch.samples = {{{400, 360}, 0, 1}, {{800, 360}, 1, 1}};
    document = after(document, Place{3, sketch, {}, {1, 2, 4}});
    Attachment attachment;
    for (const Id id : {1, 2})
        attachment.hosts.push_back(attached_host(id, glm::dmat4(1), id == 1 || both_touched));
    attachment.samples = {{.host = 0}, {.host = both_touched ? 1 : -1}};
    return after(document, Attach{3, attachment});
}

std::vector<std::string> said_when_deleted(const Document& document, const std::vector<Id>& ids)
{
    return left_behind(document, after(document, Delete{ids}));
}

TEST(LeftBehind, IsToldByWhatBecomesOfIt)
{
    const Document one = laid_on_a_box(false), both = laid_on_a_box(true);
    const std::string drawn = "Box goes with nothing now and lies where it was drawn.";
    EXPECT_THAT(said_when_deleted(both, {1}),
                ElementsAre("Box goes with the rest of what carried it."));
    EXPECT_THAT(said_when_deleted(both, {1, 2}), ElementsAre(drawn));
    EXPECT_THAT(said_when_deleted(one, {1}), ElementsAre(drawn))
        << "what it merely passes does not carry it";
    EXPECT_THAT(said_when_deleted(both, {1, 2, 4}),
                ElementsAre("Box has nothing left to lie on and stands straight. Place it anew."));
}

TEST(LeftBehind, IsNothingWhereNothingThatCarriedWent)
{
    const Document one = laid_on_a_box(false), both = laid_on_a_box(true);
    EXPECT_THAT(said_when_deleted(one, {2}), IsEmpty());
    EXPECT_THAT(said_when_deleted(both, {4}), IsEmpty());
    EXPECT_THAT(said_when_deleted(both, {1, 2, 3}), IsEmpty()) << "it went along";
}

TEST(LeftBehind, IsSaidInTheWindowInOneStep)
{
    testing::LaidRig rig;
    ASSERT_TRUE(rig.step().attach);
    rig.editor.session.selected = 1;
    rig.editor.session.notices.clear();
    const std::size_t steps = rig.steps();
    action(rig.editor, "Delete").run(rig.editor);
    rig.wait();
    ASSERT_EQ(rig.editor.session.notices.all().size(), 1u);
    EXPECT_EQ(rig.editor.session.notices.all().front().title, "Deleted");
    EXPECT_EQ(rig.editor.session.notices.all().front().body,
              "Box has nothing left to lie on and stands straight. Place it anew.");
    EXPECT_EQ(rig.steps(), steps + 1);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.step().attach);
    EXPECT_TRUE(rig.is_laid());
}

} // namespace
} // namespace trivar
