// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/tiles/tiles.h"
#include "core/mesh/closed_body.h"
#include "tests/support/scenes/cut_ball.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace trivar {
namespace {

using testing::across;
using testing::drawn_over_two;
using testing::new_evaluator;
using testing::one_ball;
using testing::shown_first;
using testing::volume_of;

// The ball and boxes on it, object 2, all over.
Document tiled_ball()
{
    Document document =
        after(one_ball(), AddBox{.shape = {.size = {0.2, 0.2, 0.1}, .segments = {1, 1, 1}}});
    TileStroke fill;
    fill.brush = TileBrush::fill;
    fill.size = 0.2;
    fill.samples = {{{{0, -1, 0}, {0, -1, 0}}}};
    return after(document, PaintTiles{2, 1, fill});
}

Ref<EvaluatedObject> shown_tiles(const Document& document)
{
    return new_evaluator()(document, 1).objects.at(2);
}

TEST(Cutting, CutsALayerOfTiles)
{
    CutThrough through_tiles = across(0.3);
    through_tiles.objects = {2};
    const Ref<EvaluatedObject> tiles = shown_tiles(after(tiled_ball(), through_tiles));
    ASSERT_EQ(tiles->parts.size(), 4u); // whole tiles and cut ones, below and above
    for (const Part& part : tiles->parts) {
        const Box box = bounds_in_world(part);
        EXPECT_TRUE(box.hi.z < 0.2 - 0.1499 || box.lo.z > 0.2 + 0.1499);
    }
}

TEST(Cutting, TakesTilesAlongWithWhatTheyArePaintedOn)
{
    const Document document = tiled_ball();
    const Ref<EvaluatedObject> whole = shown_tiles(document),
                               tiles = shown_tiles(after(document, across(0.3)));
    EXPECT_EQ(tiles->painted, whole->painted); // they are laid on the ball as it was
    EXPECT_TRUE(tiles->notices.empty());
    ASSERT_EQ(tiles->parts.size(), 4u);
    EXPECT_NEAR(volume_of(*tiles), volume_of(*whole), 1e-5);
    std::size_t drawn_as_tiles = 0;
    std::set<PartKey> keys;
    for (const Part& part : tiles->parts) {
        keys.insert(part.key);
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        const Box box = bounds_in_world(part);
        EXPECT_TRUE(box.hi.z < 0.2 - 0.1499 || box.lo.z > 0.2 + 0.1499);
        if (part.drawn_from_tiles()) drawn_as_tiles += part.tiles->tiles->size();
    }
    EXPECT_EQ(keys.size(), 4u);
    EXPECT_GT(drawn_as_tiles, whole->painted * 3 / 4);
}

TEST(Cutting, TakesTilesAlongWithPiecesThatWereCutWhereTheyStood)
{
    const PlainCut second{
        .point = {0.1, 0, 0}, .normal = {1, 0, 0.7}, .gap = 0.2, .opened = {{0, 0, 0.25}}};
    const Document document = tiled_ball();
    const Ref<EvaluatedObject> whole = shown_tiles(document),
                               tiles = shown_tiles(after(document, drawn_over_two(second)));
    EXPECT_NEAR(volume_of(*tiles), volume_of(*whole), 1e-5);
    const glm::dvec3 normal = glm::normalize(second.normal);
    for (const Part& part : tiles->parts) {
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        double least = 1e300, most = -1e300;
        for (const glm::vec3& p : part.mesh()->positions) {
            const glm::dvec3 at(part.to_world * glm::dvec4(glm::dvec3(p), 1));
            const double height = glm::dot(at - second.point, normal);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        EXPECT_TRUE(least > 0.0999 || most < -0.0999); // half of its gap
    }
}

TEST(Cutting, AddsTheCutsOfALayerToThoseOfItsBase)
{
    CutThrough own = across(0.2);
    own.objects = {2};
    own.cutting.cuts[0].normal = {1, 0, 0};
    own.cutting.cuts[0].point = {0.1, 0, 0};
    const Document document = tiled_ball();
    const Ref<EvaluatedObject> whole = shown_tiles(document);
    for (const bool base_first : {true, false}) {
        const Document first = after(document, base_first ? across(0.3) : own);
        const Ref<EvaluatedObject> tiles =
            shown_tiles(after(first, base_first ? own : across(0.3)));
        EXPECT_TRUE(tiles->notices.empty());
        EXPECT_EQ(tiles->painted, whole->painted);
        EXPECT_NEAR(volume_of(*tiles), volume_of(*whole), 1e-5);
        std::set<PartKey> keys;
        std::set<int> quarters;
        for (const Part& part : tiles->parts) {
            keys.insert(part.key);
            EXPECT_TRUE(is_closed_body(*part.mesh()));
            const Box box = bounds_in_world(part);
            EXPECT_TRUE(box.hi.z < 0.2 - 0.1499 || box.lo.z > 0.2 + 0.1499);
            EXPECT_TRUE(box.hi.x < 0.1 - 0.0999 || box.lo.x > 0.1 + 0.0999);
            quarters.insert((box.lo.z > 0.2 ? 2 : 0) + (box.lo.x > 0.1 ? 1 : 0));
        }
        EXPECT_EQ(keys.size(), tiles->parts.size());
        EXPECT_EQ(quarters.size(), 4u);
    }
}

TEST(Cutting, TakesTilesAwayWithAHalf)
{
    const Document document = tiled_ball();
    const Ref<EvaluatedObject> whole = shown_tiles(document);
    double sum = 0;
    for (const CutKeep keep : {CutKeep::above, CutKeep::below}) {
        const Ref<EvaluatedObject> kept = shown_tiles(after(document, across(0.3, keep)));
        ASSERT_EQ(kept->parts.size(), 2u);
        for (const Part& part : kept->parts) // a half that stays does not move
            EXPECT_TRUE(keep == CutKeep::above ? bounds_in_world(part).lo.z > 0.1999
                                               : bounds_in_world(part).hi.z < 0.2001);
        sum += volume_of(*kept);
    }
    EXPECT_NEAR(sum, volume_of(*whole), 1e-5);
    CutThrough nothing = across(0, CutKeep::above);
    nothing.cutting.cuts[0].point = {0, 0, 5};
    const Ref<EvaluatedObject> gone = shown_tiles(after(document, nothing));
    EXPECT_TRUE(gone->parts.empty());
    EXPECT_TRUE(gone->notices.empty()); // the ball's notice says it
}

TEST(Cutting, CutsTilesByAStrokeInTheSpaceOfTheirBase)
{
    CutThrough wave = across(0.3);
    wave.cutting.cuts[0].stroke = {{-1, 0}, {-0.3, 0.25}, {0.4, -0.2}, {1, 0.1}};
    wave.cutting.cuts[0].eye = 6;
    Transform turned;
    turned.translation = {3, 0, 0};
    turned.rotation_deg = {20, 70, 10};
    turned.scale = {2, 2, 2};
    Document document = after(tiled_ball(), wave);
    const Ref<EvaluatedObject> before = shown_tiles(document);
    document = after(document, SetTransform{.object = 1, .transform = turned});
    const Ref<EvaluatedObject> ball = shown_first(document), tiles = shown_tiles(document);
    ASSERT_EQ(tiles->parts.size(), before->parts.size());
    EXPECT_NEAR(volume_of(*tiles), 8 * volume_of(*before), 0.02);
    for (const Part& part : tiles->parts) EXPECT_TRUE(is_closed_body(*part.mesh()));
    // They go as far as the halves of the ball
    EXPECT_LT(glm::distance(glm::dvec3(tiles->parts.front().to_world[3]),
                            glm::dvec3(ball->parts[0].to_world[3]) - turned.translation),
              1e-12);
}

TEST(Cutting, TakesTilesOnTilesAlong)
{
    Document document =
        after(tiled_ball(), AddBox{.shape = {.size = {0.05, 0.05, 0.05}, .segments = {1, 1, 1}}});
    TileStroke fill;
    fill.brush = TileBrush::fill;
    fill.size = 0.05;
    fill.samples = {{{{0, -1.1, 0}, {0, -1, 0}}}};
    document = after(document, PaintTiles{3, 2, fill});
    const Ref<EvaluatedObject> upper =
        new_evaluator()(after(document, across(0.3, CutKeep::above)), 1).objects.at(3);
    for (const Part& part : upper->parts) EXPECT_GT(bounds_in_world(part).lo.z, 0.1999);
}

TEST(Cutting, MovesTilesWithoutBendingOrCuttingThemAgainWhileAGapOpens)
{
    Document document = after(tiled_ball(), across(0));
    document =
        after(document, Animate{{{1, {{"cutting.cuts.0.gap", {{1, 0, Tween::linear}, {11, 1}}}}}}});
    Evaluator evaluator = new_evaluator();
    const auto at = [&](double frame) {
        return evaluator(document_at(document, frame), frame).objects.at(2);
    };
    const Ref<EvaluatedObject> first = at(1), last = at(11);
    ASSERT_EQ(first->parts.size(), 4u);
    for (std::size_t p = 0; p < 4; ++p) {
        EXPECT_EQ(first->parts[p].key, last->parts[p].key);
        EXPECT_EQ(first->parts[p].tiles, last->parts[p].tiles);
        if (first->parts[p].tiles)
            EXPECT_FALSE(first->parts[p].rest.ready());
        else
            EXPECT_EQ(first->parts[p].rest, last->parts[p].rest);
    }
}

} // namespace
} // namespace trivar
