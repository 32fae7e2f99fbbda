// SPDX-License-Identifier: GPL-3.0-or-later
// While an object stays selected, no edit of a value moves a row of the inspector.
#include "core/commands/command.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "tests/editor/scenes.h"
#include "tests/editor/volume_rig.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// How many there are of what one object is made of: to add one or to take one out is no edit of a
// value.
std::vector<std::size_t> counts(const Object& o)
{
    std::vector<std::size_t> out{o.shaping.size()};
    const auto add = [&](std::size_t one) { out.push_back(one); };
    if (o.tiles) add(o.tiles->strokes.size()), add(o.tiles->masks.size());
    if (o.cutting) add(o.cutting->cuts.size());
    if (o.incising) add(o.incising->cuts.size()), add(o.incising->layers.size());
    if (const auto* volume = std::get_if<VoxelShape>(&o.source))
        add(volume->levels.size()), add(volume->casting.points.size());
    return out;
}

struct Rows : testing::VolumeRig {
    // The inspector is tall; the timeline takes the height that the view need not have.
    Rows() : VolumeRig({500, 2600})
    {
        draw_small();
        editor.preferences.timeline_open = true;
        editor.preferences.timeline = 2600;
    }

    void select(const std::vector<Id>& ids)
    {
        editor.session.selected.set(ids);
        wait();
    }
    float label_x() const { return layout().inspector.lo.x + screen.theme().size.padding; }
    // The middle of each line of letters where rows have their labels, above the foot of the panel,
    // which notices may cover.
    std::vector<int> lines()
    {
        frames(1);
        const float lo = label_x(), hi = lo + screen.theme().size.label - 10;
        const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
        std::vector<bool> ink(static_cast<std::size_t>(size_px.y) + 1, false);
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int n = 0; n < drawn.CmdListsCount; ++n) {
            const ImDrawList& list = *drawn.CmdLists[n];
            if (!list._OwnerName || std::string_view(list._OwnerName) != "inspector") continue;
            for (int i = 0; i + 2 < list.IdxBuffer.Size; i += 3) {
                const ImDrawVert &a = list.VtxBuffer[list.IdxBuffer[i]],
                                 &b = list.VtxBuffer[list.IdxBuffer[i + 2]];
                if (a.uv.x == atlas.TexUvWhitePixel.x && a.uv.y == atlas.TexUvWhitePixel.y)
                    continue;
                if (a.pos.x < lo - 1 || b.pos.x > hi) continue;
                const float last = static_cast<float>(size_px.y) - 1;
                const float top = std::clamp(std::min(a.pos.y, b.pos.y), 0.0f, last),
                            end = std::clamp(std::max(a.pos.y, b.pos.y), 0.0f, last);
                for (auto y = static_cast<std::size_t>(top); y <= static_cast<std::size_t>(end);
                     ++y)
                    ink[y] = true;
            }
        }
        constexpr std::size_t foot = 200;
        std::vector<int> out;
        for (std::size_t y = 0; y + foot < ink.size(); ++y) {
            if (!ink[y]) continue;
            std::size_t end = y;
            while (end < ink.size() && ink[end]) ++end;
            out.push_back(static_cast<int>(y + end) / 2);
            y = end;
        }
        return out;
    }
    bool asks() const
    {
        return editor.files.asking() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    }
    // Whether each line of before is there, and no other.
    static bool same(const std::vector<int>& a, const std::vector<int>& b)
    {
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (std::abs(a[i] - b[i]) > 3) return false; // another letter may be higher
        return true;
    }
    // Does something to each row and looks whether one has moved.
    void edit_all(Id id)
    {
        const std::size_t began = steps();
        int edits = 0;
        const float field = label_x() + screen.theme().size.label;
        const float end = layout().inspector.hi.x - screen.theme().px(40);
        for (const int y : lines()) {
            for (const float x : {field + 14, end}) {
                const std::vector<int> before = lines();
                const std::vector<std::size_t> had = counts(object(editor.session.document(), id));
                const auto row = static_cast<float>(y);
                draw({{x, row}, {x + (x > field + 20 ? 0.0f : 34.0f), row}});
                if (asks()) { // a list: its third entry
                    click({x, row + 64});
                    for (int i = 0; i < 3 && asks(); ++i) key({ui::key_escape});
                }
                wait();
                if (!editor.session.document().objects.contains(id)) return;
                const std::vector<int> after = lines();
                const bool edited = steps() > began;
                if (edited && had == counts(object(editor.session.document(), id))) {
                    ++edits;
                    const auto [was, is] = std::ranges::mismatch(before, after);
                    EXPECT_TRUE(same(before, after))
                        << (was == before.end() ? -1 : *was) << " became "
                        << (is == after.end() ? -1 : *is) << ", at " << y << ": " << before.size()
                        << " and " << after.size() << " lines after "
                        << to_json_line(editor.session.scene().history().steps().back().command);
                }
                while (steps() > began) editor.session.undo();
                key({ui::key_escape});
                if (!edited && !same(before, lines())) click({x, row}); // it was unfolded
                wait();
            }
        }
        EXPECT_GT(edits, 8) << "the test means something";
    }
    // Opens the sections that are closed; their names begin further in.
    void open_sections()
    {
        for (int round = 0; round < 12; ++round) {
            const std::size_t had = lines().size();
            for (const int y : lines()) {
                click({label_x() + 30, static_cast<float>(y)});
                if (lines().size() > had) break; // one more is open
                if (lines().size() < had) click({label_x() + 30, static_cast<float>(y)});
            }
            if (lines().size() == had) return;
        }
    }
};

TEST(RowsStay, OfWhatIsPlaced)
{
    Rows rig;
    rig.editor.session.replace_scene(testing::typical_scene());
    rig.select({2});
    rig.open_sections();
    rig.edit_all(2);
}

TEST(RowsStay, OfTiles)
{
    Rows rig;
    ASSERT_TRUE(
        rig.editor.session.run(AddSphere{.shape = {.radius = 1, .segments = 8, .rings = 4}}));
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    ASSERT_TRUE(
        rig.editor.session.run(CoverWithTiles{2, 1, {.pattern = TilePattern::grid, .size = 0.5}}));
    MaskTiles mask{.object = 2};
    mask.mask.from = MaskFrom::line;
    ASSERT_TRUE(rig.editor.session.run(mask));
    rig.select({2});
    rig.open_sections();
    rig.edit_all(2);
}

TEST(RowsStay, OfCutsAndIncisions)
{
    Rows rig;
    ASSERT_TRUE(rig.editor.session.run(AddSphere{.shape = {.radius = 1}}));
    NamedIncision incision;
    for (int i = -4; i <= 4; ++i) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.12 * i, -1, 0.1));
        incision.cut.stroke.push_back({n, n});
    }
    ASSERT_TRUE(rig.editor.session.run(Incise{1, incision}));
    ASSERT_TRUE(rig.editor.session.run(
        CutThrough{{1}, {.cuts = {{.point = {0, 0, -0.5}, .normal = {0, 0, 1}}}}}));
    rig.select({1});
    rig.editor.session.incision = {1, 1};
    rig.open_sections();
    rig.edit_all(1);
}

TEST(RowsStay, OfVolumeData)
{
    Rows rig;
    rig.add_ball({40});
    rig.open_sections();
    rig.edit_all(rig.editor.session.selected);
}

} // namespace
} // namespace trivar
