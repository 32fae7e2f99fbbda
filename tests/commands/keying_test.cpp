// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/keying.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/view.h"

#include "core/document/parameters.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre;
using testing::small_document;

Document moving_ball()
{
    return after(small_document(),
                 Animate{{{2, {{"transform.translation.x", {{1, 0}, {11, 1}}}}}}});
}

Transform moved_to(const glm::dvec3& to)
{
    Transform t;
    t.translation = to;
    return t;
}

TEST(Keying, MakesAKeyOfWhatIsAnimatedAndOfNothingElse)
{
    const Document document = moving_ball();
    const Command move = SetTransform{2, moved_to({3, 0, 0})};
    const Command key = keyed(document, move, 6, false);
    ASSERT_TRUE(key.is<Animate>());
    const Document keyed_document = after(document, key);
    EXPECT_EQ(object(document_at(keyed_document, 6), 2).transform.translation, glm::dvec3(3, 0, 0));
    EXPECT_EQ(tracks_of(keyed_document, 2).front().keys.size(), 3u);
    const Command lift = SetTransform{2, moved_to({0.5, 0, 1})}; // x is what frame 6 shows
    EXPECT_EQ(keyed(document, lift, 6, false), lift);
    const Command other = SetTransform{3, moved_to({1, 0, 0})};
    EXPECT_EQ(keyed(document, other, 6, false), other);
}

TEST(Keying, KeysEveryChangeWhereThatIsWanted)
{
    const Command key = keyed(small_document(), SetRender{{.exposure = 2}}, 5, true);
    ASSERT_TRUE(key.is<Animate>());
    EXPECT_EQ(key.get<Animate>(), (Animate{{{0, {{"render.exposure", {{5, 2}}}}}}}));
    const Command look =
        keyed(small_document(), SetRender{{.look = "clay", .exposure = 1}}, 5, true);
    EXPECT_EQ(look.get<Animate>(),
              (Animate{{{0, {{"render.look", {{5, 1}}}, {"render.exposure", {{5, 1}}}}}}}));
    const Command hide = keyed(small_document(), Hide{{2}}, 9, true);
    EXPECT_EQ(hide.get<Animate>(), (Animate{{{2, {{"hidden", {{9, 1}}}}}}}));
}

TEST(Keying, LeavesWhatIsMoreThanNumbersAsItIs)
{
    const Document document = moving_ball();
    for (const Command& command : {Command(Rename{2, "Sun"}), Command(Delete{{2}}),
                                   Command(Duplicate{{2}, {}}), Command(SetMaterial{{2}, {}}),
                                   Command(Group{{2, 3}, "Both"}), Command(SetTime{{0, 9, 24}})})
        EXPECT_EQ(keyed(document, command, 6, true), command) << to_json_line(command);
}

TEST(Keying, OfSeveralObjectsIsOneCommand)
{
    Document document = small_document();
    const Command both = Arrange{{2, 1}, {moved_to({1, 0, 0}), moved_to({0, 2, 0})}};
    const Command key = keyed(document, both, 4, true);
    ASSERT_TRUE(key.is<Animate>());
    EXPECT_EQ(key.get<Animate>().of.size(), 2u);
    document = after(document, key);
    EXPECT_THAT(animated_ids(document), ::testing::UnorderedElementsAre(1, 2));
}

TEST(Keying, SetsAndTakesKeysOfAFrame)
{
    Document document = moving_ball();
    const auto keys = keys_of(document, {2, 3}, {"transform.translation.x", "shape.radius"}, 6);
    ASSERT_TRUE(keys);
    document = after(document, *keys);
    EXPECT_EQ(track_of(document, 2, "transform.translation.x")->keys[1], (Key{6, 0.5}));
    EXPECT_EQ(track_of(document, 2, "shape.radius")->keys.size(), 1u);
    EXPECT_EQ(track_of(document, 3, "shape.radius"), nullptr) << "the pot has none";
    const auto fewer = without_keys(document, {2}, {"shape.radius"}, 6);
    ASSERT_TRUE(fewer);
    EXPECT_EQ(track_of(after(document, *fewer), 2, "shape.radius"), nullptr);
    EXPECT_FALSE(without_keys(document, {2}, {"shape.radius"}, 7));
    EXPECT_FALSE(keys_of(document, {2}, {"no such"}, 7));
}

} // namespace
} // namespace trivar
