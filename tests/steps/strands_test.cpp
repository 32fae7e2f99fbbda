// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "tests/steps/strands.h"
#include "tests/support/scenes/commands.h"

#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;
using namespace testing::strands;

TEST(StrandLayers, AreOneRibbonToTheLastBit)
{
    const StrandCounts strand = counted(with_strand());
    EXPECT_GT(strand.tiles, 10u);
    EXPECT_EQ(strand.points, points_of_open(strand.tiles));
    EXPECT_TRUE(notices_of(with_strand()).empty());
    const StrandCounts closed = counted(with_strand(0, glm::two_pi<double>()));
    EXPECT_EQ(closed.points, closed.tiles * ribbon_columns * (ribbon_rows + 1));
}

TEST(StrandLayers, StayOneWhereTheirBaseMovesIsBentOrSeenInAMirror)
{
    const Document document = with_strand();
    Transform there;
    there.translation = {100, 0.1, 7};
    there.rotation_deg = {10, 20, 30};
    for (const glm::dvec3& scale : {glm::dvec3(2, 0.7, 1), glm::dvec3(-1, 1, 1.3)}) {
        there.scale = scale;
        const StrandCounts moved = counted(after(document, SetTransform{strand_base, there}));
        EXPECT_GT(moved.tiles, 10u);
        EXPECT_EQ(moved.points, points_of_open(moved.tiles));
    }
    const Document lattice = after(document, AddLattice{.objects = {strand_base}});
    const Document bent = after(lattice, WarpVolume{.object = 3, .warp = {.taper = 0.5}});
    const StrandCounts in_lattice = counted(bent);
    EXPECT_GT(in_lattice.tiles, 10u);
    EXPECT_EQ(in_lattice.points, points_of_open(in_lattice.tiles));
}

TEST(StrandLayers, StayOneWhereTilesAreLowered)
{
    TileLook tall;
    tall.height = 100;
    tall.sink = 0;
    Document document = with_strand();
    AddTorus ring; // inside of which tall tiles would fold
    ring.shape = {.radius = 1, .tube = 0.4, .segments = {64, 32}};
    Object base = object(document, strand_base);
    base.source = ring.shape;
    document.objects.set(strand_base, make_ref(base));
    TileStroke inside;
    inside.brush = TileBrush::strand;
    inside.size = 0.15;
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 out(std::cos(0.2 * i), std::sin(0.2 * i), 0);
        inside.samples.push_back({{0.6 * out, -out}, 0.1 * i, 1});
    }
    document = after(document, EditTileStroke{strand_tile_id, 1, inside});
    // A tile with some height: the ribbon upright.
    Transform upright;
    upright.rotation_deg = {60, 0, 0};
    document = after(document, SetTransform{strand_tile_id, upright});
    tall.height = 12;
    document = after(document, SetTiles{{strand_tile_id}, tall});
    const StrandCounts lowered = counted(document);
    EXPECT_GT(lowered.tiles, 10u);
    EXPECT_EQ(lowered.points, points_of_open(lowered.tiles));
    EXPECT_THAT(notices_of(document), ::testing::Contains(::testing::HasSubstr("lowered")));
}

TEST(StrandLayers, AreOneOnALimitSurface)
{
    ImportModel torus;
    torus.file.path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/cages/torus.obj";
    torus.file.subdivisions = 2;
    AddPlane ribbon;
    ribbon.shape = {.size = {0.2, 0.1}, .segments = {ribbon_columns, ribbon_rows}};
    Document document = after(after(Document{}, torus), ribbon);
    const Evaluation shown = new_evaluator()(document, 1);
    const Box box = *shown.objects.at(strand_base)->bounds;
    TileStroke stroke; // round the outside of the ring, seen from its middle
    stroke.brush = TileBrush::strand;
    stroke.size = 0.1;
    const glm::dvec3 middle = box.center();
    for (int i = 0; i <= 24; ++i) {
        const double a = glm::two_pi<double>() * i / 24;
        const glm::dvec3 out(std::cos(a), std::sin(a), 0);
        stroke.samples.push_back({{middle + 0.5 * box.size().x * out, out}, 0.1 * i, 1});
    }
    document = after(document, PaintTiles{strand_tile_id, strand_base, stroke});
    const StrandCounts closed = counted(document);
    EXPECT_GT(closed.tiles, 10u);
    EXPECT_EQ(closed.points, closed.tiles * ribbon_columns * (ribbon_rows + 1));
    EXPECT_TRUE(notices_of(document).empty());
}

TEST(StrandLayers, GrowAlongTheirPath)
{
    const auto at = [](double growth) {
        return counted(after(with_strand(), SetTiles{{strand_tile_id}, {.growth = growth}}));
    };
    const std::size_t all = counted(with_strand()).tiles;
    EXPECT_EQ(at(0).tiles, 0u);
    EXPECT_NEAR(static_cast<double>(at(0.5).tiles), 0.5 * static_cast<double>(all), 1.01);
    EXPECT_EQ(at(0.5).points, points_of_open(at(0.5).tiles)); // the one that grows fits, too
}

TEST(StrandLayers, OverlapAndTurnEveryOtherTile)
{
    const auto parts = [](const TileLook& look) {
        return new_evaluator()(after(with_strand(), SetTiles{{strand_tile_id}, look}), 1)
            .objects.at(strand_tile_id)
            ->parts;
    };
    EXPECT_EQ(parts({}).size(), 1u);
    const std::vector<Part> alternate = parts({.alternate_deg = 90});
    ASSERT_EQ(alternate.size(), 2u);
    const Box flat = alternate[0].tiles->model->box, upright = alternate[1].tiles->model->box;
    EXPECT_NEAR(flat.size().z, 0, 1e-6);
    EXPECT_NEAR(upright.size().z, 0.5, 1e-6); // as high as the ribbon is wide, in lengths
    EXPECT_NEAR(flat.center().z, upright.center().z, 1e-6);
    EXPECT_NEAR(upright.lo.z, 0, 1e-6);
    const Box over = parts({.overlap = 0.25})[0].tiles->model->box;
    EXPECT_NEAR(over.lo.x, -0.25, 1e-6);
    EXPECT_NEAR(over.hi.x, 1.25, 1e-6);
}

TEST(StrandLayers, FillTheirCellWithAPartOfTheTile)
{
    TileLook look;
    look.cell_x0 = 0.25;
    look.cell_x1 = 0.75;
    const Document document = after(with_strand(), SetTiles{{strand_tile_id}, look});
    const Box box =
        new_evaluator()(document, 1).objects.at(strand_tile_id)->parts[0].tiles->model->box;
    EXPECT_NEAR(box.lo.x, -0.5, 1e-6);
    EXPECT_NEAR(box.hi.x, 1.5, 1e-6);
    look.cell_x1 = 0.2;
    EXPECT_THROW(after(document, SetTiles{{strand_tile_id}, look}), Rejected);
}

TEST(StrandLayers, AreTheSameForAnyNumberOfThreads)
{
    const auto with = [](int threads) {
        const ThreadLimit limit(threads);
        return digest(new_evaluator()(with_strand(), 1));
    };
    EXPECT_EQ(with(1), with(2));
}

TEST(StrandLayers, SayWhatIsWrong)
{
    TileStroke one = strand_round_the_ball(0, 3);
    one.samples.resize(1);
    const Document document = after(with_ribbon(), PaintTiles{strand_tile_id, strand_base, one});
    EXPECT_THAT(notices_of(document), ::testing::Contains(::testing::HasSubstr("too short")));
    TileStroke off = strand_round_the_ball(0, 3);
    for (TileSample& each : off.samples) each.at.p *= 5;
    EXPECT_THAT(notices_of(after(with_ribbon(), PaintTiles{strand_tile_id, strand_base, off})),
                ::testing::Contains(::testing::HasSubstr("no longer on the surface")));
    // A tile of which one end is higher than the other.
    Transform tilted;
    tilted.rotation_deg = {0, 20, 0};
    EXPECT_THAT(notices_of(after(with_strand(), SetTransform{strand_tile_id, tilted})),
                ::testing::Contains(::testing::HasSubstr("do not match")));
}

} // namespace
} // namespace trivar
