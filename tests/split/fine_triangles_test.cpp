// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/fine_triangles.h"

#include "core/split/split_error.h"
#include "core/split/surface_bounds.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

// Triangles round the middle of a disc of n edges.
FlatTriangles disc(std::uint32_t n)
{
    FlatTriangles out;
    for (std::uint32_t i = 0; i < n; ++i) {
        out.points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n));
        if (i > 1) out.corners.push_back({0, i - 1, i});
    }
    return out;
}

double area(const FlatTriangles& all, std::size_t t)
{
    const glm::dvec2 a = all.points[all.corners[t][0]], b = all.points[all.corners[t][1]],
                     c = all.points[all.corners[t][2]];
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

std::array<glm::dvec2, 3> places(const FlatTriangles& all, std::size_t t)
{
    return {all.points[all.corners[t][0]], all.points[all.corners[t][1]],
            all.points[all.corners[t][2]]};
}

Coarseness by_squares(double xx, double yy)
{
    return [=](const std::array<glm::dvec2, 3>& t) {
        std::array<double, 3> out{};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 e = t[(i + 1) % 3] - t[i];
            out[i] = xx * e.x * e.x + yy * e.y * e.y;
        }
        return TriangleCoarseness{out, std::ranges::max(out)};
    };
}

TEST(FineTriangles, CoverWhatTheyCoveredFineEnough)
{
    for (const glm::dvec2& squares :
         {glm::dvec2(60, 60), glm::dvec2(800, 0.5), glm::dvec2(0, 900)}) {
        FlatTriangles all = disc(200);
        double before = 0, after = 0;
        for (std::size_t t = 0; t < all.corners.size(); ++t) before += area(all, t);
        const Coarseness coarseness = by_squares(squares.x, squares.y);
        make_fine_enough(all, coarseness, 1e-3);
        for (std::size_t t = 0; t < all.corners.size(); ++t) {
            EXPECT_GT(area(all, t), 0);
            EXPECT_LE(coarseness(places(all, t)).whole, 1);
            after += area(all, t);
        }
        EXPECT_NEAR(before, after, 1e-12);
    }
}

TEST(FineTriangles, AreLongWhereLittleChanges)
{
    FlatTriangles round = disc(200), flat = disc(200);
    make_fine_enough(round, by_squares(800, 800), 1e-3);
    make_fine_enough(flat, by_squares(800, 0.5), 1e-3);
    EXPECT_GT(round.corners.size(), 4000u);
    EXPECT_LT(flat.corners.size(), 500u);
}

// Along a line where a cap runs through one that is there already
TEST(FineTriangles, TurnOverEdgesOfTrianglesThatAreALine)
{
    FlatTriangles all;
    all.points = {{0, 0}, {1, 0}, {0.55, 2e-9}, {0.45, -1e-9}, {0.5, 1}, {0.5, -1}};
    all.corners = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {0, 5, 3}, {5, 1, 3}};
    const Coarseness coarseness = by_squares(3, 0);
    make_fine_enough(all, coarseness, 1e-3);
    EXPECT_EQ(all.points.size(), 6u);
    for (std::size_t t = 0; t < all.corners.size(); ++t)
        EXPECT_LE(coarseness(places(all, t)).whole, 1);
}

TEST(FineTriangles, EndBesideARimThatIsTooCoarse)
{
    FlatTriangles all = disc(7);
    make_fine_enough(all, by_squares(100, 100), 1e-3);
    EXPECT_LT(all.corners.size(), 2000u);
    EXPECT_GT(all.corners.size(), 10u);
}

TEST(SplitError, OfATriangleIsThatOfTheWorstPoint)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < 200; ++k) {
        const EdgeErrors e{uniform(random), uniform(random), k % 5 ? uniform(random) : 0};
        double most = 0;
        constexpr int steps = 100;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double x = static_cast<double>(i) / steps, y = static_cast<double>(j) / steps,
                             z = 1 - x - y;
                most = std::max(most, 4 * (x * y * e[0] + y * z * e[1] + z * x * e[2]));
            }
        EXPECT_LE(most, whole_error(e) + 1e-12);
        EXPECT_NEAR(most, whole_error(e), 2e-3);
    }
}

TEST(BendBounds, AreTheGreatestOfTheirPieces)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Surface<double> surface{{Knots::uniform(4, 14, -1, 1), Knots::uniform(4, 9, -1, 1)}, {}};
    for (int k = 0; k < 14 * 9; ++k) surface.points.push_back(uniform(random));
    const SurfaceBounds pieces(surface, false);
    const BendBounds bends({&pieces, 1});
    for (int k = 0; k < 2000; ++k) {
        const glm::dvec2 a(uniform(random), uniform(random)), b(uniform(random), uniform(random));
        const JetBound slow = pieces.over(glm::min(a, b), glm::max(a, b));
        const BendBounds::Bend fast = bends.over(glm::min(a, b), glm::max(a, b));
        EXPECT_EQ(slow.vv, fast.vv);
        EXPECT_EQ(slow.vw, fast.vw);
        EXPECT_EQ(slow.ww, fast.ww);
    }
}

} // namespace
} // namespace trivar::testing
