// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/tiles/fold_limit.h"
#include "tests/steps/strands.h"
#include "tests/support/scenes/commands.h"

#include <cstring>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <set>

// Strands that slide, and strands under masks.
namespace trivar {
namespace {

using namespace testing;
using namespace testing::strands;

using PointBits = std::set<std::array<std::uint32_t, 3>>;
PointBits points_of(const Document& document)
{
    PointBits out;
    const Evaluation all = new_evaluator()(document, 1);
    for (const Part& part : all.objects.at(strand_tile_id)->parts)
        for (const glm::vec3& p : part.mesh()->positions) {
            std::array<std::uint32_t, 3> bits{};
            std::memcpy(bits.data(), &p, sizeof bits);
            out.insert(bits);
        }
    return out;
}

Document slid(const Document& document, double sides)
{
    return after(document, SetTiles{{strand_tile_id}, {.slide_along = sides}});
}

TEST(StrandLayers, SlideAlongTheirPathAndStayOne)
{
    const Document open = with_strand(), closed = with_strand(0, glm::two_pi<double>());
    const std::size_t of_open = counted(open).tiles, of_closed = counted(closed).tiles;
    for (const double sides : {0.5, 1.3, -2.25, 0.01, 400.9}) {
        SCOPED_TRACE(sides);
        const StrandCounts there = counted(slid(open, sides)), round = counted(slid(closed, sides));
        EXPECT_EQ(there.tiles, of_open + 1); // one leaves and comes in at once
        EXPECT_EQ(there.points, points_of_open(there.tiles));
        EXPECT_EQ(round.tiles, of_closed);
        EXPECT_EQ(round.points, round.tiles * ribbon_columns * (ribbon_rows + 1));
    }
    for (const double sides : {1.0, -3.0, 100.0}) { // all tiles are alike
        EXPECT_EQ(points_of(slid(open, sides)), points_of(open));
        EXPECT_EQ(points_of(slid(closed, sides)), points_of(closed));
    }
}

TEST(StrandLayers, StayOnTheirWayWhereTheySlide)
{
    // Every point of a slid ribbon on a ball is as far from its middle as those of the ribbon.
    const auto farthest = [](const Document& document) {
        double least = 1e300, most = 0;
        const Evaluation all = new_evaluator()(document, 1);
        for (const Part& part : all.objects.at(strand_tile_id)->parts)
            for (const glm::vec3& p : part.mesh()->positions) {
                const double r = glm::length(glm::dvec3(p));
                least = std::min(least, r), most = std::max(most, r);
            }
        return glm::dvec2(least, most);
    };
    const glm::dvec2 still = farthest(with_strand());
    for (const double sides : {0.2, 0.5, 0.85}) {
        const glm::dvec2 there = farthest(slid(with_strand(), sides));
        EXPECT_NEAR(there.x, still.x, 1e-3);
        EXPECT_NEAR(there.y, still.y, 1e-3);
    }
}

TEST(StrandLayers, SlideWithTheirColours)
{
    // The colours of tiles, from one end to the other.
    const auto tints = [](const Document& document) {
        std::vector<glm::vec3> out;
        const Evaluation all = new_evaluator()(document, 1);
        for (const PlacedTile& tile : *all.objects.at(strand_tile_id)->parts[0].tiles->tiles)
            out.push_back(tile.tint);
        return out;
    };
    TileStroke red = strand_round_the_ball(0, 3);
    red.brush = TileBrush::color;
    red.color = {1, 0, 0};
    red.strength = 1;
    red.radius = 0.15;
    red.samples.resize(1);
    const Document document = after(with_strand(), PaintTiles{strand_tile_id, strand_base, red});
    const std::vector<glm::vec3> still = tints(document), there = tints(slid(document, 3));
    ASSERT_EQ(still.size(), there.size());
    EXPECT_LT(still[0].g, 0.9f);
    EXPECT_EQ(still.back(), glm::vec3(1));
    for (std::size_t k = 0; k < still.size(); ++k)
        EXPECT_EQ(there[(k + 3) % still.size()], still[k]) << k;
    const Evaluation all = new_evaluator()(document, 1);
    const Part& part = all.objects.at(strand_tile_id)->parts[0];
    ASSERT_EQ(part.mesh()->colors.size(), part.mesh()->vertex_count());
    EXPECT_EQ(glm::vec3(part.mesh()->colors[0]), still[0]);
}

TileMask across_the_ball(MaskDrives drives, double low, double high)
{
    TileMask mask;
    mask.drives = drives;
    mask.from = MaskFrom::line;
    mask.begin = {1, 0, 0};
    mask.end = {-1, 0, 0};
    mask.low = low;
    mask.high = high;
    return mask;
}

TEST(StrandLayers, TakeMasksAndStayOne)
{
    const Document document = with_strand();
    const StrandCounts all = counted(document);
    const auto masked = [&](MaskDrives drives, double low, double high) {
        return after(document, MaskTiles{strand_tile_id, 0, across_the_ball(drives, low, high)});
    };
    const Document scaled = masked(MaskDrives::scale, 0.4, 1.5);
    EXPECT_EQ(counted(scaled).points, points_of_open(all.tiles));
    const auto width_of = [](const Document& d, bool last) {
        const Evaluation shown = new_evaluator()(d, 1);
        const PlacedTiles& tiles = *shown.objects.at(strand_tile_id)->parts[0].tiles->tiles;
        const TilePatch& patch = (last ? tiles[tiles.size() - 1] : tiles[0]).patch;
        return glm::distance(tile_point(patch, {0.5, 0, 0}).p, tile_point(patch, {0.5, 1, 0}).p);
    };
    EXPECT_NEAR(width_of(scaled, false) / width_of(document, false), 0.4, 0.05);
    EXPECT_NEAR(width_of(scaled, true) / width_of(document, true), 1.5, 0.05);
    // Where tiles are left out the others stay, to the last bit.
    const Document thinned = masked(MaskDrives::density, 0, 1);
    const StrandCounts left = counted(thinned);
    EXPECT_LT(left.tiles, all.tiles);
    EXPECT_GT(left.tiles, 0u);
    const PointBits before = points_of(document);
    for (const auto& p : points_of(thinned)) EXPECT_TRUE(before.contains(p));
    EXPECT_EQ(counted(masked(MaskDrives::density, 0, 0)).tiles, 0u);
    EXPECT_EQ(points_of(masked(MaskDrives::density, 1, 1)), before);
}

// An upright ribbon, which has a height.
Document with_upright_ribbon(double height)
{
    Transform upright;
    upright.rotation_deg = {60, 0, 0};
    const Document document = after(with_strand(), SetTransform{strand_tile_id, upright});
    return after(document, SetTiles{{strand_tile_id}, {.height = height}});
}

TEST(StrandLayers, AreAsHighAsAMaskSays)
{
    const Document document = with_upright_ribbon(1);
    const Document masked =
        after(document, MaskTiles{strand_tile_id, 0, across_the_ball(MaskDrives::height, 0, 2)});
    EXPECT_EQ(counted(masked).points, points_of_open(counted(document).tiles));
    const auto highest = [](const Document& d) {
        double most = 0;
        const Evaluation all = new_evaluator()(d, 1);
        for (const Part& part : all.objects.at(strand_tile_id)->parts)
            for (const glm::vec3& p : part.mesh()->positions)
                most = std::max(most, glm::length(glm::dvec3(p)) - 1);
        return most;
    };
    EXPECT_NEAR(highest(masked) / highest(document), 2, 0.1);
}

TEST(StrandLayers, MorphByAMask)
{
    AddPlane narrow;
    narrow.shape = {.size = {0.2, 0.03}, .segments = {ribbon_columns, ribbon_rows}};
    Document document = after(with_strand(), narrow);
    document = after(document, MorphTiles{strand_tile_id, 3});
    document = after(document, SetTiles{{strand_tile_id}, {.morph = 1}});
    document =
        after(document, MaskTiles{strand_tile_id, 0, across_the_ball(MaskDrives::morph, 0, 1)});
    const Evaluation all = new_evaluator()(document, 1);
    const std::vector<Part>& parts = all.objects.at(strand_tile_id)->parts;
    ASSERT_GT(parts.size(), 3u); // one for each phase
    EXPECT_GT(parts.front().tiles->model->box.size().y,
              2 * parts.back().tiles->model->box.size().y);
}

TEST(StrandLayers, WavesDifferFromTileToTileAndStayOne)
{
    const Document document = with_upright_ribbon(1);
    const auto wave = [&](double variation) {
        return after(document,
                     SetTiles{{strand_tile_id}, {.wave = 0.5, .wave_variation = variation}});
    };
    EXPECT_NE(points_of(wave(0.5)), points_of(wave(0)));
    EXPECT_EQ(counted(wave(0.5)).points, points_of_open(counted(document).tiles));
}

// The least room between a tile and the height up to which its patch does not fold, as a share.
double least_room(const Document& document)
{
    double least = 1;
    const Evaluation all = new_evaluator()(document, 1);
    for (const Part& part : all.objects.at(strand_tile_id)->parts)
        for (const PlacedTile& tile : *part.tiles->tiles) {
            const double top = part.tiles->model->box.hi.z * tile.height + tile.base;
            least = std::min(least, 1 - top / fold_limit(tile.patch));
        }
    return least;
}

TEST(StrandLayers, DoNotFoldWhereTheySlideOrAreMasked)
{
    Document document = with_upright_ribbon(1);
    Object base = object(document, strand_base); // a ring, inside of which tall tiles would fold
    base.source = TorusShape{.radius = 1, .tube = 0.4, .segments = {64, 32}};
    document.objects.set(strand_base, make_ref(base));
    TileStroke inside = strand_round_the_ball(0, 3);
    for (std::size_t i = 0; i < inside.samples.size(); ++i) {
        const double a = 0.15 * static_cast<double>(i);
        const glm::dvec3 out(std::cos(a), std::sin(a), 0);
        inside.samples[i].at = {0.6 * out, -out};
    }
    document = after(document, EditTileStroke{strand_tile_id, 1, inside});
    document =
        after(document, MaskTiles{strand_tile_id, 0, across_the_ball(MaskDrives::height, 0.1, 3)});
    for (const double sides : {0.0, 0.3, 5.75}) {
        const Document tall =
            after(document, SetTiles{{strand_tile_id}, {.height = 12, .slide_along = sides}});
        EXPECT_THAT(notices_of(tall), ::testing::Contains(::testing::HasSubstr("lowered")));
        EXPECT_GT(least_room(tall), 0);
    }
    // The limit that is shown: no tile is lowered up to it, and one is above.
    const auto shown_at = [&](double height) {
        return new_evaluator()(after(document, SetTiles{{strand_tile_id}, {.height = height}}), 1)
            .objects.at(strand_tile_id);
    };
    const double limit = shown_at(1)->height_limit;
    ASSERT_GT(limit, 0);
    ASSERT_LT(limit, 100);
    EXPECT_NEAR(shown_at(2)->height_limit / limit, 1, 1e-9);
    EXPECT_EQ(shown_at(1)->stroke_limits.at(0), limit);
    EXPECT_TRUE(shown_at(0.999 * limit)->notices.empty());
    EXPECT_THAT(shown_at(1.01 * limit)->notices,
                ::testing::Contains(::testing::HasSubstr("lowered")));
    float most = 0;
    const Ref<EvaluatedObject> shown = shown_at(limit);
    for (const PlacedTile& tile : *shown->parts[0].tiles->tiles)
        most = std::max(most, tile.of_limit);
    EXPECT_NEAR(most, 1, 1e-5);
}

} // namespace
} // namespace trivar
