// SPDX-License-Identifier: GPL-3.0-or-later
// What makes gestures and looks at what they gave.
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/scene/log.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/hands/closed_bodies.h"
#include "tests/fuzz/hands/gesture_dice.h"
#include "tests/fuzz/hands/hand_laws.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::SizeIs;

TEST(Gestures, AreReadAsTheyAreWrittenAndFollowFromTheSeed)
{
    const GestureWords words = all_words();
    const StartScene scene = start_scenes("bodies").front();
    std::set<std::string> kinds;
    for (int number = 0; number < 60; ++number) {
        Dice one(1, number), two(1, number);
        const std::vector<Gesture> gestures = drawn_gestures(words, scene, one, 12);
        EXPECT_THAT(gestures, SizeIs(12));
        EXPECT_EQ(gestures, drawn_gestures(words, scene, two, 12));
        for (const Gesture& each : gestures) {
            const std::string text = text_of(each);
            EXPECT_EQ(gesture_from(text), each) << text;
            EXPECT_EQ(text.find('\n'), text.npos);
            kinds.insert(text.substr(0, text.find(',')));
        }
    }
    EXPECT_THAT(kinds, SizeIs(::testing::Ge(12u)));
    EXPECT_THROW(gesture_from("{\"do\":\"fly\"}"), Rejected);
    EXPECT_THROW(gesture_from("{\"do\":"), Rejected);
}

TEST(ClosedBodies, AreToldFromOpenOnesWhateverTheirSeams)
{
    Mesh box = box_mesh({1, 1, 1}, {2, 2, 2});
    EXPECT_TRUE(encloses(box));
    box.corners.resize(box.corners.size() - 4);
    box.face_begin.pop_back();
    EXPECT_FALSE(encloses(box));
    EXPECT_FALSE(encloses(plane_mesh({1, 1}, {2, 2})));
    EXPECT_TRUE(encloses(sphere_mesh(1, 8, 4)));
}

struct HandRig {
    explicit HandRig(const std::string& lines)
    {
        write_file(folder.path() / "start.trivar", log_header() + lines);
        hand = std::make_unique<Hand>(folder.path() / "start.trivar");
        laws = std::make_unique<HandLaws>(*hand);
    }
    void make(const std::string& gesture)
    {
        hand->make(gesture_from(gesture));
        laws->check(true);
    }
    const Session& session() { return hand->editor().session; }
    std::size_t steps() { return session().scene().history().position(); }
    TemporaryFolder folder;
    std::unique_ptr<Hand> hand;
    std::unique_ptr<HandLaws> laws;
};

TEST(Hand, DoesWhatAPersonDoes)
{
    HandRig rig(command_line(AddSphere{}));
    rig.make(R"({"do":"click","in":"object","points":[[0.5,0.5]],"number":0})");
    EXPECT_EQ(rig.session().selected, 1);
    rig.make(R"({"do":"stroke","tool":"C","points":[[0.42,0.5],[0.5,0.47],[0.58,0.5]]})");
    EXPECT_TRUE(object(rig.session().committed(), 1).incising);
    rig.make(R"({"do":"stroke","points":[[0.42,0.4],[0.58,0.4]],"between":"Esc"})");
    EXPECT_EQ(rig.steps(), 2u);
    rig.make(R"({"do":"chord","text":"Ctrl+Z"})");
    EXPECT_EQ(rig.steps(), 1u);
    rig.make(R"({"do":"palette","text":"Add Box","end":"Enter"})");
    EXPECT_EQ(rig.steps(), 2u);
    rig.make(R"({"do":"save","text":"a"})");
    EXPECT_TRUE(std::filesystem::exists(rig.folder.file("a.trivar")));
    rig.make(R"({"do":"command","text":"{\"do\":\"delete\",\"objects\":[1]}","end":"Enter"})");
    EXPECT_EQ(rig.steps(), 3u);
    rig.make(R"({"do":"resize","points":[[400,300]]})");
    rig.make(R"({"do":"focus"})");
    rig.make(R"({"do":"drop","text":"start.trivar"})"); // as it was when it got another name
    EXPECT_EQ(rig.steps(), 2u);
}

TEST(HandLaws, FailWhereTheFileOfTheSceneIsAnother)
{
    HandRig rig(command_line(AddSphere{}));
    rig.make(R"({"do":"palette","text":"Add Box","end":"Enter"})");
    std::ofstream(rig.folder.file("start.trivar"), std::ios::app) << undo_line();
    EXPECT_THROW(rig.laws->check(false), Broken);
}

} // namespace
} // namespace trivar::testing
