// SPDX-License-Identifier: GPL-3.0-or-later
// What a small window must still show, and what lies over what.
#include "editor/panels/menu_bar.h"
#include "editor/record/record_plan.h"
#include "tests/editor/rig.h"

#include <algorithm>
#include <imgui_internal.h>
#include <set>
#include <string_view>

namespace trivar {
namespace {

using testing::Rig;

constexpr glm::ivec2 low_window{1024, 700};
const ui::ThemeOptions twice_the_scale{.scale = 2};

// The menu of that name, which hangs from the menu bar.
const ImGuiWindow& opened(Rig& rig, const std::string& name)
{
    rig.editor.memory.of<MenuBar>().next = name;
    rig.frames(4);
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, name);
    return *GImGui->OpenPopupStack.front().Window;
}

TEST(SmallWindow, NoMenuCoversTheMenuBarOrScrolls)
{
    Rig rig(low_window);
    rig.two_objects();
    for (const char* name : {"File", "Edit", "Select", "Add", "View", "Animate", "Tools", "Help"}) {
        const ImGuiWindow& menu = opened(rig, name);
        EXPECT_GE(menu.Pos.y, rig.layout().top.lo.y + 20) << name;
        EXPECT_LE(menu.Pos.y + menu.Size.y, static_cast<float>(low_window.y)) << name;
        EXPECT_EQ(menu.ScrollMax.y, 0) << name;
        rig.key({ui::key_escape});
    }
}

TEST(SmallWindow, EveryToolHasAPlaceOfItsOwnAtAnyScale)
{
    for (const float scale : {1.0f, 2.0f, 2.5f, 3.0f}) {
        Rig rig({1280, 800}, {.scale = scale});
        rig.frames();
        const Layout layout = rig.layout();
        const std::size_t count = rig.editor.tools.size();
        for (std::size_t i = 0; i < count; ++i) {
            const ui::Rect own = layout.tool_place(rig.screen.theme(), i);
            EXPECT_TRUE(layout.strip.contains(own.lo) && layout.strip.contains(own.hi - 1.0f))
                << scale;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(layout.tool_place(rig.screen.theme(), k).contains(own.center()));
            rig.click(own.center());
            EXPECT_EQ(rig.editor.tool, i) << scale;
        }
        EXPECT_GT(layout.view.lo.x, layout.strip.hi.x);
        EXPECT_EQ(layout.strip.width() > 60 * scale,
                  scale > 2); // one column, as far as it has room
    }
}

class ScaledMenus : public ::testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(SmallWindow, ScaledMenus, ::testing::Values(2.0f, 2.5f, 3.0f));

TEST_P(ScaledMenus, HaveNoButtonOnThem)
{
    Rig rig({1280, 800}, {.scale = GetParam()});
    rig.two_objects();
    const auto& windows = GImGui->Windows;
    const auto menus = std::find_if(windows.begin(), windows.end(), [](const ImGuiWindow* each) {
        return std::string_view(each->Name).find("/menus_") != std::string_view::npos;
    });
    ASSERT_NE(menus, windows.end());
    const float end = (*menus)->Pos.x + (*menus)->Size.x, step = 12 * GetParam();
    const float y = rig.layout().top.center().y;
    std::set<std::string> opened;
    for (float x = (*menus)->Pos.x + step; x < end - 2; x += step) {
        rig.click({x, y});
        opened.insert(rig.editor.memory.of<MenuBar>().open);
        rig.key({ui::key_escape});
    }
    opened.erase("");
    EXPECT_EQ(opened.size(), 8u);
    EXPECT_EQ(rig.steps(), 2u);
}

TEST(SmallWindow, AtTwiceTheScaleEveryPageOfThePreferencesIsReached)
{
    Rig rig({1280, 800}, twice_the_scale);
    rig.editor.preferences_dialog.open = true;
    rig.frames();
    const ImGuiWindow* dialog = ImGui::FindWindowByName("preferences");
    ASSERT_TRUE(dialog);
    const float foot = dialog->Pos.y + dialog->Size.y - 2 * 60;
    std::set<int> pages;
    for (float y = dialog->Pos.y + 2 * 60; y < foot; y += 8) {
        rig.click({dialog->Pos.x + 2 * 60, y});
        pages.insert(rig.editor.preferences_dialog.page);
    }
    EXPECT_EQ(pages.size(), static_cast<std::size_t>(PreferencesDialog::page_count));
}

TEST(SmallWindow, AtTwiceTheScaleTheClosedTimelineStillGoesToAnyFrame)
{
    Rig rig({1280, 800}, twice_the_scale);
    rig.two_objects();
    rig.editor.preferences.timeline_open = false;
    rig.frames();
    const ui::Rect timeline = rig.layout().timeline;
    rig.click({timeline.hi.x - 40, timeline.center().y});
    EXPECT_GT(rig.editor.session.frame(), 100);
    rig.click({timeline.hi.x - 2 * 120, timeline.center().y});
    EXPECT_LT(rig.editor.session.frame(), 100);
}

TEST(SmallWindow, AtTwiceTheScaleTheInspectorKeepsRoomForRows)
{
    Rig rig({1280, 800}, twice_the_scale);
    rig.frames();
    EXPECT_GE(rig.layout().inspector.height(), 2 * 140);
    EXPECT_GE(rig.layout().outliner.height(), 2 * 100);
}

TEST(SmallWindow, AtTwiceTheScaleADialogOfFramesShowsAllItsFields)
{
    Rig rig({1280, 800}, twice_the_scale);
    rig.two_objects();
    rig.editor.memory.of<RecordDialog>().open = true;
    rig.frames(3);
    const auto& windows = GImGui->Windows;
    const auto fields = std::find_if(windows.begin(), windows.end(), [](const ImGuiWindow* each) {
        return std::string_view(each->Name).find("/plan_") != std::string_view::npos;
    });
    ASSERT_NE(fields, windows.end());
    EXPECT_EQ((*fields)->ScrollMax.y, 0);
}

TEST(SmallWindow, NoticesLieOnNoButtonOfADialog)
{
    Rig rig(low_window);
    rig.two_objects();
    rig.editor.preferences_dialog.open = true;
    rig.frames();
    rig.editor.session.notices.say(ui::NoticeKind::error, "It was not written",
                                   "The disk is full.");
    rig.frames();
    const ImGuiWindow *notice = ImGui::FindWindowByName("notice 0"),
                      *dialog = ImGui::FindWindowByName("preferences");
    ASSERT_TRUE(notice && dialog);
    const float foot = dialog->Pos.y + dialog->Size.y - 60;
    EXPECT_LT(notice->Pos.y + notice->Size.y, foot);
    rig.key({ui::key_escape});
    rig.frames();
    EXPECT_GT(notice->Pos.y, rig.layout().view.center().y); // where notices are elsewhere
}

TEST(SmallWindow, ATipOfARowOfTheInspectorLeavesTheRowsBelowInSight)
{
    Rig rig(low_window);
    rig.two_objects();
    const ui::Rect inspector = rig.layout().inspector;
    bool any = false;
    for (float y = inspector.lo.y + 8; y < inspector.hi.y - 8; y += 24) {
        rig.screen.input().push(ui::move_to({inspector.lo.x + 30, y}));
        rig.screen.settle(rig.body(), 60);
        if (!ui::tooltips().shown()) continue;
        any = true;
        const ImGuiWindow* tip = ImGui::FindWindowByName("tooltip");
        ASSERT_TRUE(tip);
        EXPECT_LE(tip->Pos.x + tip->Size.x, inspector.lo.x) << ui::tooltips().shown()->name;
    }
    EXPECT_TRUE(any);
}

} // namespace
} // namespace trivar
