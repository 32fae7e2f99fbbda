// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/voxels.h"
#include "core/scene_lines/line_sheet.h"

#include "core/base/text.h"
#include "core/scene/history.h"
#include "editor/session/session_facts.h"
#include "tests/editor/volume_rig.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

struct SheetRig : testing::VolumeRig {
    DrawingSheet sheet() const
    {
        return line_sheet(editor.session.evaluated(), editor.session.document(),
                          camera_for_pictures(editor.session))
            .sheet;
    }
};

TEST(LineSheets, HaveALayerForEachLevelAndEachKindOfLine)
{
    SheetRig rig;
    rig.add_ball({30, 60});
    SetVoxels without_surfaces{1, rig.shape()}; // that of the outer level hides the inner one
    for (VoxelLevel& level : without_surfaces.shape.levels) level.surface = false;
    EXPECT_TRUE(rig.editor.session.run(without_surfaces));
    EXPECT_TRUE(rig.editor.session.run(AddBox{}));
    EXPECT_TRUE(rig.editor.session.run(SetLineDrawing{{2}, {}}));
    rig.wait();
    std::vector<std::string> names;
    for (const DrawingLayer& layer : rig.sheet().layers) {
        names.push_back(layer.name);
        EXPECT_FALSE(layer.lines.empty());
    }
    EXPECT_THAT(names, ::testing::Contains(HasSubstr("Level 30")));
    EXPECT_THAT(names, ::testing::Contains(HasSubstr("Level 60")));
    EXPECT_THAT(names, ::testing::Contains(HasSubstr("Box: ")));
}

TEST(LineSheets, AreExportedAsFilesOfLines)
{
    SheetRig rig;
    rig.add_ball({50});
    const std::string svg = rig.folder.file("ball.svg");
    rig.editor.files.ask_export(svg);
    rig.frames(2);
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NE(read_text_file(svg).find("inkscape:label=\"ball: Level 50\""), std::string::npos);
}

TEST(LineSheets, KeepWhatAHandDidToTheFileThatTheyReplace)
{
    SheetRig rig;
    rig.add_ball({50, 70});
    const std::string svg = rig.folder.file("ball.svg"), own = "<path id=\"ball--Level-50-s";
    const auto draw = [&] {
        rig.editor.files.write_model_to(svg, false);
        rig.wait();
        return read_text_file(svg);
    };
    std::string text = draw();
    const std::size_t first = text.find(own);
    ASSERT_NE(first, text.npos);
    text.erase(first, text.find('\n', first) - first);
    ASSERT_EQ(text.find(own), text.npos);
    testing::write_file(svg, text);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(draw().find(own), text.npos);
    std::filesystem::remove(svg);
    EXPECT_NE(draw().find(own), text.npos);
}

TEST(LineSheets, KeepWhatAPersonAddedToTheFileThatTheyReplace)
{
    SheetRig rig;
    rig.add_ball({50, 70});
    const std::string svg = rig.folder.file("ball.svg");
    const auto draw = [&] {
        rig.editor.files.write_model_to(svg, false);
        rig.wait();
        return read_text_file(svg);
    };
    const std::string label = "<text x=\"9\" y='9'>Vena  cava</text><!-- mine -->\n";
    std::string text = draw();
    text.insert(text.find("<path"), label);
    testing::write_file(svg, text);
    EXPECT_EQ(draw(), text);
    rig.editor.session.view.camera.size_px = {400, 300};
    EXPECT_NE(draw().find(label), std::string::npos);
}

TEST(LineSheets, AreNotWrittenOverAFileThatCannotBeRead)
{
    SheetRig rig;
    rig.add_ball({50});
    const std::string svg = rig.folder.file("ball.svg"),
                      broken = "<svg><desc id=\"trivar-lines\"/><g>";
    testing::write_file(svg, broken);
    rig.editor.files.write_model_to(svg, false);
    rig.wait();
    EXPECT_EQ(read_text_file(svg), broken);
    EXPECT_THAT(rig.editor.session.notices.all().back().body, HasSubstr("delete it first"));
}

} // namespace
} // namespace trivar
