// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/bind.h"
#include "core/commands/command.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/commands/tiles/tiles.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::ThrowsMessage;

// A ball 1, the layer 2 that is painted on it, another ball 3, and a wall 4 parted by both balls.
Document painted_and_parted()
{
    Document document =
        after(Document{}, AddSphere{.name = "Ball", .shape = {.radius = 0.4}, .transform = {}});
    document = after(document, AddBox{.name = "Scale", .shape = {}, .transform = {}});
    document =
        after(document, AddSphere{.name = "Other", .shape = {.radius = 0.4}, .transform = {}});
    document = after(document, AddBox{.name = "Wall", .shape = {}, .transform = {}});
    document =
        after(document, PaintTiles{.object = 2, .base = 1, .stroke = testing::a_tile_stroke()});
    return after(document, Split{{4}, {.obstacles = {{1}, {3}}}});
}

TEST(Bind, PutsAnotherObjectInThePlaceOfWhatOthersDependOn)
{
    const Document bound = after(painted_and_parted(), Bind{{2, 4}, {1}, 3});
    EXPECT_EQ(object(bound, 2).tiles->base, 3);
    ASSERT_EQ(object(bound, 4).splitting->obstacles.size(), 1u) << "each is named once";
    EXPECT_EQ(object(bound, 4).splitting->obstacles[0].object, 3);
    const auto strokes = object(painted_and_parted(), 2).tiles->strokes;
    ASSERT_EQ(object(bound, 2).tiles->strokes.size(), strokes.size());
    for (std::size_t s = 0; s < strokes.size(); ++s)
        EXPECT_EQ(*object(bound, 2).tiles->strokes[s], *strokes[s]);
}

TEST(Bind, GivesWhatLiesOnNothingAnymoreAHost)
{
    Document document = testing::small_document(); // the pot lies on the table and on the ball
    document = after(document, Delete{{1, 2}});
    document = after(document, AddPlane{});
    EXPECT_TRUE(object(document, 3).stroke->onto.empty());
    document = after(document, Bind{{3}, {}, 5});
    EXPECT_EQ(object(document, 3).stroke->onto, std::vector<Id>{5});
}

TEST(Bind, KeepsAnAttachedStrokeOnTheNewHost)
{
    Document document = testing::small_document();
    document =
        after(document, AddBox{.name = "Desk", .shape = {.size = {4, 4, 0.5}}, .transform = {}});
    document = after(document, Attach{3, Attachment{{attached_host(1, glm::dmat4(1), true)}}});
    document = after(document, Bind{{3}, {1}, 5});
    EXPECT_EQ(object(document, 3).stroke->attach->hosts.front().object, 5);
    document = after(document, Delete{{1}});
    EXPECT_TRUE(carries(*object(document, 3).stroke->attach));
}

TEST(Bind, RefusesWhatCannotBe)
{
    const Document document =
        after(after(painted_and_parted(), AddBox{}), Group{.objects = {5}, .name = "Group"});
    const auto refused = [&](const Bind& bind, const char* words) {
        EXPECT_THAT([&] { after(document, bind); }, ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refused(Bind{{2}, {1}, 2}, "is or depends on");
    refused(Bind{{2}, {4}, 3}, "depends on none of these objects");
    refused(Bind{{2}, {1}, 6}, "has no shape of its own");
    refused(Bind{{2}, {1}, 17}, "17");
    refused(Bind{{}, {1}, 3}, "");
}

} // namespace
} // namespace trivar
