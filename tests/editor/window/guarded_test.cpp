// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes of Trivar in its window.
#include "editor/window/guarded.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::StartsWith;

// Fails in the middle of its options, with everything open that can be.
struct FailingTool : Tool {
    std::function<void()> fail = [] { throw Mistake("it broke"); };
    bool cancelled = false;
    FailingTool() : Tool({.name = "Place", .help = "It fails."}) {} // there is an action Place
    void use(Session&, const ViewportInput&) override {}
    void cancel(Session&) override { cancelled = true; }
    std::vector<Hint> hints(const Session&) const override { return {}; }
    void options(Session&, const ui::Theme& theme, float) override
    {
        ImGui::Begin("a window");
        ImGui::PushFont(theme.font.title);
        ImGui::PushID(1);
        ImGui::BeginChild("a child");
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
        ImGui::PushStyleColor(ImGuiCol_Text, 0);
        ImGui::BeginGroup();
        ImGui::BeginDisabled();
        if (ImGui::BeginTable("a table", 2)) ImGui::TableNextColumn();
        fail();
    }
};

struct FailingRig : ::testing::Test {
    testing::TemporaryFolder folder;
    testing::Rig rig{{720, 520}, {}, {}, OnFailure::leave_out};
    Editor& editor = rig.editor;
    FailingTool* tool = nullptr;
    FailingRig()
    {
        editor.memory.of<MistakeReports>().folder = folder.file("mistakes");
        rig.two_objects();
        auto failing = std::make_unique<FailingTool>();
        tool = failing.get();
        editor.tools.push_back(std::move(failing));
    }
    void take_failing_tool() { editor.tool = editor.tools.size() - 1; }
    std::vector<std::string> reports() const
    {
        std::vector<std::string> out;
        std::error_code ignored;
        for (const auto& each :
             std::filesystem::directory_iterator(folder.file("mistakes"), ignored))
            out.push_back(read_text_file(each.path().string()));
        return out;
    }
    const ui::Notices::Notice& notice() const { return editor.session.notices.all().back(); }
};

TEST_F(FailingRig, AMistakeOfAToolIsTellableAndTheWindowGoesOnWithTheFirstTool)
{
    editor.session.selected = 2;
    take_failing_tool();
    rig.frames(1);
    EXPECT_EQ(editor.tool, 0u);
    EXPECT_TRUE(tool->cancelled);
    EXPECT_THAT(notice().title, StartsWith("Trivar made a mistake here: it broke"));
    EXPECT_THAT(notice().body, HasSubstr(folder.file("mistakes")));
    EXPECT_EQ(editor.session.selected, 2) << "another tool will do";
    const std::size_t count = editor.session.notices.all().size();
    rig.frames(5);
    EXPECT_EQ(editor.session.notices.all().size(), count);
    ASSERT_TRUE(editor.session.run(AddSphere{}));
    rig.wait();
    EXPECT_EQ(editor.session.evaluated().objects.size(), 3u);
}

TEST_F(FailingRig, AMistakeIsWrittenDownOnceWithTheScene)
{
    for (int i = 0; i < 3; ++i) {
        take_failing_tool();
        rig.frames(2);
    }
    ASSERT_EQ(reports().size(), 1u);
    EXPECT_THAT(reports().front(), HasSubstr("it broke"));
    EXPECT_THAT(reports().front(), HasSubstr("\"do\":\"add_box\""));
}

TEST_F(FailingRig, WhatFailsWithTheFirstToolLosesItsSelection)
{
    editor.session.selected = 2;
    rig.screen.frames(1, [&](const auto&...) {
        EXPECT_FALSE(do_guarded(editor, [] { throw std::bad_optional_access(); }));
    });
    EXPECT_EQ(editor.session.selected, 0);
}

TEST_F(FailingRig, ARefusalThatNobodyHeardIsANoticeWithoutAReport)
{
    tool->fail = [] { throw Rejected("this cannot be"); };
    take_failing_tool();
    rig.frames(2);
    EXPECT_EQ(notice().title, "This cannot be");
    EXPECT_TRUE(reports().empty());
}

TEST_F(FailingRig, NoMoreThanTwentyReportsAreKept)
{
    for (int i = 0; i < 25; ++i)
        testing::write_file(folder.file(fmt::format("mistakes/mistake 2000-01-{:02}.txt", i)), "");
    take_failing_tool();
    rig.frames(2);
    EXPECT_EQ(reports().size(), 20u);
}

TEST(MistakesInTests, EndThem)
{
    testing::Rig rig;
    rig.frames(1);
    EXPECT_THROW(do_guarded(rig.editor, [] { throw Mistake("a"); }), Mistake);
}

} // namespace
} // namespace trivar
