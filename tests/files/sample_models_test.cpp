// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

// A program in a folder of its own, with the maker of models beside it.
struct Beside {
    testing::TemporaryFolder folder;
    fs::path program = folder.path() / "trivar", models = folder.path() / "assets" / "models";
    Beside()
    {
        fs::create_symlink(part_of(this_program(), "trivar-make"), folder.path() / "trivar-make");
    }
};

TEST(MissingModels, AreMadeOnce)
{
    const Beside here;
    const fs::path file = here.models / "tile_scale.glb";
    EXPECT_TRUE(can_be_made(file, here.program));
    make_sample_model(file, {}, here.program);
    ASSERT_TRUE(fs::exists(file));
    EXPECT_GT(fs::file_size(file), 1000u);
    EXPECT_FALSE(can_be_made(file, here.program));
}

TEST(MissingModels, AreMadeOfCagesTogether)
{
    const Beside here;
    const fs::path file = here.models / "cages" / "torus.obj";
    EXPECT_TRUE(can_be_made(file, here.program));
    make_sample_model(file, {}, here.program);
    EXPECT_TRUE(fs::exists(file));
    EXPECT_TRUE(fs::exists(here.models / "cages" / "tower.obj"));
    EXPECT_FALSE(can_be_made(file, here.program));
    EXPECT_FALSE(can_be_made(here.models / "cages" / "torus.glb", here.program));
}

TEST(MissingModels, AreMadeOfVolumeDataOneByOne)
{
    const Beside here;
    const fs::path file = here.models / "volumes" / "silicon.nrrd";
    EXPECT_TRUE(can_be_made(file, here.program));
    make_sample_model(file, {}, here.program);
    EXPECT_TRUE(fs::exists(file));
    EXPECT_FALSE(fs::exists(here.models / "volumes" / "protein.nrrd"));
}

TEST(MissingModels, AreMadeOfSampleModelsAlone)
{
    const Beside here;
    for (const fs::path& file :
         {here.models / "snake.obj", here.models / "snake" / ".." / "x" / "snake.glb",
          fs::path("/nowhere/snake.glb"), here.models / "Snake.glb", here.models / ".glb"})
        EXPECT_FALSE(can_be_made(file, here.program)) << file;
    make_sample_model(here.models / "no_such_model.glb", {}, here.program);
    EXPECT_FALSE(fs::exists(here.models / "no_such_model.glb"));
}

} // namespace
} // namespace trivar
