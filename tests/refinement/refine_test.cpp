// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "tests/mesh/edges.h"
#include "tests/refinement/bent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

using namespace testing;

Lattice noisy(int order, unsigned seed = 3)
{
    Noise noise(seed);
    return one_cell(order, [&](const glm::dvec3& p) { return p + 0.2 * noise.vec3(); });
}

TEST(Refining, KeepsTheDrawnErrorWithinItsBoundAndTheBoundWithinTheTolerance)
{
    for (const Lattice& lattice : {one_cell(4, bend), one_cell(3, twist), noisy(4), noisy(2)})
        for (const double share : {0.02, 0.005}) {
            const double tolerance = share * diagonal(lattice);
            for (const SplitPoint split : {SplitPoint::equidistributed, SplitPoint::midpoint,
                                           SplitPoint::greville, SplitPoint::greatest_error}) {
                const RefinementResult out = refine_one(
                    unit_cube(), lattice, {.tolerance_world = tolerance, .split = split});
                EXPECT_LE(out.bound, tolerance);
                EXPECT_EQ(out.not_certified(), 0u);
                EXPECT_LE(drawn_error(*out.parts[0].mesh, {}, lattice), out.bound);
            }
        }
}

TEST(Refining, LeavesNoTJunctions)
{
    const RefinementResult out = refine_one(unit_cube(), noisy(4), {.tolerance_world = 0.005});
    const EdgeCount edges = count_edges(*out.parts[0].mesh);
    EXPECT_GT(edges.edges, 300);
    EXPECT_EQ(edges.open + edges.crowded + edges.against, 0);
    EXPECT_NEAR(volume(*out.parts[0].mesh), 1, 1e-6);
}

TEST(Refining, CanBeStopped)
{
    int told = 0;
    const Progress stop = [&](double fraction, std::string_view) {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
        if (++told == 5) throw Cancelled();
    };
    EXPECT_THROW(refine({{make_ref(unit_cube()), {}}}, noisy(4), {.tolerance_world = 0.005}, stop),
                 Cancelled);
    EXPECT_EQ(told, 5);
}

TEST(Refining, SplitsNothingWhereTheMapIsAffine)
{
    const Lattice lattice = one_cell(
        4, [](const glm::dvec3& p) { return glm::dvec3(2 * p.x - p.y, 3 * p.z, p.x + 7); });
    const Ref<Mesh> cube = make_ref(unit_cube());
    const RefinementResult out = refine({{cube, {}}}, lattice, {.tolerance_world = 1e-4});
    EXPECT_EQ(out.parts[0].mesh, cube);
    EXPECT_LT(out.bound, 2e-5);
}

TEST(Refining, TakesFarFewerTrianglesThanTheThesisAndHardlyMoreThanTheUncertifiedMiddles)
{
    double ours = 0, middles = 0;
    for (const double share : {0.02, 0.01, 0.005})
        for (const Lattice& lattice : {one_cell(4, bend), one_cell(4, twist), noisy(4)}) {
            const bool bent_cube = lattice == one_cell(4, bend);
            const double tolerance = share * diagonal(lattice);
            const auto count = [&](RefinementRule rule, BoundMethod method, SplitPoint split) {
                return double(refine_one(unit_cube(), lattice,
                                         {.tolerance_world = tolerance,
                                          .split = split,
                                          .method = method,
                                          .rule = rule})
                                  .triangles());
            };
            const double one = count(RefinementRule::edge_driven, BoundMethod::composed_net,
                                     SplitPoint::equidistributed);
            ours += one;
            const double middle = count(RefinementRule::chua_neumann_midpoint,
                                        BoundMethod::composed_net, SplitPoint::midpoint);
            middles += middle;
            const double thesis =
                count(RefinementRule::thesis_four_split, BoundMethod::thesis, SplitPoint::midpoint);
            EXPECT_LT(one, (bent_cube ? 0.05 : 0.07) * thesis);
            EXPECT_LE(one, (bent_cube ? 1.1 : 1.5) * middle);
        }
    EXPECT_LT(ours, 1.1 * middles);
}

TEST(Refining, TheUncertifiedMiddlesDoMissTheTolerance)
{
    // An S along x: the middle of an edge lies on its chord.
    const Lattice lattice = one_cell(4, [](const glm::dvec3& p) {
        return p + glm::dvec3(0, 0,
                              p.x > 0.2 && p.x < 0.5   ? 0.5
                              : p.x > 0.5 && p.x < 0.8 ? -0.5
                                                       : 0);
    });
    const RefinementResult middles =
        refine_one(unit_cube(), lattice,
                   {.tolerance_world = 0.02, .rule = RefinementRule::chua_neumann_midpoint});
    EXPECT_GT(drawn_error(*middles.parts[0].mesh, {}, lattice), 0.04);
    EXPECT_EQ(middles.bound, std::numeric_limits<double>::infinity());
    const RefinementResult ours = refine_one(unit_cube(), lattice, {.tolerance_world = 0.02});
    EXPECT_LE(drawn_error(*ours.parts[0].mesh, {}, lattice), 0.02);
}

TEST(Refining, GivesTheSameBitsForAnyNumberOfThreads)
{
    const RefineOptions options{.tolerance_world = 0.002};
    const RefinementResult many = refine_one(unit_cube(), noisy(4), options);
    const ThreadLimit limit(1);
    const RefinementResult one = refine_one(unit_cube(), noisy(4), options);
    EXPECT_EQ(*many.parts[0].mesh, *one.parts[0].mesh);
    EXPECT_EQ(many.bound, one.bound);
}

TEST(Refining, LeavesNoNeedlesBesideAnEdgeThatIsJustWithinTheTolerance)
{
    // Half of an S is further off its chord than all of it.
    const Knots knots = Knots::uniform(4, 8);
    const Lattice lattice{random_volume({knots, knots, Knots::uniform(3, 4)}, 8, 0.1),
                          glm::dmat4(1)};
    const RefinementResult out = refine_one(unit_cube(), lattice, {.tolerance_world = 0.001});
    EXPECT_EQ(out.not_certified(), 0u);
    EXPECT_LT(out.depth, 14);
}

TEST(Refining, LeavesNoNeedlesWhereTheVolumeHasKinks)
{
    // An edge of order 2 is a chain of chords, whose ends may be off an S by twice the edge's own
    // error.
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.002, 0.02);
    for (int seed = 1; seed <= 6; ++seed) {
        const Lattice lattice{
            random_volume({Knots::uniform(2, 9), Knots::uniform(2, 7), Knots::uniform(2, 4)},
                          static_cast<unsigned>(seed), 0.1),
            glm::dmat4(1)};
        for (int i = 0; i < 20; ++i) {
            const RefinementResult out =
                refine_one(unit_cube(), lattice, {.tolerance_world = share(random)});
            EXPECT_EQ(out.not_certified(), 0u);
            EXPECT_LT(out.depth, 14);
        }
    }
}

TEST(Refining, ListsWhatABudgetLeavesOver)
{
    const Lattice lattice = noisy(4);
    for (const std::size_t budget : {std::size_t{12}, std::size_t{100}, std::size_t{300}}) {
        const RefinementResult out =
            refine_one(unit_cube(), lattice, {.tolerance_world = 0.001, .budget = budget});
        EXPECT_LE(out.triangles(), budget);
        EXPECT_GT(out.triangles(), budget / 2);
        EXPECT_TRUE(out.out_of_budget);
        EXPECT_GT(out.not_certified(), 0u);
        EXPECT_GT(out.bound, 0.001);
        EXPECT_GE(out.bound, drawn_error(*out.parts[0].mesh, {}, lattice));
        EXPECT_EQ(count_edges(*out.parts[0].mesh).open, 0);
    }
}

TEST(Refining, TakesMeshesThatReachOutOfTheVolume)
{
    Mesh mesh = unit_cube();
    for (glm::vec3& p : mesh.positions) p = p * 1.5f - 0.3f;
    const Knots knots = Knots::uniform(4, 7);
    const Lattice lattice{random_volume({knots, knots, knots}, 4, 0.1), glm::dmat4(1)};
    const RefinementResult out = refine_one(mesh, lattice, {.tolerance_world = 0.01});
    EXPECT_LE(out.bound, 0.01);
    EXPECT_LE(drawn_error(*out.parts[0].mesh, {}, lattice), out.bound);
    EXPECT_EQ(count_edges(*out.parts[0].mesh).open, 0);
}

TEST(Refining, TakesTriangleWithoutAreaAndEdgesOfThreeFaces)
{
    Mesh mesh = unit_cube();
    add_face(mesh, std::array<std::uint32_t, 3>{0, 7, 7});
    add_face(mesh, std::array<std::uint32_t, 3>{0, 1, 7}); // a third face at two edges
    mesh.positions.emplace_back(0, 0.5f, 0);
    add_face(mesh, std::array<std::uint32_t, 3>{0, 8, 2}); // a line
    const Lattice lattice = noisy(4);
    const RefinementResult out = refine_one(mesh, lattice, {.tolerance_world = 0.01});
    EXPECT_GE(out.parts[0].degenerate, 2u);
    EXPECT_EQ(out.not_certified(), 0u);
    EXPECT_LE(drawn_error(*out.parts[0].mesh, {}, lattice), 0.01);
}

TEST(Refining, RefusesATolerancThatIsNoneOrFinerThanRounding)
{
    for (const double tolerance : {0.0, -1.0, 1e-9, std::nan("")})
        EXPECT_THROW(refine_one(unit_cube(), noisy(4), {.tolerance_world = tolerance}), Rejected);
}

} // namespace
} // namespace trivar
