// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector's section that splits the triangles of what was placed.
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

#include <imgui.h>

namespace trivar {
namespace {

using testing::Rig;

// Two boxes on strokes, both selected; their travels are all that stands above the section.
struct Refinements : ::testing::Test {
    Rig rig{{1024, 900}};
    Refinements()
    {
        SceneFile scene = testing::typical_scene();
        scene.run(AddBox{});
        scene.run(testing::placed(6, 1));
        rig.editor.session.replace_scene(std::move(scene));
        rig.editor.session.selected.set({2, 6});
        rig.wait();
    }
    std::optional<Refining> of(Id id) { return object(rig.editor.session.document(), id).refining; }
    void run(const Command& command)
    {
        ASSERT_TRUE(rig.editor.session.run(command));
        rig.wait();
    }
    // The numbers of the inspector from above, found by the mouse's shape over them.
    std::vector<glm::vec2> numbers()
    {
        const ui::Rect in = rig.layout().inspector;
        const ui::Theme& theme = rig.screen.theme();
        const float x = in.lo.x + theme.size.padding + theme.size.label + 20;
        std::vector<glm::vec2> out;
        bool before = false;
        for (float y = in.lo.y; y < in.hi.y; y += 4) {
            rig.move({x, y});
            const bool over = ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeEW;
            if (over && !before) out.emplace_back(x, y + 8);
            before = over;
        }
        return out;
    }
    // The number that is the tolerance of an object.
    glm::vec2 tolerance_of(Id id)
    {
        for (const glm::vec2 at : numbers()) {
            const std::size_t before = rig.steps();
            type_at(at, "0.0375");
            const bool found = of(id) && of(id)->tolerance == 0.0375;
            while (rig.steps() > before) rig.editor.session.undo();
            rig.wait();
            if (found) return at;
        }
        ADD_FAILURE() << "there is no such number";
        return {};
    }
    void type_at(glm::vec2 at, const std::string& text)
    {
        rig.click(at);
        rig.frames(4);
        rig.type(text);
        rig.key({ui::key_enter});
        rig.wait();
    }
};

TEST_F(Refinements, AreTypedForAllAndKeepWhatTheyDifferIn)
{
    run(Refine{
        {2, 6}, {}, {{.budget = 100000}, {.split = SplitPoint::midpoint, .budget = 200000}}});
    const glm::vec2 at = tolerance_of(6);
    const std::size_t before = rig.steps();
    type_at(at, "0.02");
    EXPECT_EQ(rig.steps(), before + 1);
    for (const Id id : {2, 6}) EXPECT_EQ(of(id)->tolerance, 0.02) << id;
    EXPECT_EQ(of(2)->budget, 100000);
    EXPECT_EQ(of(6)->budget, 200000);
    EXPECT_EQ(of(6)->split, SplitPoint::midpoint);
    rig.editor.session.undo();
    EXPECT_EQ(of(2)->tolerance, Refining{}.tolerance);
}

TEST_F(Refinements, AreNeededForEachObjectOrForNone)
{
    EXPECT_FALSE(rig.editor.session.run(Refine{{2, 6}, {}, {{}}}));
    EXPECT_FALSE(of(2));
    run(Refine{{2, 6}, {.tolerance = 0.5}});
    EXPECT_EQ(of(2), of(6));
}

TEST_F(Refinements, AreSwitchedOnForThoseThatHaveNoneAndOffForAll)
{
    run(Refine{{6}, {.tolerance = 0.02}});
    const glm::vec2 check = tolerance_of(6) - glm::vec2(12, 28); // the row above
    rig.click(check);
    rig.wait();
    ASSERT_TRUE(of(2));
    EXPECT_EQ(of(2), of(6));
    rig.click(check);
    rig.wait();
    EXPECT_FALSE(of(2));
    EXPECT_FALSE(of(6));
}

} // namespace
} // namespace trivar
