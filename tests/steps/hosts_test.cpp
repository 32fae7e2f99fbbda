// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of what lies on a thing when that is deleted, hidden, replaced, made small, taken
// far away, or in part not there.
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/volumes/lattice.h"
#include "core/document/parameters.h"
#include "core/placement/placement.h"
#include "core/steps/laying/attaching.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/lying.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty,
    ::testing::Not;
using testing::furthest_off, testing::NearestOn, testing::world_points;

// Hosts 1 and 2, two halves of a table, a floor 3 half a metre below their middle, and on both
// halves a teapot 4.
constexpr Id left_half = 1, right_half = 2, floor_id = 3, carried_pot = 4;
constexpr double table_top = 0.25, floor_top = -0.5, rounding = 1e-6; // metres
const std::string not_shown = "its host is not visible in this frame";
const std::string partly_shown = "a part of its hosts is not visible in this frame; what lay "
                                 "on that goes with the rest";

Document attached_as_it_lies(const Document& document, Id id, double frame = 1)
{
    Evaluator evaluate = testing::new_evaluator();
    const EvaluatedObject laid = *evaluate(document, frame).objects.at(id);
    const PlacementStep& step = *object(document, id).stroke;
    const auto attachment = attachment_of(laid, step.sketch, step.parameters.skip_back_faces);
    EXPECT_TRUE(attachment) << laid.rejected;
    return after(document, Attach{id, attachment});
}

Document on_two_halves()
{
    Document document;
    for (const double x : {-1.0, 1.0})
        document = after(document, AddBox{.name = x < 0 ? "Left" : "Right",
                                          .shape = {.size = {2, 2, 0.5}},
                                          .transform = {.translation = {x, 0, 0}}});
    document = after(document, AddPlane{.name = "Floor",
                                        .shape = {.size = {60, 60}},
                                        .transform = {.translation = {0, 0, floor_top}}});
    document = after(document, AddTeapot{.shape = {.height = 0.2, .resolution = 4}});
    document = after(document, Place{carried_pot, testing::small_sketch(), {}, {1, 2, 3}});
    return attached_as_it_lies(document, carried_pot);
}

// The same, in a group 5 without the floor.
Document on_a_table()
{
    return after(on_two_halves(), Group{{left_half, right_half}, "Table"});
}

EvaluatedObject shown_at(const Document& document, Id id, double frame = 1)
{
    Evaluator evaluate = testing::new_evaluator();
    return *evaluate(document, frame).objects.at(id);
}

EvaluatedObject pot_of(const Document& document, double frame = 1)
{
    return shown_at(document, carried_pot, frame);
}

glm::dmat4 shift_by(const glm::dvec3& by)
{
    return glm::translate(glm::dmat4(1), by);
}

// Where the middle of its contact is.
glm::dvec3 contact_middle(const EvaluatedObject& laid)
{
    return evaluate(laid.placement->contact, {0.5, 0.5}).value;
}

TEST(DeletedHosts, LeaveTheirPieceToTheOthers)
{
    const Document document = after(on_two_halves(), Delete{{left_half, floor_id}});
    const EvaluatedObject pot = pot_of(document);
    EXPECT_THAT(pot.rejected, IsEmpty());
    const NearestOn right(shown_at(document, right_half));
    for (const double u : {0.6, 0.75, 0.9}) // its springs bend it a little up to the gap
        EXPECT_LT(right(evaluate(pot.placement->contact, {u, 0.5}).value).off, 0.04) << u;
    const Transform t{.translation = {4, -1, 2}, .rotation_deg = {0, 0, 70}};
    const EvaluatedObject moved = pot_of(after(document, SetTransform{right_half, t}));
    EXPECT_LT(
        furthest_off(world_points(moved), world_points(pot), t.matrix() * shift_by({-1, 0, 0})),
        rounding);
}

// Not even what the stroke passed carries it then.
TEST(DeletedHosts, LeaveTheStrokeWhereItWasDrawn)
{
    const Document table = on_a_table();
    Document never = after(table, Attach{carried_pot, {}});
    never = after(never, EditPlacement{carried_pot, {}, testing::small_sketch(), {}});
    ASSERT_FALSE(object(never, carried_pot).stroke->attach);
    for (const Transform& t : {Transform{}, Transform{.translation = {3, 1, 2}}}) {
        const auto without = [&](const Document& document) {
            return after(after(document, SetTransform{5, t}), Delete{{5}});
        };
        for (const double height : {0.0, 0.3}) {
            const SetTransform floor{floor_id, {.translation = {1, 0, floor_top + height}}};
            const EvaluatedObject pot = pot_of(after(without(table), floor));
            EXPECT_THAT(pot.rejected, IsEmpty());
            EXPECT_NEAR(pot.bounds->lo.z, floor_top + height, 0.01);
            EXPECT_EQ(world_points(pot), world_points(pot_of(after(without(never), floor))));
        }
    }
}

TEST(DeletedHosts, SayThatNothingIsLeftToLieOn)
{
    const Document document = after(on_two_halves(), Delete{{left_half, right_half, floor_id}});
    const EvaluatedObject pot = pot_of(document);
    EXPECT_EQ(pot.rejected,
              "everything this object lay on is gone; place it again or remove it from its stroke");
    EXPECT_EQ(world_points(pot), world_points(pot_of(after(document, Unplace{carried_pot}))));
}

TEST(HiddenHosts, CarryAsEver)
{
    const Document table = on_a_table(), hidden = after(table, Hide{{5}});
    EXPECT_EQ(world_points(pot_of(hidden)), world_points(pot_of(table)));
    EXPECT_THAT(pot_of(hidden).notices, IsEmpty());
    const Transform t{.translation = {1, 2, 3}, .rotation_deg = {10, 20, 30}};
    EXPECT_LT(furthest_off(world_points(pot_of(after(hidden, SetTransform{5, t}))),
                           world_points(pot_of(table)), t.matrix()),
              rounding);
}

ImportedFile made_model(const std::string& name)
{
    ImportedFile file;
    file.path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/" + name;
    return file;
}

// A teapot 2 on a book 1, three times as large as its file has it.
Document on_a_book()
{
    ImportModel import;
    import.file = made_model("book.glb");
    import.transform = {.translation = {0, 0, 0}, .scale = { 3, 3, 3 }};
    Document document = after(Document{}, import);
    document = after(document, AddTeapot{.shape = {.height = 0.2, .resolution = 4}});
    document = after(document, Place{2, testing::small_sketch(), {}, {1}});
    return attached_as_it_lies(document, 2);
}

TEST(ReplacedHosts, AreMetAsTheyAreNow)
{
    const Document document = on_a_book();
    for (const char* name : {"desk.glb", "terrain.glb"}) {
        const Document replaced = after(document, Relink{{1}, {made_model(name)}});
        const EvaluatedObject pot = shown_at(replaced, 2);
        ASSERT_THAT(pot.rejected, IsEmpty()) << name;
        EXPECT_LE(pot.placement->report.penetration, 1e-3) << name;
        const NearestOn host(shown_at(replaced, 1));
        double least = 1e300;
        for (int i = 0; i <= 20; ++i)
            least =
                std::min(least, host(evaluate(pot.placement->contact, {i / 20.0, 0.5}).value).off);
        EXPECT_LT(least, 0.01) << name;
        EXPECT_LT(host(contact_middle(pot)).off, 0.05) << name << ": its springs bridge the rest";
        const Transform t{.translation = {5, 0, 1}, .rotation_deg = {0, 0, 50}, .scale = {3, 3, 3}};
        const glm::dmat4 by = t.matrix() * glm::inverse(object(replaced, 1).transform.matrix());
        EXPECT_LT(furthest_off(world_points(shown_at(after(replaced, SetTransform{1, t}), 2)),
                               world_points(pot), by),
                  2 * rounding)
            << name;
    }
}

TEST(ReplacedHosts, CarryNothingWhereTheirFileIsNotThere)
{
    const Document document = after(on_a_book(), Relink{{1}, {made_model("none.glb")}});
    const EvaluatedObject pot = shown_at(document, 2);
    EXPECT_TRUE(pot.shows_nothing());
    EXPECT_THAT(pot.notices, Contains(not_shown));
    // And as ever when it is back.
    const Document back = after(document, Relink{{1}, {made_model("book.glb")}});
    EXPECT_EQ(world_points(shown_at(back, 2)), world_points(shown_at(on_a_book(), 2)));
}

TEST(SmallHosts, MakeItAsSmallAsTheyAre)
{
    const Document table = on_a_table();
    const std::vector<glm::dvec3> whole = world_points(pot_of(table));
    for (const double size : {0.1, 1e-3}) {
        const Transform t{.translation = {1, 0, 0}, .scale = glm::dvec3(size)};
        const EvaluatedObject pot = pot_of(after(table, SetTransform{5, t}));
        EXPECT_THAT(pot.rejected, IsEmpty());
        EXPECT_LT(furthest_off(world_points(pot), whole, t.matrix()), rounding);
    }
}

TEST(SmallHosts, ShortenTheStrokeWhereTheyAreSqueezed)
{
    const Document document =
        after(after(on_a_table(), Delete{{floor_id}}),
              SetTransform{5, {.translation = {0, 2, 0}, .scale = {0.2, 1, 1}}});
    const EvaluatedObject pot = pot_of(document), before = pot_of(on_a_table());
    EXPECT_THAT(pot.rejected, IsEmpty());
    const auto length = [](const EvaluatedObject& laid) {
        const Surface<glm::dvec3>& contact = laid.placement->contact;
        return evaluate(contact, {1, 0.5}).value.x - evaluate(contact, {0, 0.5}).value.x;
    };
    // The samples of the stroke go to and fro by 10 pixels, which are so many metres there. Where
    // it is squeezed they count for more, and its middle is another sample.
    constexpr double to_and_fro = 0.05;
    EXPECT_NEAR(length(pot), 0.2 * length(before), to_and_fro);
    EXPECT_NEAR(contact_middle(pot).y, contact_middle(before).y + 2, to_and_fro);
    EXPECT_NEAR(pot.bounds->lo.z, table_top, 0.01);
    EXPECT_LE(pot.placement->report.penetration, 1e-3);
}

TEST(SmallHosts, SayThatTheStrokeMeetsNothingWhereHardlyAnyIsLeft)
{
    Document document = after(on_two_halves(), Delete{{floor_id}});
    for (const Id id : {left_half, right_half})
        document =
            after(document, SetTransform{id,
                                         {.translation = {id == left_half ? -1.0 : 1.0, 0, 0},
                                          .scale = {0.2, 0.2, 1}}});
    const EvaluatedObject pot = pot_of(document);
    EXPECT_EQ(pot.rejected, "89 % of the model would have no surface beneath it; draw the stroke "
                            "over an object or reduce the width");
    EXPECT_EQ(world_points(pot), world_points(pot_of(after(document, Unplace{carried_pot}))));
}

TEST(FarHosts, CarryOutOfThePicture)
{
    const Document document =
        after(on_a_table(),
              Animate{{{5,
                        {{"transform.translation.x", {{1, 0}, {25, 1e4, Tween::linear}}},
                         {"transform.rotation_deg.x", {{1, 0}, {25, 180, Tween::linear}}}}}}});
    const std::vector<glm::dvec3> first = world_points(pot_of(document));
    for (const double frame : {3.0, 12.5, 25.0}) {
        const EvaluatedObject pot = pot_of(document, frame);
        EXPECT_THAT(pot.notices, IsEmpty());
        const glm::dmat4 by = to_world(document_at(document, frame), 5);
        constexpr double single = 1e4 * 1.2e-7; // of the vertices of a mesh so far out
        EXPECT_LT(furthest_off(world_points(pot), first, by), single) << frame;
    }
}

TEST(FarHosts, AreMetThereWhereTheyAreStretched)
{
    const Document near =
        after(on_a_table(), SetTransform{5, {.translation = {0, 0, 1}, .scale = {1, 1, 4}}});
    const EvaluatedObject here = pot_of(near);
    for (const double x : {30.0, 1e4}) {
        const EvaluatedObject pot =
            pot_of(after(near, SetTransform{5, {.translation = {x, 0, 1}, .scale = {1, 1, 4}}}));
        EXPECT_THAT(pot.rejected, IsEmpty());
        EXPECT_NEAR(pot.bounds->lo.z, 1 + 4 * table_top, 0.01);
        EXPECT_LT(furthest_off(world_points(pot), world_points(here), shift_by({x, 0, 0})),
                  1e-9 * x + 1e-3);
    }
}

TEST(Hosts, LieNotOnWhatTheyCarryNorGoWithIt)
{
    const Document document = on_two_halves();
    const auto why = [](const Document& before, const Command& command) -> std::string {
        try {
            after(before, command);
        } catch (const Rejected& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_EQ(why(document, Place{left_half, testing::small_sketch(), {}, {carried_pot}}),
              "field \"onto\": object 4 (Teapot) lies on object 1 (Left) already, so the other way "
              "round is impossible");
    EXPECT_THAT(why(document, SetParent{{left_half}, carried_pot}),
                HasSubstr("lies on a stroke and cannot be a parent"));
    const Document both = after(document, SetParent{{left_half}, right_half});
    EXPECT_THAT(why(both, SetParent{{right_half}, left_half}), HasSubstr("which is in it"));
    EXPECT_THAT(why(both, SetParent{{left_half}, left_half}), HasSubstr("cannot be in itself"));
    // Through a lattice that would bend its own support.
    const Document bent = after(document, AddLattice{.objects = {left_half}});
    EXPECT_THAT(why(bent, Place{5, testing::small_sketch(), {}, {carried_pot}}),
                HasSubstr("so the other way round is impossible"));
    const Document pedestal = after(after(document, AddBox{}), AddLattice{.objects = {5}});
    const Document above = after(pedestal, Place{6, testing::small_sketch(), {}, {carried_pot}});
    EXPECT_THAT(why(above, SetParent{{left_half}, 6}), HasSubstr("which lies on it"));
}

TEST(Hosts, SayWhichPartOfThemIsNotShown)
{
    const Document whole = on_a_table();
    Attachment attachment = *object(whole, carried_pot).stroke->attach;
    constexpr int no_mesh_of_theirs = 7;
    for (std::size_t i = 0; i < attachment.samples.size() / 3; ++i)
        attachment.samples[i].mesh = no_mesh_of_theirs;
    const Document part = after(whole, Attach{carried_pot, attachment});
    EXPECT_THAT(pot_of(whole).notices, IsEmpty());
    EXPECT_THAT(pot_of(part).notices, ElementsAre(partly_shown));
    EXPECT_EQ(world_points(pot_of(part)), world_points(pot_of(whole)));
    const Transform t{.translation = {1, 2, 3}, .rotation_deg = {10, 20, 30}};
    EXPECT_LT(furthest_off(world_points(pot_of(after(part, SetTransform{5, t}))),
                           world_points(pot_of(whole)), t.matrix()),
              rounding);
}

// Two carts, one object 2, drive over a floor 1 with a pole 3 over both. The first one is gone when
// it comes to the end of its way.
TEST(Hosts, OfWhichOneGoesLeaveItToTheNext)
{
    Document document = after(Document{}, AddPlane{.shape = {.size = {20, 20}}, .transform = {}});
    document = after(document, AddBox{.name = "Cart", .shape = {.size = {0.5, 0.5, 0.3}}});
    Camera above{.eye = {0, -0.01, 5}, .target = {0, 0, 0}};
    above.perspective = false;
    above.height_world = 6;
    const auto line = [&](double from, double to, double z) {
        Sketch sketch{above, {}};
        for (int i = 0; i <= 16; ++i)
            sketch.samples.push_back(
                {project(above, {from + (to - from) * i / 16, 0, z}).p_px, 0.05 * i, 1});
        return sketch;
    };
    document = after(document, Place{2, line(-3, 3, 0), {.fill = 0.1}, {1}});
    document = after(document,
                     SetTravel{{2}, {.speed = 1, .ends = Ends::hide, .followers = 1, .gap = 0.8}});
    document = after(
        document,
        AddCylinder{.name = "Pole", .shape = {.radius = 0.05, .height = 1.5}, .transform = {}});
    constexpr double both = 61, last = 133; // frames: 2.5 and 5.5 seconds after they set out
    const EvaluatedObject then = shown_at(document, 2, both), later = shown_at(document, 2, last);
    ASSERT_EQ(then.parts.size(), 2u);
    ASSERT_EQ(later.parts.size(), 1u);
    document = after(document, Place{3,
                                     line(then.bounds->lo.x, then.bounds->hi.x, 0.3),
                                     {.width = 0.1, .height = 0.1, .along = LengthAxis::z},
                                     {2}});
    document = attached_as_it_lies(document, 3, both);
    const EvaluatedObject pole = shown_at(document, 3, both), left = shown_at(document, 3, last);
    EXPECT_THAT(pole.notices, Not(Contains(partly_shown)));
    EXPECT_THAT(left.rejected, IsEmpty());
    EXPECT_THAT(left.notices, Contains(partly_shown));
    const auto behind = [](const EvaluatedObject& laid) { // over the second cart
        return evaluate(laid.placement->contact, {0.2, 0.5}).value;
    };
    const double went =
        later.bounds->center().x - (then.bounds->lo.x + 0.5 * later.bounds->size().x);
    EXPECT_GT(went, 2.9);
    EXPECT_LT(glm::distance(behind(left), behind(pole) + glm::dvec3(went, 0, 0)), 0.02);
    EXPECT_LT(NearestOn(later)(behind(left)).off, 0.01);
    // When the second one is gone, too, nothing carries it.
    const EvaluatedObject gone = shown_at(document, 3, last + 48);
    EXPECT_TRUE(gone.shows_nothing());
    EXPECT_THAT(gone.notices, Contains(not_shown));
}

} // namespace
} // namespace trivar
