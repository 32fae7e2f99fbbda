// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "tests/tiles/bases.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

using namespace testing;
using Refs = std::vector<Ref<TileStroke>>;

struct LaidBall {
    Ref<TileBase> base = std::make_shared<const TileBase>(base_of(sphere_mesh(1, 96, 48)));
    Layouter layouter;

    TileStroke stroke(double x, TileBrush brush = TileBrush::scatter) const
    {
        TileStroke out = stroke_over(*base, {x - 0.4, -2, -0.2}, {x + 0.4, -2, 0.3}, {0, 1, 0}, 30);
        out.brush = brush;
        out.seed = static_cast<int>(100 * x);
        return out;
    }
    TileLayout again(const Refs& strokes) { return layouter(base, strokes); }
    // The layout has what a fresh one has.
    void check(const Refs& strokes)
    {
        const TileLayout kept = again(strokes), fresh = layout_of(*base, strokes);
        EXPECT_EQ(kept.tiles, fresh.tiles);
        EXPECT_EQ(kept.strands, fresh.strands);
        EXPECT_EQ(kept.tracks.size(), fresh.tracks.size());
        EXPECT_EQ(kept.duration_s, fresh.duration_s);
        EXPECT_EQ(kept.lost, fresh.lost);
        EXPECT_EQ(kept.too_many, fresh.too_many);
    }
};

TileStroke with_samples(const TileStroke& whole, std::size_t count)
{
    TileStroke out = whole;
    out.samples.resize(count);
    return out;
}

TEST(Layouters, LayWhatAFreshLayoutHasHoweverStrokesComeAndGo)
{
    LaidBall ball;
    std::mt19937 random(3);
    const std::vector<TileBrush> brushes{TileBrush::scatter, TileBrush::line,   TileBrush::erase,
                                         TileBrush::comb,    TileBrush::resize, TileBrush::grab,
                                         TileBrush::color,   TileBrush::strand, TileBrush::adjust,
                                         TileBrush::scatter, TileBrush::scatter};
    Refs strokes;
    for (int step = 0; step < 120; ++step) {
        const auto one_of = [&](std::size_t count) { return random() % count; };
        TileStroke stroke = ball.stroke(-0.5 + 0.1 * static_cast<double>(one_of(11)),
                                        brushes[one_of(brushes.size())]);
        if (one_of(4) == 0) stroke.mirror = TileMirror::x;
        if (one_of(9) == 0) stroke.samples[5].at.p.x += 100; // lost
        const std::size_t what = one_of(6);
        if (strokes.empty() || what < 2)
            strokes.push_back(make_ref(with_samples(stroke, 1 + one_of(30))));
        else if (what == 2)
            strokes.pop_back();
        else if (what == 3)
            strokes[one_of(strokes.size())] = make_ref(std::move(stroke));
        else { // the last one goes on, or is shorter
            TileStroke longer = *strokes.back();
            const TileStroke other = ball.stroke(0.1);
            if (one_of(3) > 0)
                for (std::size_t k = 0; k <= one_of(5); ++k)
                    longer.samples.push_back(other.samples[one_of(other.samples.size())]);
            else
                longer.samples.resize(1 + longer.samples.size() / 2);
            strokes.back() = make_ref(std::move(longer));
        }
        if (strokes.size() > 9) strokes.erase(strokes.begin());
        ball.check(strokes);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Layouters, KeepTheTilesOfDabsThatStay)
{
    LaidBall ball;
    TileStroke stroke = ball.stroke(0);
    stroke.size = 0.012;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i)
        stroke.samples[i].time_s = 0.01 * static_cast<double>(i);
    const TileLayout some = ball.again({make_ref(with_samples(stroke, 20))});
    ASSERT_GT(some.tiles.runs().size(), 2u);
    const TileLayout more = ball.again({make_ref(with_samples(stroke, 25))});
    EXPECT_GT(more.tiles.size(), some.tiles.size());
    for (std::size_t r = 0; r + 2 < some.tiles.runs().size(); ++r)
        EXPECT_EQ(more.tiles.runs()[r], some.tiles.runs()[r]) << "in common";
    ball.check({make_ref(with_samples(stroke, 30))});
}

TEST(Layouters, BeginAgainAfterTheyWereCancelled)
{
    struct Stopped {};
    LaidBall ball;
    TileStroke fill = ball.stroke(0, TileBrush::fill);
    const Refs strokes{make_ref(ball.stroke(0.2)), make_ref(std::move(fill))};
    ball.check({strokes[0]});
    EXPECT_THROW(
        ball.layouter(ball.base, strokes, [](double, std::string_view) { throw Stopped(); }),
        Stopped);
    ball.check(strokes);
    ball.check({strokes[0]});
}

} // namespace
} // namespace trivar
