// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/guard.h"
#include "tests/ffd/folds.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>
#include <numeric>

namespace trivar {
namespace {

using namespace testing;

std::array<Knots, 3> axes_of_order(int order, int u, int v, int w)
{
    return {Knots::uniform(order, u), Knots::uniform(order, v), Knots::uniform(order, w)};
}

std::vector<int> cells_of(const CellGrid& grid)
{
    std::vector<int> out(grid.count());
    std::iota(out.begin(), out.end(), 0);
    return out;
}

double determinant_at(const Lattice& lattice, const glm::dvec3& uvw)
{
    const Jet<glm::dvec3> f = evaluate(lattice, uvw, 1);
    return glm::determinant(glm::dmat3(f.first[0], f.first[1], f.first[2]));
}

// Lattices with every kind of axis, twisted ones with symmetric others.
std::vector<Lattice> all_kinds()
{
    std::vector<Lattice> out;
    unsigned seed = 0;
    for (const Knots& axis : all_axes())
        for (std::size_t a = 0; a < 3; ++a) {
            const int others = 2 + static_cast<int>(seed % 4);
            std::array<Knots, 3> axes{Knots::uniform(others, others + 1, -1, 2),
                                      Knots::uniform(7 - others, 8 - others, 0, 3),
                                      Knots::uniform(3, 4)};
            axes[a] = axis;
            out.push_back(random_lattice(axes, 0.4, ++seed));
            out.back().rest = some_affine_map();
        }
    return out;
}

TEST(CellDeterminants, AreTheDeterminantOnAxesOfEveryOrderAndKind)
{
    for (const Lattice& lattice : all_kinds()) {
        const CellGrid grid(lattice.displacement.axes);
        const std::vector<int> cells = cells_of(grid);
        std::vector<double> off(cells.size());
        each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
            const CellGrid::Place place = grid.place(i);
            const double size = std::max(det.most, -det.least);
            for (const glm::dvec3 x : {glm::dvec3(0.3, 0.6, 0.2), glm::dvec3(0.9, 0.1, 0.7)}) {
                const double d = determinant_at(lattice, place.lo + (place.hi - place.lo) * x);
                off[i] = std::max(off[i], std::abs(value(det.f, x) - d) / size);
            }
        });
        EXPECT_LT(*std::max_element(off.begin(), off.end()), 1e-11);
    }
}

TEST(CellDeterminants, ChangeOnlyInTheCellsThatAPointTouches)
{
    for (const Lattice& lattice : all_kinds()) {
        const CellGrid grid(lattice.displacement.axes);
        const auto& d = lattice.displacement;
        const PointMove move{{d.axes[0].count() - 1, d.axes[1].count() / 2, 0}, {0.1, 0.2, -0.3}};
        const std::vector<int> touched = grid.touched(std::span(&move, 1));
        std::vector<double> before(grid.count()), after(grid.count());
        const std::vector<int> cells = cells_of(grid);
        each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
            before[i] = det.least + det.mean;
        });
        each_determinant(
            grid, moved(lattice, std::span(&move, 1)), cells,
            [&](std::size_t i, const CellDeterminant& det) { after[i] = det.least + det.mean; });
        std::vector<int> changed;
        for (std::size_t i = 0; i < before.size(); ++i)
            if (before[i] != after[i]) changed.push_back(static_cast<int>(i));
        EXPECT_EQ(changed, touched);
    }
}

TEST(Guard, JudgesAgainAsItJudgesAll)
{
    Noise noise(3);
    for (const Closure closure : {Closure::open, Closure::periodic, Closure::twisted}) {
        std::array<Knots, 3> axes = axes_of_order(4, 9, 6, 5);
        if (closure != Closure::open) axes[0] = Knots::periodic(4, 9, 0, 1, closure);
        Lattice lattice = random_lattice(axes, 0.02);
        CellVerdicts verdicts = judge(lattice);
        EXPECT_EQ(verdicts.size(), CellGrid(axes).size());
        for (const glm::ivec3 index : {glm::ivec3(0, 1, 0), {8, 5, 2}, {4, 3, 3}}) {
            const PointMove move{index, 0.2 * noise.vec3()};
            lattice = moved(lattice, std::span(&move, 1));
            verdicts = judged_again(verdicts, lattice, std::span(&move, 1));
            const CellVerdicts all = judge(lattice);
            EXPECT_EQ(verdicts.of, all.of);
            EXPECT_EQ(verdicts.least, all.least);
            EXPECT_EQ(verdicts.sign, all.sign);
        }
    }
}

TEST(Guard, StopsAMoveThatWouldFoldAtTheLastShareThatIsProven)
{
    const Lattice lattice = lattice_at_rest(axes_of_order(4, 8, 6, 6), some_affine_map());
    const PointMove move{{3, 2, 2}, glm::dvec3(lattice.rest[0])}; // past its neighbours
    const CellVerdicts before = judge(lattice);
    ASSERT_TRUE(before.good());
    const CertifiedShare out = certified_share(lattice, before, std::span(&move, 1));
    EXPECT_GT(out.share, 0.1);
    EXPECT_LT(out.share, 1);
    EXPECT_FALSE(out.stopping.empty());
    const auto at_share = [&](double share) {
        return moved(lattice, scaled(std::span(&move, 1), share));
    };
    EXPECT_TRUE(out.after.good());
    EXPECT_TRUE(judge(at_share(out.share)).good());
    EXPECT_FALSE(judge(at_share(out.share + 1.0 / 256)).good());
    EXPECT_LT(smallest_jacobian(at_share(out.share + 4.0 / 256), 8), 0);
    EXPECT_EQ(certified_share(lattice, std::span(&move, 1)), out.share);
}

TEST(Guard, LetsWhatIsGoodGoAllTheWay)
{
    const Lattice lattice = lattice_at_rest(axes_of_order(3, 6, 5, 5), glm::dmat4(1));
    const PointMove move{{2, 2, 2}, {0.05, 0.03, -0.04}};
    const CellVerdicts before = judge(lattice);
    const CertifiedShare out = certified_share(lattice, before, std::span(&move, 1));
    EXPECT_EQ(out.share, 1);
    EXPECT_TRUE(out.stopping.empty());
    EXPECT_EQ(certified_share(lattice, before, {}).share, 1);
}

TEST(Guard, DoesNotLetAFoldGrowButLetsItBeMended)
{
    const Lattice good = lattice_at_rest(axes_of_order(4, 8, 6, 6), glm::dmat4(1));
    const PointMove fold{{3, 2, 2}, {0.9, 0, 0}}, more{{3, 2, 2}, {0.2, 0, 0}},
        mend{{3, 2, 2}, {-0.5, 0, 0}};
    const Lattice folded = moved(good, std::span(&fold, 1));
    const CellVerdicts before = judge(folded);
    ASSERT_FALSE(before.good());
    EXPECT_EQ(certified_share(folded, before, std::span(&more, 1)).share, 0);
    EXPECT_EQ(certified_share(folded, before, std::span(&mend, 1)).share, 1);
}

TEST(Guard, DoesNotLetASecondFoldJoinADeeperOneInTheSameCell)
{
    const Lattice good = lattice_at_rest(axes_of_order(4, 4, 4, 4), glm::dmat4(1));
    const PointMove first{{1, 0, 0}, {-0.9, 0, 0}}, second{{3, 3, 3}, {-0.6, 0, 0}};
    const Lattice folded = moved(good, std::span(&first, 1));
    const CellVerdicts before = judge(folded);
    ASSERT_EQ(before.of, std::vector{Verdict::proven_bad});
    const CertifiedShare out = certified_share(folded, before, std::span(&second, 1));
    EXPECT_LT(out.share, 1);
    const Lattice after = moved(folded, scaled(std::span(&second, 1), out.share));
    EXPECT_GT(determinant_at(after, {1, 1, 1}), 0);
    EXPECT_EQ(judge(moved(folded, std::span(&second, 1))).least, before.least);
}

TEST(Guard, LeavesExceptedPartsAlone)
{
    const Lattice lattice = lattice_at_rest(axes_of_order(4, 8, 6, 6), glm::dmat4(1));
    const PointMove move{{3, 2, 2}, {0.9, 0, 0}};
    GuardOptions options;
    options.excepted.push_back({{0, 0, 0}, {1, 1, 1}});
    EXPECT_EQ(certified_share(lattice, std::span(&move, 1), options), 1);
    options.excepted[0].lo.x = 0.9; // now of the last cells only
    const CellVerdicts verdicts = judge(lattice, options);
    EXPECT_EQ(verdicts.of.back(), Verdict::excepted);
    EXPECT_EQ(verdicts.of.front(), Verdict::proven_good);
    EXPECT_TRUE(verdicts.good());
    EXPECT_LT(certified_share(lattice, std::span(&move, 1), options), 1);
}

TEST(Guard, KnowsNothingOfWhatIsNoNumber)
{
    Lattice lattice = lattice_at_rest(axes_of_order(4, 6, 5, 5), glm::dmat4(1));
    const PointMove move{{1, 1, 1}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
    EXPECT_EQ(certified_share(lattice, std::span(&move, 1)), 0);
    EXPECT_FALSE(judge(moved(lattice, std::span(&move, 1))).good());
    for (glm::dvec3& p : lattice.displacement.points) p *= 0.0;
    lattice.rest = glm::dmat4(0);
    EXPECT_EQ(judge(lattice).of.front(), Verdict::unknown);
}

// A ring of square section, which a twisted axis turns half round.
Lattice ring(Closure closure)
{
    Trivariate<glm::dvec3> points{
        {Knots::periodic(3, 8, 0, 1, closure), Knots::uniform(3, 7), Knots::uniform(3, 6)}, {}};
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 7; ++j)
            for (int k = 0; k < 6; ++k) {
                const double turn = 0.25 * 3.141592653589793 * i,
                             lean = closure == Closure::twisted ? turn / 2 : 0;
                const double v = points.axes[1].greville(j) - 0.5,
                             w = points.axes[2].greville(k) - 0.5,
                             r = 2 + v * std::cos(lean) - w * std::sin(lean);
                points.points.emplace_back(r * std::cos(turn), r * std::sin(turn),
                                           -v * std::sin(lean) - w * std::cos(lean));
            }
    return lattice_through(points);
}

// A walk of random edits with the guard on, each from where the last one was let go.
TEST(Guard, LetsNoRandomEditFoldAndRefusesFewGoodOnes)
{
    const std::array<Lattice, 5> lattices{
        lattice_at_rest(axes_of_order(4, 8, 7, 6), glm::dmat4(1)),
        lattice_at_rest(axes_of_order(5, 8, 7, 6), some_affine_map()),
        lattice_at_rest(axes_of_order(2, 8, 7, 6), glm::dmat4(1)), ring(Closure::periodic),
        ring(Closure::twisted)};
    Noise noise(7);
    int refused = 0, not_proven_bad = 0, edits = 0;
    for (Lattice lattice : lattices) {
        CellVerdicts verdicts = judge(lattice);
        ASSERT_TRUE(verdicts.good());
        for (int edit = 0; edit < 120; ++edit, ++edits) {
            const glm::dvec3 anywhere(noise.between(0, 8), noise.between(0, 7),
                                      noise.between(0, 6));
            const PointMove move{glm::ivec3(anywhere), 0.15 * noise.vec3()};
            const std::span moves(&move, 1);
            CertifiedShare out = certified_share(lattice, verdicts, moves);
            if (out.share < 1) {
                ++refused;
                const CellVerdicts whole = judged_again(verdicts, moved(lattice, moves), moves);
                not_proven_bad +=
                    std::count(whole.of.begin(), whole.of.end(), Verdict::proven_bad) == 0;
            }
            lattice = moved(lattice, scaled(moves, out.share));
            verdicts = std::move(out.after);
            if (edit % 40 == 39) {
                EXPECT_GT(smallest_jacobian(lattice, 5), 0);
            }
        }
        EXPECT_TRUE(judge(lattice).good());
    }
    EXPECT_GT(refused, edits / 20); // else nothing was tested
    EXPECT_LE(not_proven_bad, edits / 50);
}

} // namespace
} // namespace trivar
