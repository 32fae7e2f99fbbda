// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/repair.h"
#include "core/ffd/repair_ways.h"
#include "tests/ffd/folds.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// A box of n control points each way along u, few across, bent round an axis above it: its roof
// folds where the height is more than the radius. w = 0 is the ground.
Lattice bent_box(double radius, double height)
{
    const std::array<Knots, 3> axes{Knots::uniform(4, 14), Knots::uniform(3, 4),
                                    Knots::uniform(3, 5)};
    Trivariate<glm::dvec3> points{axes, {}};
    for (int i = 0; i < 14; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 5; ++k) {
                const double angle = 2 * axes[0].greville(i) / radius,
                             r = radius - height * axes[2].greville(k);
                points.points.emplace_back(r * std::sin(angle), 2 * axes[1].greville(j),
                                           radius - r * std::cos(angle));
            }
    return lattice_through(points);
}

Lattice with_a_point_pulled_through()
{
    const Knots axis = Knots::uniform(4, 8);
    const Lattice lattice = lattice_at_rest({axis, axis, axis}, some_affine_map());
    const PointMove move{{3, 4, 4}, 0.9 * glm::dvec3(lattice.rest[0])};
    return moved(lattice, std::span(&move, 1));
}

double ground_moved(const UnfoldedLattice& out)
{
    double most = 0;
    for (const PointMove& move : out.moves)
        if (move.index.z == 0) most = std::max(most, glm::length(move.by));
    return most;
}

void expect_repaired(const Lattice& folded, const UnfoldedLattice& out)
{
    ASSERT_TRUE(out.certified);
    EXPECT_TRUE(judge(out.lattice).good());
    EXPECT_EQ(out.lattice, moved(folded, out.moves));
    EXPECT_GT(out.taken.moved_rms, 0);
    for (const RepairAttempt& other : out.tried)
        EXPECT_TRUE(!other.certified || out.taken.moved_rms <= other.moved_rms);
}

TEST(Repair, OpensAFoldedRoofAndLeavesTheGround)
{
    const Lattice folded = bent_box(1, 1.3);
    ASSERT_EQ(verdict_of(folded), Verdict::proven_bad);
    const UnfoldedLattice out = unfolded(folded);
    expect_repaired(folded, out);
    EXPECT_EQ(ground_moved(out), 0);
    EXPECT_EQ(out.tried.size(), 5u);
}

TEST(Repair, PutsBackAPointThatWasPulledThroughItsNeighbours)
{
    const Lattice folded = with_a_point_pulled_through();
    const UnfoldedLattice out = unfolded(folded);
    expect_repaired(folded, out);
    EXPECT_LT(out.taken.moved_most, 0.9 * glm::length(glm::dvec3(folded.rest[0])));
    EXPECT_EQ(unfolded(folded).lattice, out.lattice); // the same again
}

TEST(Repair, MendsNoiseOnClosedAndTwistedAxesAndMirroredSpace)
{
    for (const Closure closure : {Closure::periodic, Closure::twisted}) {
        const std::array<Knots, 3> axes{Knots::periodic(3, 9, 0, 1, closure), Knots::uniform(3, 5),
                                        Knots::uniform(2, 3)};
        Lattice folded = random_lattice(axes, 0.09, 4);
        if (closure == Closure::periodic) folded.rest[0] = -folded.rest[0];
        ASSERT_FALSE(judge(folded).good());
        expect_repaired(folded, unfolded(folded));
    }
}

// The moves that even every point of a lattice whose cells are all in doubt.
std::vector<glm::dvec3> evening_of(const Lattice& lattice)
{
    const RepairSite site(lattice, {});
    CellVerdicts verdicts = judge(lattice);
    std::fill(verdicts.of.begin(), verdicts.of.end(), Verdict::unknown);
    std::vector<glm::dvec3> out(lattice.displacement.points.size());
    for (const PointMove& move : evened(site, lattice, verdicts, true))
        out[lattice.displacement.index(move.index.x, move.index.y, move.index.z)] = move.by;
    return out;
}

TEST(Repair, LeavesEvenPointsWhereTheyAreWithTwoLayersToo)
{
    for (const int layers : {2, 3}) {
        Lattice lattice = lattice_at_rest(
            {Knots::uniform(3, 5), Knots::uniform(3, 6), Knots::uniform(2, layers)}, glm::dmat4(1));
        Trivariate<glm::dvec3>& f = lattice.displacement;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 6; ++j)
                for (int k = 0; k < layers; ++k)
                    f.points[f.index(i, j, k)] = {f.axes[0].greville(i), -f.axes[1].greville(j),
                                                  3 * f.axes[2].greville(k) +
                                                      f.axes[0].greville(i)};
        for (const glm::dvec3& by : evening_of(lattice)) EXPECT_LT(glm::length(by), 1e-12);
    }
}

TEST(Repair, MendsAFoldOfTwoLayers)
{
    Lattice folded = lattice_at_rest(
        {Knots::uniform(3, 6), Knots::uniform(3, 6), Knots::uniform(2, 2)}, glm::dmat4(1));
    folded.displacement.points[folded.displacement.index(0, 0, 1)].x += 0.7;
    ASSERT_FALSE(judge(folded).good());
    expect_repaired(folded, unfolded(folded));
}

TEST(Repair, EvensTheSameWhereverTheSeamIs)
{
    for (const Closure closure : {Closure::periodic, Closure::twisted}) {
        const Lattice lattice = random_lattice(
            {Knots::periodic(3, 7, 0, 1, closure), Knots::uniform(3, 5), Knots::uniform(2, 3)},
            0.1);
        Lattice turned = lattice; // by one point
        const Trivariate<glm::dvec3>& f = lattice.displacement;
        const Trivariate<glm::dvec3> moves{f.axes, evening_of(lattice)};
        const auto each = [&](auto&& visit) {
            for (int i = 0; i < 7; ++i)
                for (int j = 0; j < 5; ++j)
                    for (int k = 0; k < 3; ++k) visit(i, j, k);
        };
        each([&](int i, int j, int k) {
            turned.displacement.points[f.index(i, j, k)] = f.point(i + 1, j, k);
        });
        const std::vector<glm::dvec3> turned_moves = evening_of(turned);
        each([&](int i, int j, int k) {
            EXPECT_LT(glm::distance(turned_moves[f.index(i, j, k)], moves.point(i + 1, j, k)),
                      1e-12);
        });
    }
}

TEST(Repair, MovesTheGroundOnlyWhereItMust)
{
    Lattice folded = lattice_at_rest(
        {Knots::uniform(3, 6), Knots::uniform(3, 6), Knots::uniform(2, 3)}, glm::dmat4(1));
    for (int k = 0; k < 3; ++k) // a whole column, its foot too
        folded.displacement.points[folded.displacement.index(2, 2, k)].x += 0.7;
    const UnfoldedLattice out = unfolded(folded);
    expect_repaired(folded, out);
    EXPECT_EQ(ground_moved(out) > 0, out.taken.ground_yields);
}

TEST(Repair, LeavesWhatIsGoodAndWhatIsExcepted)
{
    const Lattice good = bent_box(1, 0.5);
    EXPECT_TRUE(unfolded(good).certified);
    EXPECT_TRUE(unfolded(good).moves.empty());
    const Lattice folded = with_a_point_pulled_through();
    RepairOptions options;
    options.guard.excepted.push_back({{0, 0, 0}, {1, 1, 1}});
    EXPECT_TRUE(unfolded(folded, options).moves.empty());
    options.guard.excepted[0].hi.x = 0.3; // the rest of the fold is mended from the other side
    const UnfoldedLattice out = unfolded(folded, options);
    for (const PointMove& move : out.moves)
        EXPECT_GT(folded.displacement.axes[0].greville(move.index.x), 0.3);
}

TEST(Repair, SaysWhereItCannot)
{
    Lattice flat = lattice_at_rest(
        {Knots::uniform(3, 5), Knots::uniform(3, 5), Knots::uniform(3, 5)}, glm::dmat4(1));
    flat.rest[2] = glm::dvec4(0);
    const UnfoldedLattice out = unfolded(flat);
    EXPECT_FALSE(out.certified);
    EXPECT_EQ(out.lattice, flat);
    EXPECT_TRUE(out.moves.empty());
    flat.displacement.points[7].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(unfolded(flat).certified);
}

} // namespace
} // namespace trivar
