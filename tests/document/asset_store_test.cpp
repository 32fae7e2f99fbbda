// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "core/document/asset_store.h"

#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/evaluation/evaluate.h"
#include "core/files/file_bytes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;
using testing::TemporaryFolder, testing::write_file;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

ImportedFile file(const std::string& path, const std::string& hash = "")
{
    ImportedFile result;
    result.path = path;
    result.hash = hash;
    return result;
}

TEST(AssetStore, ReadsAFileOnce)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.obj"), triangle);
    const AssetStore assets(folder.path().string());
    const AssetStore::LoadedModel first = assets.load(file("a.obj"));
    ASSERT_TRUE(first.model);
    EXPECT_EQ(assets.load(file("a.obj")).model, first.model);
}

TEST(AssetStore, SaysThatAFileIsMissingAndFindsItWhenItIsBack)
{
    const TemporaryFolder folder;
    const AssetStore assets(folder.path().string());
    const AssetStore::LoadedModel missing = assets.load(file("a.obj"));
    EXPECT_FALSE(missing.model);
    ASSERT_EQ(missing.notices.size(), 1u);
    EXPECT_THAT(missing.notices.front(), HasSubstr("a.obj"));
    write_file(folder.file("a.obj"), triangle);
    EXPECT_TRUE(assets.load(file("a.obj")).model);
}

TEST(AssetStore, SaysThatTheContentIsNotTheOneThatWasMeant)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.obj"), triangle);
    const std::string meant = file_hash(folder.file("a.obj"));
    EXPECT_THAT(AssetStore(folder.path().string()).load(file("a.obj", meant)).notices, IsEmpty());
    write_file(folder.file("a.obj"), square);
    const AssetStore::LoadedModel changed =
        AssetStore(folder.path().string()).load(file("a.obj", meant));
    EXPECT_TRUE(changed.model);
    ASSERT_EQ(changed.notices.size(), 1u);
    EXPECT_THAT(changed.notices.front(), HasSubstr("changed"));
}

TEST(AssetStore, RelinksByPathAndByName)
{
    const AssetStore assets("/scenes", {{"a.obj", "/other/b.obj"}, {"models/c.obj", "d.obj"}});
    EXPECT_EQ(assets.resolve("deep/a.obj"), "/other/b.obj");
    EXPECT_EQ(assets.resolve("models/c.obj"), "d.obj");
    EXPECT_EQ(assets.resolve("models/e.obj"), "/scenes/models/e.obj");
    EXPECT_EQ(assets.resolve("/e.obj"), "/e.obj");
}

TEST(Prepare, FillsInHashNameAndARelativePath)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "models");
    write_file(folder.file("models/snail.obj"), triangle);
    const AssetStore assets(folder.path().string());
    ImportModel import;
    import.file.path = folder.file("models/snail.obj");
    const auto prepared = prepare(import, assets).get<ImportModel>();
    EXPECT_EQ(prepared.file.path, "models/snail.obj");
    EXPECT_EQ(prepared.file.hash, file_hash(folder.file("models/snail.obj")));
    EXPECT_EQ(prepared.name, "snail");
}

TEST(Prepare, RefusesAFileThatCannotBeRead)
{
    const TemporaryFolder folder;
    write_file(folder.file("bad.obj"), "f 1 2 3\n");
    const AssetStore assets(folder.path().string());
    for (const char* name : {"bad.obj", "missing.obj", "."}) {
        ImportModel import;
        import.file.path = name;
        EXPECT_THROW(prepare(import, assets), Rejected) << name;
    }
}

TEST(Evaluator, SubdividesImportedCages)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.obj"), square);
    ImportModel import;
    import.file.path = "a.obj";
    import.file.subdivisions = 2;
    Evaluator evaluate(std::make_shared<const AssetStore>(folder.path().string()));
    const Evaluation result = evaluate(after({}, import));
    ASSERT_EQ(result.objects.at(1)->parts.size(), 1u);
    EXPECT_EQ(result.objects.at(1)->parts.front().mesh()->face_count(), 16u);
}

} // namespace
} // namespace trivar
