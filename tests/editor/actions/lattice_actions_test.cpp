// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "core/commands/objects/shape.h"
#include "core/evaluation/evaluate.h"
#include "editor/actions/lattice_actions.h"

#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/scene/kept_scenes.h"
#include "editor/actions/actions.h"
#include "editor/hands/lattice_round.h"
#include "editor/session/outline.h"
#include "tests/editor/boxes.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;

// Box 1 in lattice 3, box 2 beside it.
struct InALattice : testing::Boxes {
    explicit InALattice(const std::string& unnamed_folder = {}) : Boxes(unnamed_folder)
    {
        EXPECT_TRUE(editor.session.run(
            AddLattice{.objects = {1}, .shape = {.size = {2, 2, 2}}, .transform = of(1)}));
        EXPECT_TRUE(editor.session.run(
            MovePoints{3, {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0, 0, 0.4}}}));
        wait();
    }
    void run(const char* name)
    {
        ASSERT_TRUE(is_enabled(editor, action(editor, name)));
        action(editor, name).run(editor);
        wait();
    }
    bool can(const char* name) { return is_enabled(editor, action(editor, name)); }
    Id parent_of(Id id) const { return object(editor.session.document(), id).parent; }
    double top(Id id) const { return editor.session.evaluated().objects.at(id)->bounds->hi.z; }
};

TEST(LatticeActions, AddWhatIsSelectedBesideALatticeToIt)
{
    InALattice rig;
    rig.editor.session.selected = 2;
    EXPECT_FALSE(rig.can(add_to_lattice_action));
    rig.editor.session.selected.set({2, 3});
    rig.run(add_to_lattice_action);
    EXPECT_EQ(rig.parent_of(2), 3);
    EXPECT_FALSE(rig.can(add_to_lattice_action)) << "it is in there already";
}

TEST(LatticeActions, TakeAMemberOutToWhereItStandsUnbent)
{
    InALattice rig;
    EXPECT_GT(rig.top(1), 0.51);
    rig.editor.session.selected = 1;
    rig.run(take_out_of_lattice_action);
    EXPECT_EQ(rig.parent_of(1), 0);
    EXPECT_NEAR(rig.top(1), 0.5, 1e-6);
    EXPECT_FALSE(rig.can(take_out_of_lattice_action));
}

TEST(LatticeActions, DeleteALatticeAndLeaveItsMembersUnbentInOneStep)
{
    InALattice rig;
    rig.editor.session.selected = 3;
    const std::size_t before = rig.steps();
    rig.run(back_to_rest_action);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_FALSE(rig.editor.session.document().objects.contains(3));
    EXPECT_NEAR(rig.top(1), 0.5, 1e-6);
    EXPECT_THAT(rig.editor.session.selected.ids(), ElementsAre(1)) << "what was freed";
    rig.editor.session.undo();
    rig.wait();
    EXPECT_GT(rig.top(1), 0.51);
    EXPECT_THAT(rig.editor.session.selected.ids(), ElementsAre(3));
    rig.editor.session.redo();
    EXPECT_THAT(rig.editor.session.selected.ids(), ElementsAre(1));
}

TEST(LatticeActions, PutANewLatticeWhereItsFirstMemberStoodInTheOutliner)
{
    testing::Boxes rig;
    rig.editor.session.selected = 1;
    action(rig.editor, lattice_action).run(rig.editor);
    EXPECT_THAT(in_row_order(rig.editor.session.document()), ElementsAre(3, 1, 2));
}

TEST(LatticeActions, KeepTheShapeOfMembersInFilesWhenALatticeIsDeleted)
{
    InALattice rig;
    rig.editor.session.selected = 3;
    EXPECT_FALSE(rig.can(keep_shape_action)) << "the scene has no folder yet";
    const testing::TemporaryFolder folder;
    rig.editor.session.save_as(folder.file("scene.trivar"));
    rig.wait();
    const Box before = *rig.editor.session.evaluated().objects.at(1)->bounds;
    const std::size_t steps = rig.steps();
    rig.run(keep_shape_action);
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_FALSE(rig.editor.session.document().objects.contains(3));
    const auto* file = std::get_if<ImportedFile>(&object(rig.editor.session.document(), 1).source);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->path, "Box kept_001.glb");
    const Box after = *rig.editor.session.evaluated().objects.at(1)->bounds;
    EXPECT_LT(glm::length(after.lo - before.lo) + glm::length(after.hi - before.hi), 1e-5);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.editor.session.document().objects.contains(3));
}

// All files in a folder and in its folders, without the signs that a program is at work there.
std::vector<std::string> files_in(const std::filesystem::path& folder)
{
    std::vector<std::string> out;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder))
        if (!each.path().filename().string().starts_with("life-sign"))
            out.push_back(each.path().lexically_relative(folder).string());
    std::ranges::sort(out);
    return out;
}

// Box 1 kept its shape in a scene without a name.
struct KeptWithoutAName : InALattice {
    explicit KeptWithoutAName(const std::string& unnamed_folder) : InALattice(unnamed_folder)
    {
        editor.session.selected = 3;
        run(keep_shape_action);
    }
    std::string effects() const { return digest(editor.session.evaluated()); }
    std::string path() const
    {
        return std::get<ImportedFile>(object(editor.session.document(), 1).source).path;
    }
};

TEST(LatticeActions, KeepTheShapeInASceneWithoutANameAndBringItsFileAlongWhenItGetsOne)
{
    const testing::TemporaryFolder unnamed, folder;
    std::string effects, causes;
    {
        KeptWithoutAName rig(unnamed.path().string());
        ASSERT_TRUE(rig.path().ends_with(" kept shapes/Box kept_001.glb")) << rig.path();
        effects = rig.effects();
        rig.editor.session.undo();
        rig.wait();
        EXPECT_NE(rig.effects(), effects);
        rig.editor.session.redo();
        rig.wait();
        EXPECT_EQ(rig.effects(), effects);
        rig.editor.session.save_as(folder.file("scene.trivar"));
        rig.wait();
        EXPECT_EQ(rig.effects(), effects);
        EXPECT_EQ(rig.path(), "Box kept_001.glb");
        causes = digest(rig.editor.session.document());
        EXPECT_THAT(files_in(folder.path()), ElementsAre("Box kept_001.glb", "scene.trivar"));
        EXPECT_THAT(files_in(unnamed.path()), IsEmpty());
    }
    testing::Rig again;
    again.editor.session.replace_scene(SceneFile(folder.file("scene.trivar")));
    again.wait();
    EXPECT_EQ(digest(again.editor.session.document()), causes);
    EXPECT_EQ(digest(again.editor.session.evaluated()), effects);
    again.editor.session.undo();
    again.wait();
    EXPECT_TRUE(again.editor.session.document().objects.contains(3));
}

TEST(LatticeActions, WriteAShapeOnceHoweverOftenItIsKept)
{
    const testing::TemporaryFolder unnamed;
    KeptWithoutAName rig(unnamed.path().string());
    const std::vector<std::string> once = files_in(unnamed.path());
    rig.editor.session.undo();
    rig.wait();
    rig.editor.session.selected = 3;
    rig.run(keep_shape_action);
    EXPECT_EQ(files_in(unnamed.path()), once);
    rig.editor.session.undo();
    rig.wait();
    ASSERT_TRUE(rig.editor.session.run(
        MovePoints{3, {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0, 0, 0.1}}}));
    rig.wait();
    rig.editor.session.selected = 3;
    rig.run(keep_shape_action);
    EXPECT_EQ(files_in(unnamed.path()).size(), once.size() + 1);
    EXPECT_TRUE(rig.path().ends_with("Box kept_002.glb"));
}

TEST(LatticeActions, TakeAFreeNameForAShapeThatAnotherFilesNameIsInTheWayOf)
{
    const testing::TemporaryFolder unnamed, folder;
    testing::write_file(folder.file("Box kept_001.glb"), "another");
    KeptWithoutAName rig(unnamed.path().string());
    const std::string effects = rig.effects();
    rig.editor.session.save_as(folder.file("scene.trivar"));
    rig.wait();
    EXPECT_EQ(rig.path(), "Box kept_002.glb");
    EXPECT_EQ(rig.effects(), effects);
    EXPECT_EQ(read_text_file(folder.file("Box kept_001.glb")), "another");
}

TEST(LatticeActions, FindAKeptShapeAgainAfterACrashAndAfterTheSceneWasDiscarded)
{
    const testing::TemporaryFolder unnamed, killed;
    std::string effects;
    {
        KeptWithoutAName rig(unnamed.path().string());
        effects = rig.effects();
        std::filesystem::copy(unnamed.path(), killed.path(),
                              std::filesystem::copy_options::recursive);
    }
    for (const std::filesystem::path& folder : {killed.path(), unnamed.path()}) {
        const std::string where = folder.string();
        testing::Rig rig({720, 520}, {}, where);
        const std::string scene = folder == killed.path() ? SceneFile::left_in(where).value()
                                                          : SceneFile::set_aside_in(where).front();
        rig.editor.session.replace_scene(SceneFile::taken_up(scene));
        rig.wait();
        EXPECT_EQ(digest(rig.editor.session.evaluated()), effects);
        const std::string named = (folder / "named/scene.trivar").string();
        std::filesystem::create_directory(folder / "named");
        rig.editor.session.save_as(named);
        rig.wait();
        EXPECT_EQ(digest(rig.editor.session.evaluated()), effects);
        EXPECT_THAT(files_in(folder),
                    ElementsAre("named", "named/Box kept_001.glb", "named/scene.trivar"));
    }
}

TEST(LatticeActions, ForgetAKeptShapeWithTheDiscardedSceneThatNamedIt)
{
    const testing::TemporaryFolder unnamed;
    const std::string where = unnamed.path().string();
    {
        const KeptWithoutAName rig(where);
        forget_old_scenes(where, std::chrono::hours(0));
        EXPECT_EQ(files_in(unnamed.path()).size(), 3u) << "it is open";
    }
    forget_old_scenes(where, std::chrono::days(30));
    EXPECT_EQ(files_in(unnamed.path()).size(), 3u) << "it can be brought back";
    const std::string discarded = SceneFile::set_aside_in(where).front();
    const std::string other = unnamed.file("untitled-other.trivar");
    std::filesystem::copy_file(discarded, other);
    std::filesystem::last_write_time(discarded, std::filesystem::file_time_type::clock::now() -
                                                    std::chrono::days(31));
    forget_old_scenes(where, std::chrono::days(30));
    EXPECT_EQ(files_in(unnamed.path()).size(), 3u) << "another scene has it too";
    std::filesystem::remove(other);
    forget_old_scenes(where, std::chrono::days(30));
    EXPECT_THAT(files_in(unnamed.path()), IsEmpty());
}

TEST(LatticeActions, AreNeededNoMoreThanADropOnALatticesRow)
{
    InALattice rig;
    const Document& d = rig.editor.session.document();
    const auto rows = outline(d, "", {}); // 2 3 1
    ASSERT_EQ(rows.at(1).id, 3);
    const RowDrop drop = row_drop(d, rows, {2}, 1.5);
    EXPECT_THAT(drop.command.objects, ElementsAre(2));
    EXPECT_EQ(drop.command.parent, 3);
}

TEST(LatticeActions, PutALatticeRoundWhatIsFlat)
{
    testing::Rig rig;
    rig.two_objects();
    rig.editor.session.selected = 1; // the plane
    action(rig.editor, "Lattice round selection").run(rig.editor);
    rig.wait();
    EXPECT_GT(std::get<LatticeShape>(object(rig.editor.session.document(), 3).source).size.z, 0);
    EXPECT_EQ(rig.editor.active_tool().name(), "Lattice");
}

TEST(LatticeActions, KeepTheCurvesOfAMemberAsTheyAreBent)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("line.obj"), "v 0 0 0\nv 0.2 0 0\nv 0.2 0.5 0\nl 1 2 3\n");
    InALattice rig;
    ImportModel import;
    import.file.path = folder.file("line.obj");
    import.transform = object(rig.editor.session.document(), 1).transform;
    ASSERT_TRUE(rig.editor.session.run(import));
    rig.editor.session.selected.set({4, 3});
    rig.run(add_to_lattice_action);
    rig.editor.session.save_as(folder.file("a.trivar"));
    rig.wait();
    const auto points = [&] {
        return in_world(rig.editor.session.evaluated().objects.at(4)->curves.at(0))
            .points->positions;
    };
    const std::vector<glm::vec3> bent = points();
    rig.editor.session.selected = 3;
    rig.run(keep_shape_action);
    ASSERT_FALSE(rig.editor.session.document().objects.contains(3));
    for (std::size_t i = 0; i < bent.size(); ++i)
        EXPECT_LT(glm::distance(points().at(i), bent[i]), 1e-6f);
}

} // namespace
} // namespace trivar
