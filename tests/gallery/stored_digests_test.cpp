// SPDX-License-Identifier: GPL-3.0-or-later
// Each scene and tutorial stores its digest and that of its result, so that a change of what it
// gives is seen, and passes `trivar replay --check`. TRIVAR_UPDATE_GOLDEN=1 stores them anew.
#include "core/base/text.h"
#include "core/files/file_bytes.h"
#include "core/scene/log.h"
#include "editor/command_line/replay.h"
#include "tests/gallery/scenes.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace trivar {
namespace {

class StoredDigests : public ::testing::TestWithParam<std::string> {};

std::string replayed(const ReplayOptions& options)
{
    std::ostringstream out, talk;
    EXPECT_EQ(run_replay(options, {out, talk}), Status::done) << talk.str();
    return out.str();
}

// Stored is the result in the frame that the gallery shows: in the first one nothing may have
// grown or opened yet.
void expect_stored(const std::string& path, std::optional<int> frame)
{
    ReplayOptions options;
    options.scene.path = path;
    std::string text = read_text_file(path);
    const LogLine last = read_log(text, path).lines.back();
    if (std::getenv("TRIVAR_UPDATE_GOLDEN")) {
        if (std::holds_alternative<CheckLine>(last.what))
            text.erase(text.rfind('\n', text.size() - 2) + 1);
        options.digest = true;
        options.frame = frame;
        return write_bytes(path, text + replayed(options));
    }
    EXPECT_NE(last.digest, "");
    EXPECT_NE(last.effects, "");
    EXPECT_EQ(last.frame, frame);
    options.check = true;
    replayed(options);
}

TEST_P(StoredDigests, AreThoseOfTheSceneAndItsResult)
{
    expect_stored(TRIVAR_SOURCE_DIR "/assets/scenes/" + GetParam() + ".trivar",
                  testing::shown_frame(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, StoredDigests, ::testing::ValuesIn(testing::every_scene()),
                         [](const auto& scene) { return scene.param; });

class StoredDigestsOfTutorials : public ::testing::TestWithParam<std::string> {};

TEST_P(StoredDigestsOfTutorials, AreThoseOfTheSceneAndItsResult)
{
    expect_stored(TRIVAR_SOURCE_DIR "/assets/tutorials/" + GetParam() + ".trivar", {});
}

INSTANTIATE_TEST_SUITE_P(Tutorials, StoredDigestsOfTutorials,
                         ::testing::ValuesIn(testing::every_scene("tutorials")),
                         [](const auto& scene) { return scene.param; });

} // namespace
} // namespace trivar
