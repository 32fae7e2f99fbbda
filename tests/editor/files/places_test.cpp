// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/places.h"

#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Places, OfAnInstalledProgramAreBesideItsFolder)
{
    const testing::TemporaryFolder prefix;
    for (const char* name :
         {"assets/scenes", "assets/tutorials", "manual", "gallery", "assets/models"})
        std::filesystem::create_directories(prefix.path() / "share/trivar" / name);
    const Places places = places_of(prefix.path() / "bin" / "trivar");
    EXPECT_EQ(places.scenes, prefix.file("share/trivar/assets/scenes"));
    EXPECT_EQ(places.tutorials, prefix.file("share/trivar/assets/tutorials"));
    EXPECT_EQ(places.manual, prefix.file("share/trivar/manual"));
    EXPECT_EQ(places.pictures, prefix.file("share/trivar/gallery"));
    EXPECT_EQ(places.models, prefix.file("share/trivar/assets/models"));
}

TEST(Places, OfABuiltProgramAreThoseOfItsCheckout)
{
    const std::filesystem::path source = TRIVAR_SOURCE_DIR;
    const Places places = places_of(source / "build" / "trivar");
    EXPECT_EQ(places.scenes, (source / "assets/scenes").string());
    EXPECT_EQ(places.manual, (source / "docs/manual").string());
    EXPECT_EQ(places.pictures, (source / "docs/gallery").string());
}

TEST(Places, OfACopiedProgramAreNone)
{
    const testing::TemporaryFolder folder;
    const Places places = places_of(folder.path() / "bin" / "trivar");
    EXPECT_EQ(places.scenes + places.tutorials + places.manual + places.pictures, "");
}

} // namespace
} // namespace trivar
