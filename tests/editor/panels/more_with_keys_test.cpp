// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector's section for numbers that only keys change.
#include "core/commands/keying.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/warp.h"
#include "editor/panels/inspector/number_rows.h"
#include "tests/editor/panels/lattice_rig.h"

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using ::testing::ElementsAre;

// A ball in a lattice (object 2) that was bent and of which a point was moved.
struct BentLattice : testing::LatticeRig {
    BentLattice() : LatticeRig(1800) // nothing scrolls
    {
        draw_small();
        EXPECT_TRUE(editor.session.run(WarpVolume{2, {.twist_deg = 20}}));
        EXPECT_TRUE(editor.session.run(
            MovePoints{2, {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0, 0, 0.1}}}));
        wait();
    }
    // A place in the inspector, `from_right` pixels from its right side, where that is so with the
    // mouse there. Scrolls from the top.
    glm::vec2 place_where(float from_right, const std::function<bool()>& so)
    {
        const ui::Rect in = layout().inspector;
        move(in.center());
        screen.input().push(ui::turn_wheel(1000));
        frames(4);
        for (int page = 0; page < 20; ++page) {
            for (float y = in.lo.y + 8; y < in.hi.y; y += 8) {
                move({in.hi.x - from_right, y});
                if (so()) return {in.hi.x - from_right, y};
            }
            screen.input().push(ui::turn_wheel(-4));
            frames(4);
        }
        ADD_FAILURE() << "there is no such row";
        return in.lo;
    }
    // The mark for keys in the row of that number.
    glm::vec2 mark(const std::string& name)
    {
        return place_where(18, [&] { return is_over(name); });
    }
    void open_section()
    {
        const int selected = editor.session.selected;
        const ImGuiID title = ImHashStr(
            number_rows_title, 0,
            ImHashData(&selected, sizeof selected, ImGui::FindWindowByName("inspector")->ID));
        click(place_where(60, [&] { return ImGui::GetHoveredID() == title; }));
    }
    const Track* track(const std::string& name) const
    {
        return track_of(editor.session.document(), 2, name);
    }
};

std::vector<std::string> labels_of(const std::vector<NumberRow>& rows)
{
    std::vector<std::string> labels;
    for (const NumberRow& row : rows)
        labels.push_back((row.caption.empty() ? "" : row.caption + " > ") + row.label);
    return labels;
}

TEST(MoreWithKeys, NamesAStepOnceAndItsNumbersBelowIt)
{
    const BentLattice rig;
    const std::vector<NumberRow> rows = number_rows(rig.lattice(), 1000);
    std::vector<std::string> captions;
    for (const NumberRow& row : rows) {
        EXPECT_EQ(row.label.find("Step"), std::string::npos) << row.label;
        EXPECT_FALSE(std::islower(static_cast<unsigned char>(row.label[0]))) << row.label;
        EXPECT_EQ(row.number.name.find(".points."), std::string::npos) << row.number.name;
        if (row.number.name.starts_with("shaping.") && !row.caption.empty())
            captions.push_back(row.caption);
    }
    ASSERT_EQ(captions.size(), 2u);
    EXPECT_TRUE(captions[0].starts_with("Step 1: ")) << captions[0];
    EXPECT_TRUE(captions[1].starts_with("Step 2: ")) << captions[1];
    EXPECT_EQ(number_rows(rig.lattice(), 2).size(), 2u);
    const Document box = after(Document{}, AddBox{});
    EXPECT_THAT(
        labels_of(number_rows(object(box, 1), 1000)),
        ElementsAre("Size X", "Size Y", "Size Z", "Segments X", "Segments Y", "Segments Z"));
}

TEST(MoreWithKeys, PutsKeysOnTheNumbersOfAWarpEachByItsOwnRow)
{
    BentLattice rig;
    rig.open_section();
    const std::string twist = "shaping.0.warp.twist_deg", taper = "shaping.0.warp.taper";
    rig.editor.session.show_frame(5);
    rig.frames();
    const std::size_t steps = rig.steps();
    rig.click(rig.mark(twist));
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    ASSERT_TRUE(rig.track(twist));
    EXPECT_EQ(rig.track(twist)->keys.front().frame, 5);
    EXPECT_EQ(rig.track(twist)->keys.front().value, 20);
    EXPECT_FALSE(rig.track(taper));
    rig.editor.session.show_frame(15);
    ASSERT_TRUE(rig.editor.session.run(SetWarp{2, 1, {.twist_deg = 60}}));
    rig.wait();
    ASSERT_EQ(rig.track(twist)->keys.size(), 2u) << "what is animated changes by keys";
    EXPECT_EQ(rig.track(twist)->keys.back().value, 60);
    EXPECT_EQ(object(rig.editor.session.committed(), 2).shaping[0]->warp->twist_deg, 20);
}

TEST(MoreWithKeys, ATypedNumberIsAKeyInOneStepAndScrollsNothing)
{
    BentLattice rig;
    rig.open_section();
    const std::string lift = "shaping.1.shift.by.z";
    const glm::vec2 at = rig.mark(lift);
    const glm::vec2 field(at.x - 60, at.y);
    const std::size_t steps = rig.steps();
    rig.editor.session.show_frame(5);
    rig.click(field);
    rig.frames(4);
    rig.type("0.25");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    ASSERT_TRUE(rig.track(lift));
    EXPECT_EQ(rig.track(lift)->keys.front().frame, 5);
    EXPECT_NEAR(rig.track(lift)->keys.front().value, 0.25, 1e-12);
    rig.move(at + glm::vec2(0, 4));
    EXPECT_TRUE(rig.is_over(lift)) << "the row is still under the mouse";
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.track(lift));
    rig.move(at + glm::vec2(1, 4));
    EXPECT_TRUE(rig.is_over(lift));
}

} // namespace
} // namespace trivar
