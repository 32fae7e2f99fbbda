// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/lattice.h"
#include "core/document/document_digest.h"
#include "core/scene/scene_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"

#include <array>
#include <filesystem>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder, testing::write_file;

// The branches of a history with all that is in them, whatever their order.
std::string tree_of(const std::vector<History::Step>& steps,
                    const std::vector<History::Branch>& branches, std::size_t before = 0)
{
    std::string out;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const History::Branch& each : branches)
            if (each.from == before + i)
                out += "(" + tree_of(each.steps, each.others, each.from) + ")";
        out += std::string(verb(steps[i].command)) + " ";
    }
    return out;
}

TEST(SceneFile, RefusesToBeGivenAStepAnewThatAnOlderSceneHoldsAndThatDoesNothing)
{
    const TemporaryFolder folder;
    const std::string stored =
        read_text_file(TRIVAR_SOURCE_DIR "/tests/logs/versions/1_steps_without_effect.trivar");
    write_file(folder.file("a.trivar"), stored);
    SceneFile scene(folder.file("a.trivar"));
    const std::vector<History::Step> steps = scene.history().steps();
    const std::string before = digest(scene.document());
    int refused = 0;
    for (const History::Step& step : steps) {
        if (!step.command.is<MovePoints>() && !step.command.is<CoarsenVolume>() &&
            !step.command.is<InsertKnots>())
            continue;
        EXPECT_THROW(scene.run(step.command), Rejected);
        EXPECT_THROW(scene.propose(step.command), Rejected);
        ++refused;
    }
    EXPECT_EQ(refused, 4);
    EXPECT_EQ(digest(scene.document()), before);
    EXPECT_EQ(read_text_file(folder.file("a.trivar")), stored);
}

TEST(SceneFile, GoesBackToABranchThatBeginsWithAStepWithoutEffect)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.trivar"), log_header() + command_line(AddBox{}) +
                                            command_line(AddLattice{.objects = {1}}) +
                                            command_line(CoarsenVolume{2, {VolumeAxis::up, 4}}) +
                                            undo_line() + command_line(AddSphere{}) + undo_line());
    SceneFile scene(folder.file("a.trivar"));
    EXPECT_NO_THROW(scene.run(scene.history().branches().front().steps.front().command));
    EXPECT_EQ(object(scene.document(), 2).shaping.size(), 1u);
}

TEST(SceneFile, RewritesThePathsOfABranchInAnotherFolder)
{
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"}) std::filesystem::create_directory(folder.file(name));
    SceneFile scene;
    scene.save_as(folder.file("a/scene.trivar"));
    ImportModel import;
    import.file.path = "snail.obj";
    scene.run(import);
    scene.undo();
    scene.run(AddBox{}); // no step in force names a file
    scene.save_as(folder.file("b/scene.trivar"));
    const SceneFile again(folder.file("b/scene.trivar"));
    ASSERT_EQ(again.history().branches().size(), 1u);
    const History::Step& step = again.history().branches().front().steps.front();
    EXPECT_EQ(step.command.get<ImportModel>().file.path, "../a/snail.obj");
}

TEST(SceneFile, KeepsTheUndoneBranchesWhenItGetsItsName)
{
    const TemporaryFolder folder;
    SceneFile scene;
    scene.run(AddBox{});
    scene.undo();
    scene.run(AddSphere{});
    scene.run(AddTorus{});
    scene.run(AddPlane{});
    scene.undo();
    scene.undo();
    scene.run(AddCylinder{}); // leaves torus and plane
    scene.undo();
    scene.run(AddMoebius{});
    scene.run(AddBox{});
    scene.undo();
    const std::string tree = tree_of(scene.history().steps(), scene.history().branches());
    EXPECT_EQ(tree,
              "(add_box )add_sphere (add_torus add_plane )(add_cylinder )add_moebius add_box ");
    const std::string before = digest(scene.document());
    scene.save_as(folder.file("a.trivar"));
    EXPECT_EQ(tree_of(scene.history().steps(), scene.history().branches()), tree);
    scene = SceneFile();
    const SceneFile again(folder.file("a.trivar"));
    EXPECT_EQ(tree_of(again.history().steps(), again.history().branches()), tree);
    EXPECT_EQ(again.history().position(), 2u);
    EXPECT_EQ(digest(again.document()), before);
}

TEST(SceneFile, ReplayedFromItsFileHasTheBranchesAgain)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("scene.trivar");
    SceneFile scene;
    scene.save_as(path);
    scene.run(AddBox{});
    scene.run(AddSphere{});
    scene.undo();
    scene.run(AddTorus{});
    scene.undo();
    scene.run(AddSphere{}); // back on the first
    const std::string now = digest(scene.document());
    scene = SceneFile();
    const SceneFile again(path);
    EXPECT_EQ(digest(again.document()), now);
    ASSERT_EQ(again.history().branches().size(), 1u);
    EXPECT_EQ(verb(again.history().branches()[0].steps[0].command), "add_torus");
}

TEST(SceneFile, IsAnOrdinaryFile)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    for (const std::string& path :
         {folder.file("pipe"), std::string("/dev/zero"), folder.path().string()}) {
        const auto refused = ::testing::ThrowsMessage<Rejected>(HasSubstr("not an ordinary file"));
        EXPECT_THAT([&] { SceneFile scene(path); }, refused);
        EXPECT_THAT([&] { SceneFile::copy_of(path); }, refused);
        EXPECT_THAT([&] { SceneFile::looked_at(path); }, refused);
        EXPECT_THAT([&] { SceneFile().save_as(path); }, refused);
    }
}

TEST(SceneFile, TellsItsLinesAsTheyStandInTheFile)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    const auto text_of = [](const SceneFile& scene) {
        std::string text;
        for (const std::string& line : scene.lines()) text += line + "\n";
        return text;
    };
    SceneFile scene;
    EXPECT_EQ(text_of(scene), log_header());
    scene.run(AddBox{});
    scene.undo();
    EXPECT_EQ(text_of(scene), log_header() + command_line(AddBox{}) + undo_line());
    scene.save_as(path);
    scene.redo();
    EXPECT_EQ(text_of(scene), read_text_file(path));
    EXPECT_EQ(text_of(SceneFile::copy_of(path)), read_text_file(path));
    scene.run(AddSphere{});
    scene.undo();
    scene.save_compact(path);
    EXPECT_EQ(text_of(scene), log_header() + command_line(AddBox{}));
}

TEST(SceneFile, HoldsEachStepTheMomentItIsCommitted)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    SceneFile scene;
    scene.run(AddBox{});
    scene.save_as(path);
    scene.run(AddSphere{});
    scene.undo();
    EXPECT_EQ(scene.trouble(), "");
    EXPECT_EQ(read_text_file(path),
              log_header() + command_line(AddBox{}) + command_line(AddSphere{}) + undo_line());
    scene.propose(AddTorus{});
    EXPECT_THAT(read_text_file(path), ::testing::Not(HasSubstr("add_torus")));
}

TEST(SceneFile, OpensWithItsUndoneStepsStillThere)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    {
        SceneFile scene;
        scene.save_as(path);
        scene.run(AddBox{});
        scene.run(AddSphere{});
        scene.undo();
    }
    SceneFile scene(path);
    EXPECT_EQ(scene.document().objects.size(), 1u);
    EXPECT_TRUE(scene.redo());
    EXPECT_EQ(scene.document().objects.size(), 2u);
    EXPECT_TRUE(scene.notices().empty());
}

TEST(SceneFile, SavesCompactWithoutWhatIsUndone)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    SceneFile scene;
    scene.run(AddBox{});
    scene.run(AddSphere{});
    scene.undo();
    const Ref<Object> box = scene.document().objects.at(1);
    scene.save_as(path);
    scene.save_compact(path);
    EXPECT_EQ(read_text_file(path), log_header() + command_line(AddBox{}));
    EXPECT_FALSE(scene.redo());
    EXPECT_EQ(scene.document().objects.at(1), box);
    scene.run(AddTorus{});
    EXPECT_EQ(SceneFile(path).document().objects.size(), 2u);
}

TEST(SceneFile, OpenedTwiceIsACopyTheSecondTime)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    SceneFile first;
    first.run(AddBox{});
    first.save_as(path);
    const std::string before = read_text_file(path);
    SceneFile second(path);
    EXPECT_EQ(second.path(), "");
    ASSERT_EQ(second.notices().size(), 1u);
    EXPECT_THAT(second.notices().front(), HasSubstr("copy"));
    second.run(AddSphere{});
    EXPECT_EQ(read_text_file(path), before);
    EXPECT_THROW(second.save_as(path), Rejected);
    EXPECT_EQ(read_text_file(path), before);
    first = SceneFile();
    EXPECT_EQ(SceneFile(path).path(), path);
}

TEST(SceneFile, ACopyLeavesItsOriginalAsItIsAndIsKeptFromItsFirstStep)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar"), kept = folder.file("unnamed");
    const std::string text = log_header() + command_line(AddBox{});
    write_file(path, text);
    SceneFile scene = SceneFile::copy_of(path);
    scene.keep_in(kept);
    EXPECT_EQ(scene.path(), "");
    EXPECT_EQ(scene.original(), path);
    EXPECT_TRUE(scene.as_opened());
    EXPECT_FALSE(std::filesystem::exists(kept)); // nothing was done yet
    scene.run(AddSphere{});
    EXPECT_FALSE(scene.as_opened());
    EXPECT_EQ(read_text_file(path), text);
    EXPECT_EQ(read_text_file(std::filesystem::directory_iterator(kept)->path().string()),
              text + command_line(AddSphere{}));
    scene.save_as(folder.file("b.trivar"));
    EXPECT_EQ(scene.original(), "");
}

TEST(SceneFile, ACopyCanBeLookedAtStepByStepAndIsStillAsOpened)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path,
               log_header() + command_line(AddBox{}, "first") + command_line(AddTorus{}, "then"));
    SceneFile scene = SceneFile::copy_of(path);
    scene.keep_in(folder.file("kept"));
    scene.look_at(1);
    EXPECT_EQ(scene.document().objects.size(), 1u);
    EXPECT_TRUE(scene.as_opened());
    EXPECT_FALSE(std::filesystem::exists(folder.file("kept")));
    scene.run(AddSphere{}); // from here on it is a scene like any other, with its notes
    EXPECT_EQ(scene.history().steps().size(), 2u);
    EXPECT_EQ(scene.history().steps()[0].note, "first");
    std::string lines;
    for (const std::string& line : scene.lines()) lines += line + "\n";
    EXPECT_EQ(replay(read_log(lines, "lines")).document().objects.size(), 2u);
    scene.look_at(0);
    EXPECT_EQ(scene.document().objects.size(), 2u);
}

TEST(SceneFile, NamesTheFilesOfModelsFromItsNewFolder)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("v2"));
    SceneFile scene;
    scene.save_as(folder.file("a.trivar"));
    ImportModel import;
    import.file.path = "models/a.obj";
    scene.run(import);
    EditImport edit{1, import.file};
    edit.file.subdivisions = 2;
    scene.run(edit);
    scene.save_as(folder.file("v2/a.trivar"));
    const auto path_now = [&] {
        return std::get<ImportedFile>(object(scene.history().document(), 1).source).path;
    };
    EXPECT_EQ(path_now(), "../models/a.obj");
    scene.undo();
    EXPECT_EQ(path_now(), "../models/a.obj");
}

TEST(SceneFile, OpenInAnotherProgramIsACopyThatCannotBeSavedOverIt)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, log_header() + command_line(AddBox{}));
    std::array<int, 2> opened{}, done{};
    ASSERT_EQ(::pipe(opened.data()), 0);
    ASSERT_EQ(::pipe(done.data()), 0);
    const pid_t other = ::fork();
    if (other == 0) { // has it open till it is told to end
        char c = 0;
        const SceneFile scene(path);
        const bool ours = scene.path() == path;
        if (::write(opened[1], &c, 1) != 1 || ::read(done[0], &c, 1) != 1) ::_exit(2);
        ::_exit(ours ? 0 : 1);
    }
    char c = 0;
    ASSERT_EQ(::read(opened[0], &c, 1), 1);
    SceneFile scene(path);
    EXPECT_EQ(scene.path(), "");
    EXPECT_EQ(scene.original(), path);
    EXPECT_THAT(scene.notices().front(), HasSubstr("is open in another Trivar"));
    scene.run(AddSphere{});
    EXPECT_THROW(scene.save_as(path), Rejected);
    ASSERT_EQ(::write(done[1], &c, 1), 1);
    int status = -1;
    ::waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    scene.save_as(path); // nobody has it now
    EXPECT_EQ(SceneFile::copy_of(path).history().steps().size(), 2u);
    for (const int end : {opened[0], opened[1], done[0], done[1]}) ::close(end);
}

TEST(SceneFile, SavesACopyAndGoesOnWhereItIs)
{
    const TemporaryFolder folder;
    SceneFile scene;
    scene.run(AddBox{});
    scene.save_as(folder.file("a.trivar"));
    scene.save_copy(folder.file("b.trivar"));
    scene.run(AddSphere{});
    EXPECT_EQ(scene.path(), folder.file("a.trivar"));
    EXPECT_EQ(SceneFile::copy_of(folder.file("b.trivar")).history().steps().size(), 1u);
    EXPECT_THROW(scene.save_copy(folder.file("b.trivar")), Rejected);
}

TEST(SceneFile, RewritesPathsWhenItIsSavedInAnotherFolder)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "scenes");
    SceneFile scene;
    scene.save_as(folder.file("a.trivar"));
    ImportModel import;
    import.file.path = "models/snail.obj";
    scene.run(import);
    scene.save_as(folder.file("scenes/a.trivar"));
    EXPECT_EQ(std::get<ImportedFile>(object(scene.document(), 1).source).path,
              "../models/snail.obj");
    EXPECT_EQ(scene.folder(), (folder.path() / "scenes").string());
}

TEST(SceneFile, RefusesWhatIsNoSceneFileByName)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.trivar"), "no");
    EXPECT_THROW(SceneFile(folder.file("a.trivar")), Rejected);
    EXPECT_THROW(SceneFile(folder.file("missing.trivar")), Rejected);
    EXPECT_THROW(SceneFile(folder.path().string()), Rejected);
    EXPECT_THROW(SceneFile("/dev/zero"), Rejected);
}

} // namespace
} // namespace trivar
