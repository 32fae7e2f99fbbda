// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "editor/actions/command_filling.h"
#include "editor/actions/show_manual.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using testing::NamedScene, testing::Rig;

// Glyphs that stand across the left or right edge of what is shown of their window: text that was
// cut instead of shortened. Glyphs are what takes its colour from the font texture.
struct CutText {
    int glyphs = 0;
    ImVec2 first{0, 0};
    ImVec4 clip{0, 0, 0, 0};
};
// Letters that belong to the scene may stand half outside of the picture.
bool on_the_picture(const ImDrawList& list)
{
    return list._OwnerName && std::string_view(list._OwnerName) == "viewport";
}
CutText cut_text()
{
    constexpr float slack_px = 1.5f; // a letter's blur
    const ImDrawData& drawn = *ImGui::GetDrawData();
    const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const auto plain = [&](const ImDrawVert& v) {
        return v.uv.x == atlas.TexUvWhitePixel.x && v.uv.y == atlas.TexUvWhitePixel.y;
    };
    CutText cut;
    for (int n = 0; n < drawn.CmdListsCount; ++n) {
        const ImDrawList& list = *drawn.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (on_the_picture(list) || command.UserCallback || command.GetTexID() != atlas.TexID)
                continue;
            for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
                const auto vertex = [&](unsigned k) -> const ImDrawVert& {
                    const int index = static_cast<int>(command.IdxOffset + i + k);
                    return list
                        .VtxBuffer[static_cast<int>(command.VtxOffset) + list.IdxBuffer[index]];
                };
                const ImDrawVert &a = vertex(0), &b = vertex(1), &c = vertex(2);
                if (plain(a) && plain(b) && plain(c)) continue;
                const float lo = std::min({a.pos.x, b.pos.x, c.pos.x});
                const float hi = std::max({a.pos.x, b.pos.x, c.pos.x});
                const float y = std::max({a.pos.y, b.pos.y, c.pos.y});
                if (y < command.ClipRect.y || y > command.ClipRect.w + 20)
                    continue; // scrolled away
                if (lo >= command.ClipRect.x - slack_px && hi <= command.ClipRect.z + slack_px)
                    continue;
                if (cut.glyphs++ == 0) {
                    cut.first = {lo, y};
                    cut.clip = command.ClipRect;
                }
            }
        }
    }
    return cut;
}

struct Size {
    const char* name;
    glm::ivec2 size_px;
    float scale;
};

class EveryPanel : public ::testing::TestWithParam<std::tuple<NamedScene, Size>> {
protected:
    void look(Rig& rig, const std::string& at)
    {
        ASSERT_NO_THROW(rig.frames(2)) << at;
        const CutText cut = cut_text();
        EXPECT_EQ(cut.glyphs, 0) << at << ": at " << cut.first.x << ", " << cut.first.y
                                 << " in a window from " << cut.clip.x << " to " << cut.clip.z;
    }
};

TEST_P(EveryPanel, IsDrawnAndCutsNoText)
{
    const auto& [scene, size] = GetParam();
    Rig rig(size.size_px, {.scale = size.scale});
    ImGui::GetStyle().AntiAliasedLinesUseTex = false; // lines are no glyphs
    rig.editor.session.replace_scene(scene.make());
    rig.wait();
    look(rig, "nothing selected");
    rig.editor.session.notices.clear();
    const auto ids = in_row_order(rig.editor.session.document());
    for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i) {
        rig.editor.session.selected = ids[i];
        look(rig, "inspector of " + std::to_string(ids[i]));
    }
    rig.editor.session.selected.set(ids);
    look(rig, "all selected");
    for (const auto tab : {Editor::Tab::history, Editor::Tab::log, Editor::Tab::inspector}) {
        rig.editor.tab = tab;
        look(rig, "tab " + std::to_string(static_cast<int>(tab)));
    }
    for (std::size_t tool = 0; tool < rig.editor.tools.size(); ++tool) {
        rig.editor.choose_tool(tool);
        look(rig, rig.editor.active_tool().name());
    }
    rig.editor.choose_tool(0);
    rig.editor.preferences.timeline_open = true;
    look(rig, "timeline");
    rig.editor.preferences.timeline_open = false;
    rig.editor.outliner.filter = "e";
    look(rig, "filter");
    rig.editor.outliner.filter.clear();
    rig.editor.palette.show();
    look(rig, "palette");
    rig.editor.palette.typed = ">";
    look(rig, "palette of objects");
    rig.editor.palette.show();
    begin_filling(rig.editor,
                  *form_of(SetMaterial{ids, {}}, "Set material", rig.editor.session.committed()));
    const std::size_t fields = rig.editor.palette.filling->form.fields.size();
    for (std::size_t i = 0; i < fields; ++i, next_field(rig.editor, 1)) look(rig, "filling values");
    leave_filling(rig.editor);
    rig.editor.palette.open = false;
    look(rig, "palette closed");
    for (int page = 0; page < PreferencesDialog::page_count; ++page) {
        rig.editor.preferences_dialog.open = true;
        rig.editor.preferences_dialog.page = page;
        look(rig, "preferences, page " + std::to_string(page));
    }
    rig.editor.preferences_dialog.open = false;
    rig.editor.memory.of<RecordDialog>().open = true;
    look(rig, "record");
    rig.editor.memory.of<RecordDialog>().open = false;
    for (const char* file : {"", "a.glb", "a.mdd"}) {
        rig.editor.memory.of<ExportDialog>().open = true;
        rig.editor.memory.of<ExportDialog>().plan.file = file;
        look(rig, "export frames to " + std::string(file));
    }
    rig.editor.memory.of<ExportDialog>().open = false;
    rig.editor.frames_export.reading = {"a.glb", std::vector<std::string>(40, "part 1 is bent")};
    look(rig, "what is not certified");
    rig.editor.frames_export.reading.reset();
    show_manual(rig.editor, "place");
    look(rig, "help");
}

std::string name_of_case(const ::testing::TestParamInfo<std::tuple<NamedScene, Size>>& of)
{
    return std::get<0>(of.param).name + "_" + std::get<1>(of.param).name;
}

const NamedScene typical{"typical", testing::typical_scene};
const NamedScene names{"names", testing::scene_of_long_names};
const NamedScene all_scenes[] = {
    {"empty", testing::empty_scene},          typical,
    {"broken", testing::broken_scene},        {"thousand", testing::scene_of_1000_objects},
    {"steps", testing::scene_of_10000_steps}, names};
const Size smallest{"smallest", {1024, 700}, 1}, usual{"usual", {1440, 900}, 1},
    twice{"twice", {2048, 1400}, 2}, large{"large", {1280, 800}, 2};

using ::testing::Combine, ::testing::Values, ::testing::ValuesIn;
INSTANTIATE_TEST_SUITE_P(Smallest, EveryPanel, Combine(ValuesIn(all_scenes), Values(smallest)),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Usual, EveryPanel, Combine(Values(names), Values(usual)), name_of_case);
INSTANTIATE_TEST_SUITE_P(Twice, EveryPanel, Combine(Values(typical), Values(twice)), name_of_case);
INSTANTIATE_TEST_SUITE_P(Large, EveryPanel, Combine(Values(typical), Values(large)), name_of_case);

} // namespace
} // namespace trivar
