// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "tests/support/scenes/commands.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <regex>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::fitting_document, testing::small_document;

Paste copies(const Document& document, const std::vector<Id>& ids)
{
    return copied(document, ids, "/models");
}

TEST(Paste, GivesTheSameObjectsUnderNamesThatAreFree)
{
    const Document before = small_document();
    const Document there = after(before, copies(before, {2}));
    Object copy = object(there, before.next_id);
    EXPECT_EQ(copy.name, "Ball 2");
    copy.name = "Ball";
    EXPECT_EQ(copy, object(before, 2));
    const Document elsewhere = after(Document{}, copies(before, {2}));
    EXPECT_EQ(object(elsewhere, 1), object(before, 2));
}

TEST(Paste, LaysACopyOnWhatItLiesOnWhereTheSceneHasItOrItWasCopiedToo)
{
    const Document before = small_document(); // 3 lies on 1, in group 4, and on 2
    const Document alone = after(before, copies(before, {3}));
    EXPECT_THAT(object(alone, before.next_id).stroke->onto, ElementsAre(1, 2));
    const Document both = after(before, copies(before, {3, 2}));
    const Id ball = before.next_id, pot = before.next_id + 1;
    EXPECT_THAT(object(both, pot).stroke->onto, ElementsAre(1, ball));
    const Document cut = after(after(before, Delete{{3}}), copies(before, {3}));
    EXPECT_EQ(object(cut, before.next_id).name, "Pot");
    EXPECT_THAT(object(cut, before.next_id).stroke->onto, ElementsAre(1, 2));
}

TEST(Paste, LaysACopyOverAllThereIsInAnotherSceneOrLeavesItStraight)
{
    const Document from = small_document();
    const Document nothing = after(Document{}, copies(from, {3}));
    EXPECT_FALSE(object(nothing, 1).stroke);
    Document other = after(Document{}, AddTorus{}); // of the same number, not of that name
    other = after(other, copies(from, {3}));
    EXPECT_THAT(object(other, 2).stroke->onto, ElementsAre(1));
    EXPECT_EQ(object(other, 2).stroke->sketch, object(from, 3).stroke->sketch);
}

TEST(Paste, TakesTravelsAndWhatGoesRoundAlong)
{
    Document from = after(small_document(), Delete{{3}});
    from = after(from, AddTorus{});
    from = after(from, PlaceRound{.object = 2, .around = 5, .level = 0.1, .parameters = {}});
    from = after(from, SetTravel{{2}, {.speed = 2}});
    const Document there = after(from, copies(from, {2}));
    EXPECT_EQ(object(there, 6).stroke, object(from, 2).stroke);
    EXPECT_EQ(object(there, 6).travel.speed, 2);
    const Document elsewhere = after(after(Document{}, AddBox{}), copies(from, {2}));
    EXPECT_FALSE(object(elsewhere, 2).stroke); // there is no way round
}

TEST(Paste, KeepsWhatIsInAGroupAndPutsTheRestWhereItStood)
{
    Document from = small_document();
    from = after(from, SetTransform{4, {.translation = {5, 0, 0}}});
    const Document there = after(from, copies(from, {4}));
    EXPECT_EQ(object(there, 5).name, "Furniture 2");
    EXPECT_EQ(object(there, 6).parent, 5);
    EXPECT_EQ(object(there, 6).name, "Table");
    const Document member = after(from, copies(from, {1}));
    EXPECT_EQ(object(member, 5).parent, 0);
    EXPECT_EQ(to_world(member, 5), to_world(from, 1));
}

TEST(Paste, NamesFilesFromTheRoot)
{
    const Paste paste = copies(fitting_document(), {5});
    EXPECT_EQ(std::get<ImportedFile>(paste.copies.front().value.source).path, "/models/snail.obj");
}

TEST(Paste, RefusesWhatNoCopyIs)
{
    const Document document = small_document();
    const Paste good = copies(document, {4});
    const auto refused = [&](auto&& spoil) {
        Paste bad = good;
        spoil(bad.copies);
        EXPECT_THROW(after(document, bad), Rejected);
    };
    refused([](auto& c) { c.clear(); });
    refused([](auto& c) { c[0].value.name.clear(); });
    refused([](auto& c) { c[1].object = c[0].object; });
    refused([](auto& c) { std::swap(c[0], c[1]); }); // its group must come first
    refused([](auto& c) { c[1].value.transform.scale.x = 0; });
    std::string two_shapes = to_json_line(good);
    two_shapes.insert(two_shapes.find("\"transform\""), "\"sphere\":{},\"torus\":{},");
    EXPECT_THROW(command_from_json_line(two_shapes), Rejected);
    EXPECT_NO_THROW(after(document, good));
    EXPECT_THAT(copies(document, {99}).copies, IsEmpty());
}

TEST(Paste, RefusesShapingAndRefiningThatTheirCommandsRefuse)
{
    const Document document = small_document();
    Paste paste = copies(document, {3});
    paste.copies[0].value.refining.emplace().method = BoundMethod::thesis_circumradius;
    EXPECT_THROW(after(document, paste), Rejected);
    paste.copies[0].value.refining.reset();
    paste.copies[0].value.shaping.assign(4097, make_ref(VolumeEdit{.mending = Mending{}}));
    EXPECT_THROW(after(document, paste), Rejected);
    paste.copies[0].value.shaping.pop_back();
    EXPECT_NO_THROW(after(document, paste));
}

// The names and values of a line of JSON, in their order.
std::vector<std::string> parts(const std::string& line)
{
    static const std::regex ends("[,{}\\[\\]]");
    return {std::sregex_token_iterator(line.begin(), line.end(), ends, -1), {}};
}

TEST(Paste, IsWrittenAsEarlierVersionsWroteItButForNewFields)
{
    int lines = 0;
    const std::string log = read_text_file(TRIVAR_SOURCE_DIR "/tests/logs/versions/1_paste.trivar");
    for (const std::string_view line : trimmed_lines(log)) {
        if (!line.starts_with(R"({"do":"paste")")) continue;
        const std::string written(line.substr(0, line.rfind(",\"digest\"")));
        const Command command = command_from_json_line(written + "}");
        std::size_t found = 0; // of the old line's, one after another in the new line
        const std::vector<std::string> old = parts(written + "}");
        for (const std::string& part : parts(to_json_line(command)))
            if (found < old.size() && part == old[found]) ++found;
        EXPECT_EQ(found, old.size()) << "lacks or moves " << old[std::min(found, old.size() - 1)];
        EXPECT_EQ(command, command_from_json_line(to_json_line(command)));
        ++lines;
    }
    EXPECT_EQ(lines, 14);
}

} // namespace
} // namespace trivar
