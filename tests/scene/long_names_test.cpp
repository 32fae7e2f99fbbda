// SPDX-License-Identifier: GPL-3.0-or-later
// Names of objects, fields and clips may have 4096 bytes and line ends; sentences about them not.
#include "core/commands/command.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::SizeIs, ::testing::Lt, ::testing::Not;

const std::string long_name = std::string(4000, 'A') + "\nB";

std::string refusal_of(const std::string& lines)
{
    try {
        replay(read_log(log_header() + lines, "a.trivar"));
    } catch (const Rejected& rejected) {
        return rejected.what();
    }
    return "";
}

void expect_short(const std::string& sentence)
{
    EXPECT_THAT(sentence, HasSubstr("AAAA"));
    EXPECT_THAT(sentence, SizeIs(Lt(400u)));
    EXPECT_THAT(sentence, Not(HasSubstr("\n")));
}

TEST(LongNames, AreCutInWhatARefusalSays)
{
    const std::string text = "\"" + std::string(4000, 'A') + "\\nB\"";
    const std::string box = R"({"do":"add_box","name":)" + text + "}\n";
    for (
        const std::string line :
        {R"({"do":"ungroup","object":1})", R"({"do":"play_clip","objects":[1]})",
         R"({"do":"unplace","object":1})", R"({"do":"place_round","object":1,"around":1})",
         R"({"do":"place","object":1,"samples":[[0,0],[9,9]],"camera":{"eye":[0,-4,4],"target":[0,0,0]}})"})
        expect_short(refusal_of(box + line + "\n"));
    expect_short(refusal_of(box + R"({"do":"animate","of":[{"object":1,"tracks":[{"parameter":)" +
                            text + R"(,"keys":[{"frame":1,"value":0}]}]}]})" + "\n"));
    expect_short(refusal_of("{\"do\":" + text + "}\n"));
    expect_short(refusal_of("{\"do\":\"add_box\"," + text + ":1}\n"));
    expect_short(refusal_of("{\"do\":\"set_render\",\"look\":" + text + "}\n"));
    expect_short(refusal_of("{\"do\":\"delete_camera\",\"name\":" + text + "}\n"));
}

TEST(LongNames, AreCutInWhatAnObjectSaysOfItsClips)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.path() / "bar.gltf", testing::gltf_text(testing::rigged_model()));
    History history;
    ImportModel import;
    import.file.path = "bar.gltf";
    history.run(import);
    PlayClip play;
    play.objects = {1};
    play.playing.clip = long_name;
    history.run(play);
    Evaluator evaluator(std::make_shared<const AssetStore>(folder.path().string()));
    const Evaluation shown = evaluator(history.document());
    ASSERT_THAT(shown.objects.at(1)->notices, SizeIs(1));
    expect_short(shown.objects.at(1)->notices.front());
}

TEST(LongNames, AreCutWhereTheFileOfThatNameIsMissing)
{
    const AssetStore assets(".");
    for (const std::string& path : {long_name + ".obj", "AAAA" + long_name})
        expect_short(assets.load({path, ""}).notices.at(0));
}

} // namespace
} // namespace trivar
