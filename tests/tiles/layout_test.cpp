// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

Mesh ball()
{
    return sphere_mesh(1, 96, 48);
}

TileStroke over_the_front(const TileBase& base)
{
    return stroke_over(base, {-0.7, -2, 0.1}, {0.7, -2, -0.1}, {0, 1, 0}, 30);
}

std::vector<Ref<TileStroke>> all(std::vector<TileStroke> strokes)
{
    std::vector<Ref<TileStroke>> out;
    for (TileStroke& each : strokes) out.push_back(make_ref(std::move(each)));
    return out;
}

double least_distance(const TileBase& base, const std::vector<Tile>& tiles)
{
    double least = 1e300;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least,
                             glm::distance(base.position(tiles[i].at), base.position(tiles[j].at)));
    return least;
}

TEST(TileLayouts, ScatterKeepsDistanceAndFillsTheBrush)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    ASSERT_EQ(stroke.samples.size(), 30u);
    stroke.radius = 0.3;
    stroke.size = 0.08;
    const std::vector<Tile> tiles = layout_of(base, all({stroke})).tiles.all();
    EXPECT_GE(least_distance(base, tiles), 0.08);
    // Discs of half the distance cover about half of the brushed area.
    const double covered = static_cast<double>(tiles.size()) * 0.04 * 0.04 * 3.14159;
    EXPECT_GT(covered, 0.4 * (1.5 * 0.6));
    for (const Tile& tile : tiles) { // none lies outside of the brush
        double away = 1e300;
        for (const TileSample& each : stroke.samples)
            away = std::min(away, glm::distance(each.at.p, base.position(tile.at)));
        EXPECT_LE(away, 0.3 + 0.03);
    }
}

TEST(TileLayouts, AStrokeHeadsAlongItsWay)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    stroke.radius = 0.1;
    for (const Tile& tile : layout_of(base, all({stroke})).tiles) {
        EXPECT_NEAR(glm::length(tile.x), 1, 1e-12);
        EXPECT_NEAR(glm::dot(tile.x, base.normal(tile.at)), 0, 1e-9);
        const glm::dvec3 n = base.normal(tile.at), right{1, 0, 0};
        EXPECT_GT(glm::dot(tile.x, glm::normalize(right - glm::dot(right, n) * n)), 0.9);
    }
    stroke.heading = TileHeading::upward;
    for (const Tile& tile : layout_of(base, all({stroke})).tiles) EXPECT_GT(tile.x.z, 0.9);
}

TEST(TileLayouts, ALineOfTilesHasEvenSteps)
{
    const TileBase base = base_of(plane_mesh({4, 4}, {7, 7}));
    TileStroke stroke = stroke_over(base, {-1, 0.1, 1}, {1, 0.1, 1}, {0, 0, -1}, 40);
    stroke.brush = TileBrush::line;
    stroke.size = 0.1;
    stroke.spacing = 1.5;
    const std::vector<Tile> tiles = layout_of(base, all({stroke})).tiles.all();
    ASSERT_EQ(tiles.size(), 14u); // 0, 0.15, ..., 1.95
    for (std::size_t i = 0; i < tiles.size(); ++i)
        EXPECT_LT(glm::distance(base.position(tiles[i].at),
                                glm::dvec3(-1 + 0.15 * static_cast<double>(i), 0.1, 0)),
                  1e-6);
}

TEST(TileLayouts, FillCoversOneBodyAndNoOther)
{
    Mesh two = ball();
    Mesh other = ball();
    const auto shift = static_cast<std::uint32_t>(two.positions.size());
    for (glm::vec3 p : other.positions) two.positions.push_back(p + glm::vec3(5, 0, 0));
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t c = other.face_begin[f]; c < other.face_begin[f + 1]; ++c)
            face.push_back(other.corners[c] + shift);
        add_face(two, face);
    }
    two.normals.clear();
    two.uvs.clear();
    two.points.clear();
    const TileBase base = base_of(std::move(two));
    TileStroke stroke = over_the_front(base);
    stroke.brush = TileBrush::fill;
    stroke.size = 0.15;
    const std::vector<Tile> tiles = layout_of(base, all({stroke})).tiles.all();
    EXPECT_GE(least_distance(base, tiles), 0.15);
    for (const Tile& tile : tiles) EXPECT_LT(base.position(tile.at).x, 1.1);
    std::mt19937 random(1);
    for (int k = 0; k < 500; ++k) { // a random place of the first body has a tile near
        const SurfacePlace at = random_place(base, random);
        if (base.position(at).x > 2) continue;
        double away = 1e300;
        for (const Tile& tile : tiles)
            away = std::min(away, glm::distance(base.position(tile.at), base.position(at)));
        EXPECT_LT(away, 2.2 * 0.15);
    }
}

TEST(TileLayouts, EraseCombResizeAndRaiseChangeWhatIsUnderTheBrushAlone)
{
    const TileBase base = base_of(ball());
    TileStroke paint = over_the_front(base);
    paint.radius = 0.3;
    TileStroke change = stroke_over(base, {0.2, -2, -0.3}, {0.2, -2, 0.3}, {0, 1, 0}, 20);
    change.radius = 0.2;
    change.strength = 0.5;
    const std::vector<Tile> before = layout_of(base, all({paint})).tiles.all();
    const auto under = [&](const Tile& tile) {
        for (const TileSample& each : change.samples)
            if (glm::distance(each.at.p, base.position(tile.at)) <= 0.2 - 1e-9) return true;
        return false;
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(before, under));
    ASSERT_GT(count, 5u);
    change.brush = TileBrush::erase;
    const std::vector<Tile> rest = layout_of(base, all({paint, change})).tiles.all();
    EXPECT_EQ(rest.size() + count, before.size());
    for (const Tile& tile : rest) EXPECT_THAT(before, ::testing::Contains(tile));
    for (const TileBrush brush : {TileBrush::comb, TileBrush::resize, TileBrush::raise}) {
        change.brush = brush;
        const std::vector<Tile> after = layout_of(base, all({paint, change})).tiles.all();
        ASSERT_EQ(after.size(), before.size());
        double most = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (!under(before[i])) {
                EXPECT_EQ(after[i], before[i]);
                continue;
            }
            const double by = brush == TileBrush::comb     ? after[i].x.z
                              : brush == TileBrush::resize ? after[i].size / before[i].size - 1
                                                           : after[i].height - 1;
            EXPECT_GE(by, brush == TileBrush::comb ? -1.0 : 0.0);
            most = std::max(most, by);
        }
        EXPECT_GT(most, 0.35);
    }
}

TEST(TileLayouts, AHiddenStrokeDoesNothingAndOneStrokesNumberMovesNoOther)
{
    const TileBase base = base_of(ball());
    TileStroke left = over_the_front(base), right = left;
    for (TileSample& each : right.samples) each.at.p = -each.at.p, each.at.normal = -each.at.normal;
    const std::vector<Tile> both = layout_of(base, all({left, right})).tiles.all();
    right.hidden = true;
    const std::vector<Tile> one = layout_of(base, all({left, right})).tiles.all();
    EXPECT_EQ(one, layout_of(base, all({left})).tiles.all());
    ASSERT_LT(one.size(), both.size());
    right.hidden = false;
    left.seed = 7;
    const std::vector<Tile> other = layout_of(base, all({left, right})).tiles.all();
    const auto of_second = [](const std::vector<Tile>& tiles) {
        std::vector<Tile> out;
        std::ranges::copy_if(tiles, std::back_inserter(out),
                             [](const Tile& t) { return t.stroke == 1; });
        return out;
    };
    EXPECT_EQ(of_second(both), of_second(other));
}

TEST(TileLayouts, SamplesThatAreOnNoSurfaceAnyMoreAreCounted)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    for (std::size_t i = 0; i < 10; ++i) stroke.samples[i].at.p += glm::dvec3(0, -9, 0);
    EXPECT_EQ(layout_of(base, all({stroke})).lost, 10);
    for (TileSample& each : stroke.samples) each.at.p = {50, 50, 50};
    const TileLayout none = layout_of(base, all({stroke}));
    EXPECT_EQ(none.lost, 30);
    EXPECT_TRUE(none.tiles.empty());
}

TEST(TileLayouts, TooManyTilesAreSaid)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    stroke.brush = TileBrush::fill;
    stroke.size = 1e-4;
    EXPECT_TRUE(layout_of(base, all({stroke})).too_many);
}

// Numbers of a hostile file end, and soon.
TEST(TileLayouts, EndForABrushOfAnySizeAndTilesThatAreNeverLaid)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    stroke.size = 1e-9;
    stroke.radius = 1e9;
    EXPECT_LE(layout_of(base, all({stroke})).tiles.size(), most_tiles);
    TileStroke comb = over_the_front(base);
    comb.brush = TileBrush::comb;
    comb.radius = 1e9;
    TileStroke few = over_the_front(base);
    EXPECT_FALSE(layout_of(base, all({few, comb})).tiles.empty());
    stroke.brush = TileBrush::line;
    for (TileSample& each : stroke.samples) each.pressure = 0;
    const TileLayout none = layout_of(base, all(std::vector<TileStroke>(20, stroke)));
    EXPECT_TRUE(none.too_many);
    EXPECT_TRUE(none.tiles.empty());
}

TEST(TileLayouts, AreStoppedByTheirProgress)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    stroke.brush = TileBrush::fill;
    stroke.size = 1e-3;
    struct Stop {};
    EXPECT_THROW(layout_of(base, all({stroke}), [](double, std::string_view) { throw Stop{}; }),
                 Stop);
}

TEST(TileLayouts, GrabMovesOneTileAndTurnsItAsTheSurfaceTurns)
{
    const TileBase base = base_of(ball());
    TileStroke stroke = over_the_front(base);
    stroke.radius = 0.2;
    stroke.size = 0.1;
    const std::vector<Tile> before = layout_of(base, all({stroke})).tiles.all();
    const Tile& taken = before[before.size() / 2];
    TileStroke grab;
    grab.brush = TileBrush::grab;
    const auto point = [&](const glm::dvec3& p) {
        return TileSample{{glm::normalize(p), glm::normalize(p)}};
    };
    const glm::dvec3 goal(0.3, -0.2, 0.9);
    grab.samples = {point(base.position(taken.at) + glm::dvec3(0, 0, 0.01)), point(goal)};
    const std::vector<Tile> after = layout_of(base, all({stroke, grab})).tiles.all();
    ASSERT_EQ(after.size(), before.size());
    std::size_t kept = 0;
    for (const Tile& each : before) kept += std::ranges::count(after, each) > 0;
    EXPECT_EQ(kept, before.size() - 1);
    const Tile& moved = after.back();
    EXPECT_LT(glm::distance(base.position(moved.at), glm::normalize(goal)), 5e-3);
    EXPECT_NEAR(glm::dot(moved.x, base.normal(moved.at)), 0, 1e-9);
    EXPECT_NEAR(glm::length(moved.x), 1, 1e-12);
    EXPECT_EQ(moved.size, taken.size);
    grab.samples.front() = point({0, 1, 0}); // where no tile is
    EXPECT_EQ(layout_of(base, all({stroke, grab})).tiles.all(), before);
}

} // namespace
} // namespace trivar
