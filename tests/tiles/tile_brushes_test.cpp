// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/tiles/overlaps.h"
#include "tests/limit/cages.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using Strokes = std::vector<TileStroke>;

std::vector<Tile> laid_by(const TileBase& base, const Strokes& strokes)
{
    std::vector<Ref<TileStroke>> refs;
    for (const TileStroke& each : strokes) refs.push_back(make_ref(TileStroke(each)));
    return layout_of(base, refs).tiles.all();
}

TileBase ground()
{
    return base_of(plane_mesh({4, 4}, {6, 6}));
}

// A row of 9 tiles, 0.2 apart, from x = -0.8 on.
TileStroke row(const TileBase& base)
{
    TileStroke stroke = stroke_over(base, {-0.8, 0, 1}, {0.81, 0, 1}, {0, 0, -1}, 40);
    stroke.brush = TileBrush::line;
    stroke.size = 0.2;
    return stroke;
}

TileSample sample_at(double x, double y)
{
    return {{{x, y, 0}, {0, 0, 1}}};
}

TEST(TileBrushes, ColourBringsTintsNearerToItsOwnAndBack)
{
    const TileBase base = ground();
    TileStroke paint = stroke_over(base, {0, -1, 1}, {0, 1, 1}, {0, 0, -1}, 30);
    paint.brush = TileBrush::color;
    paint.radius = 0.3;
    paint.color = {1, 0.2, 0};
    const std::vector<Tile> before = laid_by(base, {row(base)}),
                            after = laid_by(base, {row(base), paint});
    ASSERT_EQ(before.size(), 9u);
    ASSERT_EQ(after.size(), 9u);
    EXPECT_NEAR(glm::distance(after[4].tint, paint.color), 0, 0.05); // right under it
    EXPECT_EQ(after[0], before[0]);
    EXPECT_GT(after[3].tint.g, after[4].tint.g);
    EXPECT_LT(after[3].tint.g, 1);
    TileStroke back = paint;
    back.strength = -0.5;
    const std::vector<Tile> again = laid_by(base, {row(base), paint, back});
    EXPECT_NEAR(glm::distance(again[4].tint, glm::dvec3(1)), 0, 0.05);
}

TEST(TileBrushes, MorphAddsToTheMorphOfTilesWithinItsRange)
{
    const TileBase base = ground();
    TileStroke paint = stroke_over(base, {0, -1, 1}, {0, 1, 1}, {0, 0, -1}, 30);
    paint.brush = TileBrush::morph;
    paint.radius = 0.3;
    const std::vector<Tile> once = laid_by(base, {row(base), paint});
    EXPECT_NEAR(once[4].morph, 0.5, 0.02);
    EXPECT_EQ(once[0].morph, 0);
    EXPECT_EQ(laid_by(base, {row(base), paint, paint, paint})[4].morph, 1);
}

TEST(TileBrushes, AHandTurnsScalesAndRemovesTheTilesThatItTakes)
{
    const TileBase base = ground();
    const std::vector<Tile> before = laid_by(base, {row(base)});
    TileStroke hand;
    hand.brush = TileBrush::adjust;
    hand.samples = {sample_at(-0.78, 0.02), sample_at(0.01, 0), sample_at(0, 1.5)}; // none there
    hand.turn_deg = 90;
    hand.factor = 1.5;
    const std::vector<Tile> after = laid_by(base, {row(base), hand});
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool taken = i == 0 || i == 4;
        EXPECT_EQ(after[i] == before[i], !taken);
        if (!taken) continue;
        EXPECT_NEAR(after[i].size, 0.3, 1e-12);
        EXPECT_NEAR(glm::distance(after[i].x, {0, 1, 0}), 0, 1e-9);
    }
    hand.factor = 0;
    const std::vector<Tile> rest = laid_by(base, {row(base), hand});
    ASSERT_EQ(rest.size(), 7u);
    EXPECT_EQ(rest.front(), before[1]);
}

TEST(TileBrushes, AHandMovesSeveralTilesTogetherOverTheSurface)
{
    const TileBase base = ground();
    const std::vector<Tile> before = laid_by(base, {row(base)});
    TileStroke grab;
    grab.brush = TileBrush::grab;
    grab.samples = {sample_at(-0.8, 0), sample_at(-0.4, 0), sample_at(-0.8, 1)};
    const std::vector<Tile> after = laid_by(base, {row(base), grab});
    ASSERT_EQ(after.size(), 9u); // what moved comes last
    EXPECT_LT(glm::distance(base.position(after[7].at), {-0.8, 1, 0}), 1e-6);
    EXPECT_LT(glm::distance(base.position(after[8].at), {-0.4, 1, 0}), 1e-6);
    EXPECT_EQ(after[7].size, before[0].size);
    // On a ball they stay as far apart, about, and on it.
    const TileBase ball = base_of(sphere_mesh(1, 96, 48));
    TileStroke line = stroke_over(ball, {-0.5, -3, 0}, {0.5, -3, 0}, {0, 1, 0}, 40);
    line.brush = TileBrush::line;
    line.size = 0.2;
    const std::vector<Tile> on_ball = laid_by(ball, {line});
    const auto at = [&](const Tile& tile) { return ball.position(tile.at); };
    TileStroke over = grab;
    const auto sample = [](const glm::dvec3& p) {
        return TileSample{{glm::normalize(p), glm::normalize(p)}};
    };
    over.samples = {sample(at(on_ball[0])), sample(at(on_ball[1])), sample({0, -0.2, 1})};
    const std::vector<Tile> moved = laid_by(ball, {line, over});
    ASSERT_EQ(moved.size(), on_ball.size());
    const Tile &a = moved[moved.size() - 2], &b = moved.back();
    EXPECT_NEAR(glm::distance(at(a), at(b)), glm::distance(at(on_ball[0]), at(on_ball[1])), 0.01);
    EXPECT_NEAR(glm::length(at(b)), 1, 0.01);
    EXPECT_NEAR(glm::dot(b.x, ball.normal(b.at)), 0, 1e-9);
}

TEST(TileBrushes, AMirroredHandTakesNoTileTwice)
{
    const TileBase base = ground();
    TileStroke hand;
    hand.brush = TileBrush::adjust;
    hand.samples = {sample_at(0, 0), sample_at(0.4, 0)};
    hand.factor = 1.1;
    hand.turn_deg = 30;
    hand.mirror = TileMirror::x;
    const std::vector<Tile> after = laid_by(base, {row(base), hand});
    for (const std::size_t i : {2u, 4u, 6u}) EXPECT_NEAR(after[i].size, 0.22, 1e-12);
    EXPECT_EQ(after[3].size, 0.2);
    EXPECT_NEAR(after[2].x.y, -after[6].x.y, 1e-9);
}

TEST(TileBrushes, FillsKeepToWhatTheyAreGiven)
{
    Mesh two = plane_mesh({4, 4}, {4, 4}); // faces of 1 x 1
    two.face_material.assign(two.face_count(), 0);
    std::vector<double> lefts;
    for (std::size_t f = 0; f < two.face_count(); ++f) {
        double x = 0;
        for (std::uint32_t c = two.face_begin[f]; c < two.face_begin[f + 1]; ++c)
            x += two.positions[two.corners[c]].x / 4;
        if (x < 0) two.face_material[f] = 1;
    }
    const TileBase base = base_of(two);
    TileStroke fill = stroke_over(base, {-1.7, 0.2, 1}, {-1.3, 0.4, 1}, {0, 0, -1}, 4);
    fill.brush = TileBrush::fill;
    fill.size = 0.15;
    const auto bounds = [&](TileArea area) {
        fill.area = area;
        Box box;
        for (const Tile& tile : laid_by(base, {fill})) box.add(base.position(tile.at));
        return box;
    };
    EXPECT_GT(bounds(TileArea::island).hi.x, 1.8);
    EXPECT_GT(bounds(TileArea::all).hi.x, 1.8);
    const Box of_material = bounds(TileArea::material), of_face = bounds(TileArea::faces);
    EXPECT_LE(of_material.hi.x, 0);
    EXPECT_LT(of_material.lo.y, -1.8);
    EXPECT_GE(of_face.lo.x, -2);
    EXPECT_LE(of_face.hi.x, -1);
    EXPECT_GE(of_face.lo.y, 0);
    EXPECT_LE(of_face.hi.y, 1);
}

TEST(TileBrushes, FindTheFacesOfALimitSurface)
{
    const std::vector<LimitBase::Piece> pieces{{make_ref(cube_cage()), glm::dmat4(1)}};
    const LimitBase limit(pieces);
    const TileBase& base = limit.triangles();
    const glm::dvec3 middle(1 / 3.);
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t)
        for (int e = 0; e < 3; ++e) // the middle of a face has neighbours of that face
            if (const std::uint32_t behind = base.across(t, e); behind != TileBase::none) {
                const bool same_chart =
                    limit.place({t, middle}).chart == limit.place({behind / 3, middle}).chart;
                EXPECT_LE(same_chart, base.face_of(t) == base.face_of(behind / 3));
            }
    EXPECT_NE(base.face_of(0), base.face_of(static_cast<std::uint32_t>(base.triangle_count() - 1)));
}

TileOutline square_at(double x, double y, double half = 0.5, double turn = 0)
{
    return {{x, y, 0}, {std::cos(turn), std::sin(turn), 0}, {0, 0, 1}, glm::dvec2(half)};
}

TEST(TileOverlaps, AreAsDeepAsOneMustGo)
{
    const TileOutline middle = square_at(0, 0);
    EXPECT_NEAR(overlap_depth(middle, square_at(0.8, 0)), 0.2, 1e-12);
    EXPECT_EQ(overlap_depth(middle, square_at(1.01, 0.3)), 0);
    // A corner of a turned square reaches half a diagonal far.
    EXPECT_NEAR(overlap_depth(middle, square_at(1.1, 0, 0.5, 0.785398163397448)), 0.107107, 1e-5);
    TileOutline below = square_at(0.2, 0);
    below.n = {0, 0, -1};
    EXPECT_EQ(overlap_depth(middle, below), 0); // the other side of a sheet
}

TEST(TileOverlaps, AreGoneWithoutThoseThatOverlapEarlierOnes)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0, 6), size(0.2, 0.5), turn(0, 3);
    std::vector<TileOutline> tiles;
    for (int i = 0; i < 200; ++i)
        tiles.push_back(square_at(place(random), place(random), size(random), turn(random)));
    const std::vector<char> any = overlapping(tiles), later = overlapping_earlier(tiles);
    std::vector<TileOutline> rest;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const auto meets = [&](std::size_t j) {
            const double side = 2 * std::min(tiles[i].half.x, tiles[j].half.x);
            return j != i && overlap_depth(tiles[i], tiles[j]) > overlap_share * side;
        };
        bool found = false;
        for (std::size_t j = 0; j < tiles.size(); ++j) found = found || meets(j);
        EXPECT_EQ(any[i] != 0, found);
        EXPECT_LE(later[i], any[i]);
        if (!later[i]) rest.push_back(tiles[i]);
    }
    EXPECT_EQ(std::ranges::count(overlapping(rest), char(1)), 0);
    EXPECT_GT(rest.size(), 20u);
    EXPECT_LT(rest.size(), 150u);
}

} // namespace
} // namespace trivar::testing
