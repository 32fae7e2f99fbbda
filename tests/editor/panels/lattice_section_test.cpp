// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/volumes/warp.h"
#include "editor/panels/inspector/field_cells.h"
#include "editor/session/done_titles.h"
#include "tests/editor/panels/lattice_rig.h"
#include "tests/editor/panels/number_rows.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

struct LatticeSection : testing::LatticeRig {
    explicit LatticeSection(int height_px = 1500) : LatticeRig(height_px) {}
    void type_into(glm::vec2 field, const std::string& text)
    {
        click(field);
        frames(4);
        type(text);
        key({ui::key_enter});
        wait();
    }
};

TEST(LatticeSection, SaysWhyADensityBelowTheOrderCannotBe)
{
    LatticeSection rig;
    const float row = rig.screen.theme().size.row + ImGui::GetStyle().ItemSpacing.y;
    rig.type_into(testing::number_field(rig, "shape.size.x") + glm::vec2(0, row), "3");
    EXPECT_EQ(std::get<LatticeShape>(rig.lattice().source).grid, glm::ivec3(4));
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
    EXPECT_NE(rig.editor.session.notices.all().back().title.find("order 4 needs at least 4"),
              std::string::npos);
    EXPECT_FALSE(rig.editor.session.proposing());
}

TEST(LatticeSection, NoProposalEndsTheProgram)
{
    LatticeSection rig;
    Session& session = rig.editor.session;
    const SetLattice bad{2, {.grid = {3, 4, 4}}};
    EXPECT_FALSE(session.propose(bad));
    EXPECT_FALSE(session.propose_quietly(bad));
    EXPECT_FALSE(session.run(bad));
    EXPECT_FALSE(session.propose(SetTransform{99, {}}));
    EXPECT_EQ(session.refused().size(), 2u); // the same one after the other counts once
}

TEST(LatticeSection, ChangesTheWarpThatWasMadeLastInPlaceOfMakingAnother)
{
    LatticeSection rig;
    ASSERT_TRUE(rig.editor.session.run(WarpVolume{2, {.twist_deg = 20}}));
    rig.wait();
    rig.type_into(testing::number_field(rig, "shaping.0.warp.twist_deg"), "40");
    ASSERT_EQ(rig.lattice().shaping.size(), 1u);
    EXPECT_EQ(rig.lattice().shaping[0]->warp->twist_deg, 40);
    rig.type_into(testing::number_field(rig, "shaping.0.warp.taper"), "50"); // percent
    ASSERT_EQ(rig.lattice().shaping.size(), 1u);
    EXPECT_EQ(rig.lattice().shaping[0]->warp->taper, 0.5);
}

TEST(LatticeSection, IsTitledWithTheAmountThatTheGuardLetThrough)
{
    LatticeSection rig;
    ASSERT_TRUE(rig.editor.session.run(WarpVolume{2, {.taper = -1}}));
    rig.wait();
    const History& history = rig.editor.session.scene().history();
    const History::Step& step = history.steps().back();
    const Document& before = history.steps()[history.steps().size() - 2].result;
    const StepTitle asked = step_title(step.command, before, step.result);
    const StepTitle done = done_title(rig.editor.session, step.command, before, step.result);
    EXPECT_EQ(asked.words, done.words);
    EXPECT_NE(asked.number, done.number);
}

TEST(FieldCells, StandBelowEachOtherWhereTheyWouldBeTooNarrow)
{
    ui::HeadlessFrames screen({320, 120});
    const ui::Theme& theme = screen.theme();
    const FieldCells wide(theme, theme.px(240), 3), narrow(theme, theme.px(120), 3);
    EXPECT_EQ(wide.offset(1).y, 0);
    EXPECT_GT(wide.offset(1).x, wide.width);
    EXPECT_EQ(narrow.offset(1).x, 0);
    EXPECT_GE(narrow.offset(1).y, theme.size.row);
    EXPECT_EQ(narrow.width, theme.px(120));
    EXPECT_EQ(FieldCells(theme, theme.px(40), 1).width, theme.px(40));
}

} // namespace
} // namespace trivar
