// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

namespace trivar {
namespace {

using namespace testing;

// Deforms a mesh on every instruction set that was compiled and that this processor has.
std::vector<std::pair<std::int64_t, Mesh>> on_every_target(const Mesh& mesh, const Lattice& lattice)
{
    std::vector<std::pair<std::int64_t, Mesh>> out;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        out.emplace_back(target, deform(mesh, {}, lattice));
        hwy::SetSupportedTargetsForTest(0);
    }
    return out;
}

// The fewer the bit's number, the better the target: AVX2 and all better ones fuse.
bool fuses(std::int64_t target)
{
    return target <= HWY_AVX2;
}

std::vector<Lattice> lattices()
{
    std::vector<Lattice> out;
    for (const std::array<int, 3> order : {std::array{3, 3, 3}, {4, 4, 4}, {2, 5, 3}, {6, 6, 6}})
        out.push_back(random_lattice(
            {Knots::uniform(order[0], 7), uneven_knots(order[1]), Knots::periodic(order[2], 8)},
            0.05));
    return out;
}

TEST(Targets, WithFusedMultiplyAddsGiveTheSameBitsAndSoDoThoseWithout)
{
    const Mesh mesh = scattered_points(20000, -0.2f, 1.2f);
    for (const Lattice& lattice : lattices()) {
        std::array<const Mesh*, 2> first{};
        const auto all = on_every_target(mesh, lattice);
        for (const auto& [target, out] : all) {
            SCOPED_TRACE(hwy::TargetName(target));
            const Mesh*& same = first[fuses(target)];
            if (same == nullptr) same = &out;
            EXPECT_EQ(bits(out.positions), bits(same->positions));
            EXPECT_EQ(bits(out.normals), bits(same->normals));
            EXPECT_EQ(bits(out.tangents), bits(same->tangents));
        }
    }
}

// Positions lie within 2 of the unit box, where single precision has steps of 1.2e-7: fusing may
// change the last two of them. Directions lose what J does to them.
TEST(Targets, WithAndWithoutFusedMultiplyAddsAgreeToTheLastSteps)
{
    const Mesh mesh = scattered_points(20000, -0.2f, 1.2f);
    for (const Lattice& lattice : lattices()) {
        const auto all = on_every_target(mesh, lattice);
        for (const auto& [target, out] : all) {
            SCOPED_TRACE(hwy::TargetName(target));
            const Mesh& best = all.front().second;
            EXPECT_LE(largest_distance(out.positions, best.positions), 3e-7);
            EXPECT_LE(largest_distance(out.normals, best.normals), 1e-5);
        }
    }
}

TEST(Targets, ReturnTheVeryBitsOfAMeshInALatticeAtRest)
{
    const Mesh mesh = scattered_points(1000, -0.5, 1.5);
    const Knots k = Knots::uniform(4, 6);
    for (const auto& [target, out] :
         on_every_target(mesh, lattice_at_rest({k, k, k}, glm::dmat4(1))))
        EXPECT_EQ(out, mesh) << hwy::TargetName(target);
}

TEST(Targets, GiveTheSameBitsForAnyNumberOfThreads)
{
    const Mesh mesh = scattered_points(100000);
    const Lattice lattice = lattices().front();
    const ThreadLimit two(2);
    const auto parallel = on_every_target(mesh, lattice);
    const ThreadLimit one(1);
    const auto alone = on_every_target(mesh, lattice);
    for (std::size_t i = 0; i < alone.size(); ++i)
        EXPECT_EQ(parallel[i].second, alone[i].second) << hwy::TargetName(alone[i].first);
}

} // namespace
} // namespace trivar
