// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/tiles/tiles.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

constexpr Id painted_ball = 2, stud_id = 8; // of fitting_document()

Evaluation evaluation_of(const Document& document, double frame = 1)
{
    return new_evaluator()(document, frame);
}

// A scattering stroke over the ball with small tiles.
Document painted_document()
{
    Document document = after(fitting_document(), ClearTiles{{stud_id}});
    TileStroke stroke = a_tile_stroke();
    stroke.radius = 0.15;
    stroke.size = 0.05;
    return after(document, PaintTiles{stud_id, painted_ball, stroke});
}

const EvaluatedObject& shown_in(const Evaluation& evaluation, Id id)
{
    return *evaluation.objects.at(id);
}

std::size_t tile_count(const Evaluation& evaluation)
{
    const std::size_t per_tile =
        shown_in(evaluation_of(after(painted_document(), ClearTiles{{stud_id}})), stud_id)
            .parts.at(0)
            .rest->vertex_count();
    std::size_t all = 0;
    for (const Part& part : shown_in(evaluation, stud_id).parts) all += part.vertex_count();
    EXPECT_EQ(all % per_tile, 0u);
    return all / per_tile;
}

void expect_no_tiles(const Document& document, const Command& command, const char* why)
{
    try {
        after(document, command);
        ADD_FAILURE() << "taken";
    } catch (const Rejected& rejected) {
        EXPECT_THAT(rejected.what(), ::testing::HasSubstr(why));
    }
}

TEST(PaintedTiles, StandOnTheirBaseAndReplaceTheObject)
{
    const Evaluation all = evaluation_of(painted_document());
    EXPECT_GT(tile_count(all), 20u);
    EXPECT_THAT(shown_in(all, stud_id).notices, ::testing::IsEmpty());
    const Mesh& mesh = *shown_in(all, stud_id).parts.at(0).mesh();
    double lowest = 1e300, highest = 0;
    for (const glm::vec3& p : mesh.positions) {
        lowest = std::min(lowest, static_cast<double>(glm::length(p)));
        highest = std::max(highest, static_cast<double>(glm::length(p)));
    }
    // The cylinder is 1 m high and 0.2 m wide, so a tile of 0.05 m is 0.25 m high.
    EXPECT_NEAR(lowest, 0.4, 0.003);
    EXPECT_NEAR(highest, 0.65, 0.006);
}

TEST(PaintedTiles, GoWithTheirBase)
{
    const Document before = painted_document();
    Transform there;
    there.translation = {3, 0, 1};
    there.rotation_deg = {0, 0, 90};
    there.scale = glm::dvec3(2);
    const Document moved = after(before, SetTransform{painted_ball, there});
    const Evaluation a = evaluation_of(before), b = evaluation_of(moved);
    const auto& was = shown_in(a, stud_id).parts.at(0).mesh()->positions;
    const auto& now = shown_in(b, stud_id).parts.at(0).mesh()->positions;
    ASSERT_EQ(was.size(), now.size());
    const glm::dmat4 way = there.matrix();
    for (std::size_t v = 0; v < was.size(); ++v)
        EXPECT_LT(glm::distance(glm::dvec3(way * glm::dvec4(was[v], 1)), glm::dvec3(now[v])), 2e-5);
}

TEST(PaintedTiles, StandOutsideOfAMirrorImage)
{
    const Document before = painted_document();
    Transform mirror;
    mirror.scale = {-1, 1, 1};
    const Evaluation a = evaluation_of(before),
                     b = evaluation_of(after(before, SetTransform{painted_ball, mirror}));
    EXPECT_THAT(shown_in(b, stud_id).notices, ::testing::IsEmpty());
    EXPECT_EQ(tile_count(a), tile_count(b));
    const auto highest = [](const Evaluation& of) {
        double most = 0;
        for (const glm::vec3& p : shown_in(of, stud_id).parts.at(0).mesh()->positions)
            most = std::max(most, static_cast<double>(glm::length(p)));
        return most;
    };
    EXPECT_NEAR(highest(a), highest(b), 1e-5);
}

TEST(PaintedTiles, KeepTheirChartsWhereStrokesAreAdded)
{
    Evaluator evaluator = new_evaluator();
    const Document first = painted_document();
    evaluator(first, 1);
    TileStroke comb = a_tile_stroke(); // changes some tiles, and adds none
    comb.brush = TileBrush::comb;
    comb.radius = 0.05;
    for (const TileStroke& stroke : {comb, *object(first, stud_id).tiles->strokes.front()}) {
        const Document next = after(first, PaintTiles{stud_id, painted_ball, stroke});
        EXPECT_EQ(digest(evaluator(next, 1)), digest(evaluation_of(next)));
    }
}

TEST(PaintedTiles, RideOnWhatIsBentItself)
{
    // The pot lies on a stroke over table and ball; tiles on it go along when it is made
    // higher.
    Document document = after(painted_document(), ClearTiles{{stud_id}});
    const Evaluation at_first = evaluation_of(document);
    const Part pot_part = shown_in(at_first, 3).parts.at(0);
    TileStroke stroke;
    stroke.brush = TileBrush::fill;
    stroke.size = 0.03;
    const glm::dvec3 a(pot_part.rest->positions[pot_part.rest->corners[0]]),
        b(pot_part.rest->positions[pot_part.rest->corners[1]]),
        c(pot_part.rest->positions[pot_part.rest->corners[2]]);
    stroke.samples = {{{(a + b + c) / 3.0, glm::normalize(glm::cross(b - a, c - a))}}};
    document = after(document, PaintTiles{stud_id, 3, stroke});
    const Evaluation all = evaluation_of(document);
    ASSERT_GT(tile_count(all), 30u);
    // Each tile's floor touches the bent pot.
    const auto away = [](const Evaluation& of) {
        const Mesh& pot_mesh = *of.objects.at(3)->parts.at(0).mesh();
        const auto& tiles = of.objects.at(stud_id)->parts.at(0).mesh()->positions;
        double most = 0;
        for (std::size_t v = 0; v < tiles.size(); v += 97) {
            double least = 1e300;
            for (const glm::vec3& p : pot_mesh.positions)
                least = std::min(least, static_cast<double>(glm::distance(p, tiles[v])));
            most = std::max(most, least);
        }
        return most;
    };
    const double before = away(all);
    PlacementParameters high = object(document, 3).stroke->parameters;
    high.height = 0.5;
    const Evaluation raised = evaluation_of(after(document, EditPlacement{3, high, {}, {}}));
    EXPECT_EQ(tile_count(raised), tile_count(all));
    EXPECT_LT(away(raised), 4 * before + 0.1);
    EXPECT_NE(digest(raised), digest(all));
}

TEST(PaintedTiles, AreNotLaidAnewWhereTheBaseOnlyMoves)
{
    Evaluator evaluator = new_evaluator();
    const Document document = after(painted_document(), Delete{{3}}); // which lies on the ball
    evaluator(document, 1);
    const auto count_stage = [](const Evaluation& of, const char* name) {
        return std::ranges::count(of.timings.stages, name, &Timings::Stage::name);
    };
    Transform there;
    there.translation = {1, 2, 3};
    const Evaluation moved = evaluator(after(document, SetTransform{painted_ball, there}), 1);
    EXPECT_EQ(count_stage(moved, "rays"), 0);
    EXPECT_EQ(count_stage(moved, "tiles"), 1);
    EXPECT_EQ(evaluator(after(document, SetTransform{painted_ball, there}), 1).objects.at(stud_id),
              moved.objects.at(stud_id));
}

TEST(PaintedTiles, AreTheSameForAnyNumberOfThreads)
{
    const auto with = [](int threads) {
        const ThreadLimit limit(threads);
        return digest(evaluation_of(painted_document()));
    };
    EXPECT_EQ(with(1), with(2));
}

TEST(PaintedTiles, FollowTheLookOfTheirLayer)
{
    const Document document = painted_document();
    const auto highest = [](const Document& of) {
        const Evaluation all = evaluation_of(of);
        double most = 0;
        for (const glm::vec3& p : shown_in(all, stud_id).parts.at(0).mesh()->positions)
            most = std::max(most, static_cast<double>(glm::length(p)));
        return most;
    };
    EXPECT_NEAR(highest(after(document, SetTiles{{stud_id}, {.height = 0.5}})), 0.525, 0.004);
    EXPECT_NEAR(highest(after(document, SetTiles{{stud_id}, {.scale = 0.5}})), 0.525, 0.004);
    EXPECT_NEAR(highest(after(document, SetTiles{{stud_id}, {.sink = 0.5}})), 0.525, 0.004);
}

TEST(PaintedTiles, FillTheirPlaceWithTheirCell)
{
    const Document document = painted_document();
    const auto box = [&](const TileLook& look) {
        const Evaluation all = evaluation_of(after(document, SetTiles{{stud_id}, look}));
        return shown_in(all, stud_id).parts.at(0).tiles->model->box;
    };
    TileLook look;
    look.cell_x0 = look.cell_y0 = 0.25;
    look.cell_x1 = look.cell_y1 = 0.75;
    look.base_level = 0.2;
    const Box whole = box({}), part = box(look);
    EXPECT_NEAR(part.size().x, 2 * whole.size().x, 1e-6); // twice as wide as its place
    EXPECT_NEAR(part.size().y, 2 * whole.size().y, 1e-6);
    EXPECT_NEAR(part.center().x, 0.5, 1e-6);
    EXPECT_NEAR(part.lo.z, -0.2 * part.size().z, 1e-5);
}

TEST(PaintedTiles, TakeKeys)
{
    const Document document =
        after(painted_document(),
              Animate{{{stud_id,
                        {{.parameter = "tiles.height",
                          .keys = {{.frame = 1, .value = 0.5}, {.frame = 11, .value = 1}}}}}}});
    EXPECT_NE(digest(evaluation_of(document, 1)), digest(evaluation_of(document, 11)));
    EXPECT_EQ(digest(evaluation_of(document, 11)), digest(evaluation_of(painted_document(), 11)));
}

TEST(PaintedTiles, GrowByKeysInTheOrderOfPainting)
{
    const Document document =
        after(painted_document(),
              Animate{{{stud_id,
                        {{.parameter = "tiles.growth",
                          .keys = {{.frame = 1, .value = 0}, {.frame = 21, .value = 1}}}}}}});
    EXPECT_TRUE(shown_in(evaluation_of(document, 1), stud_id).shows_nothing());
    std::size_t before = 0;
    for (int frame = 5; frame <= 21; frame += 4) {
        const std::size_t now = tile_count(evaluation_of(document, frame));
        EXPECT_GE(now, before);
        before = now;
    }
    EXPECT_EQ(digest(evaluation_of(document, 21)), digest(evaluation_of(painted_document(), 21)));
    const Evaluation half = evaluation_of(document, 11);
    EXPECT_LT(tile_count(half), tile_count(evaluation_of(painted_document())));
    EXPECT_THAT(shown_in(half, stud_id).notices, ::testing::IsEmpty());
}

TEST(PaintedTiles, WaveUpAndDown)
{
    TileLook look;
    look.wave = 0.5;
    const auto highest = [&](double phase) {
        look.wave_phase = phase;
        const Evaluation all = evaluation_of(after(painted_document(), SetTiles{{stud_id}, look}));
        double most = 0;
        for (const glm::vec3& p : shown_in(all, stud_id).parts.at(0).mesh()->positions)
            most = std::max(most, static_cast<double>(glm::length(p)));
        return most;
    };
    EXPECT_NEAR(highest(0), 0.65, 0.006);
    EXPECT_NEAR(highest(0.25), 0.775, 0.009);
    EXPECT_NEAR(highest(0.75), 0.525, 0.004);
    EXPECT_NEAR(highest(1.25), highest(0.25), 1e-6);
}

TEST(PaintedTiles, SayWhatBecameOfTheirBase)
{
    const Document document = painted_document();
    const Document alone = after(document, Delete{{painted_ball}});
    EXPECT_EQ(object(alone, stud_id).tiles->base, 0);
    const Evaluation gone = evaluation_of(alone);
    EXPECT_TRUE(shown_in(gone, stud_id).shows_nothing());
    EXPECT_THAT(shown_in(gone, stud_id).notices,
                ::testing::Contains(::testing::HasSubstr("no longer")));
    // Hidden, it carries them still.
    EXPECT_EQ(tile_count(evaluation_of(after(document, Hide{{painted_ball}}))),
              tile_count(evaluation_of(document)));
}

TEST(PaintedTiles, ThatAreFarTooLargeSayWhyNoneIsThere)
{
    TileStroke stroke = a_tile_stroke();
    stroke.size = 100;
    for (const TileBrush brush : {TileBrush::scatter, TileBrush::line, TileBrush::fill}) {
        stroke.brush = brush;
        const Evaluation all = evaluation_of(after(after(fitting_document(), ClearTiles{{stud_id}}),
                                                   PaintTiles{stud_id, painted_ball, stroke}));
        EXPECT_FALSE(shown_in(all, stud_id).notices.empty());
    }
}

TEST(PaintedTiles, OnAnotherShapeOfTheirBaseArePutOnThat)
{
    const Document document = painted_document();
    Document larger = document;
    Object other = object(document, painted_ball);
    other.source = SphereShape{.radius = 0.42, .segments = 40, .rings = 20};
    larger.objects.set(painted_ball, make_ref(other));
    EXPECT_GT(tile_count(evaluation_of(larger)), 20u);
    other.source = SphereShape{.radius = 4};
    larger.objects.set(painted_ball, make_ref(other));
    const Evaluation lost = evaluation_of(larger);
    EXPECT_TRUE(shown_in(lost, stud_id).parts.empty());
    EXPECT_THAT(shown_in(lost, stud_id).notices,
                ::testing::Contains(::testing::HasSubstr("no longer on the surface")));
}

TEST(PaintedTiles, AreCopiedWithAndWithoutTheirBase)
{
    const Document document = painted_document();
    const Id first = document.next_id;
    const Document both = after(document, Duplicate{{stud_id, painted_ball}, {5, 0, 0}});
    EXPECT_EQ(object(both, first).tiles->base, first + 1);
    EXPECT_EQ(tile_count(evaluation_of(document)) * 1, tile_count(evaluation_of(both)));
    const Document alone = after(document, Duplicate{{stud_id}, {5, 0, 0}});
    EXPECT_EQ(object(alone, first).tiles->base, painted_ball);
    const Document pasted = after(document, copied(document, {stud_id, painted_ball}, ""));
    const Document here = after(document, copied(document, {stud_id}, ""));
    EXPECT_EQ(object(here, first).tiles->base, painted_ball);
    EXPECT_EQ(*object(here, first).tiles->strokes.at(0),
              *object(document, stud_id).tiles->strokes.at(0));
    std::vector<Id> bases;
    for (const auto& [id, each] : pasted.objects)
        if (id >= first && each->tiles) bases.push_back(each->tiles->base);
    ASSERT_EQ(bases.size(), 1u);
    EXPECT_GE(bases.front(), first);
    EXPECT_FALSE(object(after(Document{}, copied(document, {stud_id}, "")), 1).tiles);
}

TEST(PaintedTiles, AreCopiedWithoutAnyStroke)
{
    const Document document = after(after(painted_document(), RemoveTileStrokes{stud_id, {}}),
                                    SetTiles{{stud_id}, {.height = 3}});
    const Document pasted = after(document, copied(document, {stud_id}, ""));
    EXPECT_EQ(object(pasted, document.next_id).tiles, object(document, stud_id).tiles);
}

TEST(PaintedTiles, ThatNoMachineCouldHoldAreRefusedWithTheirNumbers)
{
    Document document = painted_document();
    Object many = object(document, stud_id);
    many.source = SphereShape{.radius = 0.1, .segments = 2000, .rings = 1000};
    document.objects.set(stud_id, make_ref(many));
    const Evaluation refused = evaluation_of(document);
    EXPECT_TRUE(shown_in(refused, stud_id).shows_nothing());
    EXPECT_THAT(shown_in(refused, stud_id).notices,
                ::testing::Contains(::testing::HasSubstr("lay fewer or larger ones")));
}

TEST(PaintedTiles, RefuseWhatMakesNoSense)
{
    const Document document = painted_document();
    const TileStroke stroke = a_tile_stroke();
    expect_no_tiles(document, PaintTiles{stud_id, stud_id, stroke}, "on itself");
    expect_no_tiles(document, PaintTiles{painted_ball, stud_id, stroke}, "depends on");
    expect_no_tiles(document, PaintTiles{stud_id, 1, stroke}, "is painted on");
    expect_no_tiles(document, PaintTiles{3, painted_ball, stroke}, "lies on a stroke");
    expect_no_tiles(document, PaintTiles{4, painted_ball, stroke}, "no shape");
    expect_no_tiles(document, PaintTiles{1, 4, stroke}, "no surface");
    expect_no_tiles(document, PaintTiles{1, painted_ball, TileStroke{}}, "samples");
    TileStroke crooked = stroke;
    crooked.samples[0].at.normal = {0, 0, 0};
    expect_no_tiles(document, PaintTiles{1, painted_ball, crooked}, "normal");
    expect_no_tiles(document, EditTileStroke{stud_id, 2, stroke}, "none of number 2");
    expect_no_tiles(document, EditTileStroke{painted_ball, 1, stroke}, "no layer of tiles");
    expect_no_tiles(
        document, Place{.object = stud_id, .sketch = small_sketch(), .parameters = {}, .onto = {}},
        "layer of tiles");
}

TEST(PaintedTiles, StrokesAreChangedAndRemovedOneByOne)
{
    Document document = painted_document();
    TileStroke erase = a_tile_stroke();
    erase.brush = TileBrush::erase;
    erase.radius = 0.08;
    document = after(document, PaintTiles{stud_id, painted_ball, erase});
    const std::size_t fewer = tile_count(evaluation_of(document));
    EXPECT_LT(fewer, tile_count(evaluation_of(painted_document())));
    erase.hidden = true;
    EXPECT_EQ(tile_count(evaluation_of(after(document, EditTileStroke{stud_id, 2, erase}))),
              tile_count(evaluation_of(painted_document())));
    EXPECT_EQ(
        after(document, RemoveTileStrokes{stud_id, {2}}).objects.at(stud_id)->tiles->strokes.size(),
        1u);
    EXPECT_TRUE(evaluation_of(after(document, RemoveTileStrokes{stud_id, {}}))
                    .objects.at(stud_id)
                    ->shows_nothing());
}

} // namespace
} // namespace trivar
