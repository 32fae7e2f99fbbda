// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every cut, tried with random ones.
#include "core/base/parallel.h"
#include "core/mesh/closed_body.h"
#include "tests/incise/bodies.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

constexpr IncisionOpening shut{0, 0, 1};

struct RandomSlit {
    std::string what;
    std::vector<Incision> incisions;
};

// Returns a random cut of any kind, the same for the same number.
RandomSlit random_cut(const SlitSkin& skin, std::size_t number)
{
    RandomHand hand(skin, 40 + number);
    const std::size_t kind = number % (cut_kinds.size() + 2);
    if (kind < cut_kinds.size()) return {cut_kinds[kind], random_set(skin, hand, kind)};
    const bool loop = kind > cut_kinds.size();
    return {loop ? "loop" : "single", {random_single(skin, hand, loop)}};
}

class OnPrimitives : public ::testing::TestWithParam<std::size_t> {
protected:
    void for_cuts(std::size_t count, const auto& look)
    {
        const SlitSkin skin = skin_of(any_closed_primitive(GetParam()));
        for (std::size_t i = 0; i < count; ++i) {
            const RandomSlit cut = random_cut(skin, 100 * GetParam() + i);
            SCOPED_TRACE(cut.what + " #" + std::to_string(i));
            look(skin, cut.incisions);
        }
    }
};

TEST_P(OnPrimitives, CutsAreClosedAndManifoldAndKeepTheEulerNumberAndEveryVertex)
{
    for_cuts(24, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const IncisedMesh made = incise(skin, incisions);
        const SlitFaults faults = faults_of(made);
        EXPECT_EQ(faults.open, 0u);
        EXPECT_EQ(faults.twice, 0u);
        EXPECT_EQ(faults.pinched, 0u);
        EXPECT_EQ(faults.euler, 0);
        EXPECT_EQ(faults.lost, 0u);
        EXPECT_LT(std::abs(faults.volume), 1e-9); // positions are floats
        for (const IncisedMesh::Outcome& outcome : made.outcomes) EXPECT_EQ(outcome.refusal, "");
    });
}

TEST_P(OnPrimitives, ShutCutsAreTheOriginalItself)
{
    for_cuts(12, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const IncisedMesh made = incise(skin, incisions);
        const std::vector<IncisionOpening> all(incisions.size(), shut);
        EXPECT_EQ(opened(made, all), skin.mesh());
        const Mesh& before = *skin.mesh();
        const std::vector<glm::vec3> positions = opened_vertices(made, all).positions;
        for (std::size_t v = 0; v < before.vertex_count(); ++v)
            ASSERT_EQ(made.rest->positions[v], before.positions[v]);
        for (std::size_t i = 0; i < made.moved.size(); ++i)
            ASSERT_EQ(positions[i], made.rest->positions[made.moved[i]]);
    });
}

TEST_P(OnPrimitives, VerticesOfOnePointStayAtOnePlaceWhateverOpens)
{
    for_cuts(12, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const IncisedMesh made = incise(skin, incisions);
        std::vector<IncisionOpening> openings(incisions.size());
        EXPECT_EQ(copies_apart(*made.rest), 0u);
        EXPECT_EQ(copies_apart(*opened(made, openings)), 0u);
        openings[0] = {0.4, 0.1, 0.6};
        EXPECT_EQ(copies_apart(*opened(made, openings)), 0u);
    });
}

TEST_P(OnPrimitives, NothingPiercesAtAnOpeningThatIsAdmitted)
{
    for_cuts(24, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const IncisedMesh made = incise(skin, incisions);
        for (const double share : {1.0, 0.6, 0.3})
            EXPECT_EQ(
                piercings_at(made, std::vector(incisions.size(), IncisionOpening{share, 0, 1})),
                0u);
    });
}

TEST_P(OnPrimitives, NothingOutsideTheTermsMoves)
{
    for_cuts(12, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const IncisedMesh made = incise(skin, incisions);
        const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(incisions.size()));
        if (open == made.original) return; // the guard admits no opening
        EXPECT_EQ(open->corners, made.rest->corners);
        EXPECT_EQ(open->points, made.rest->points);
        std::vector<char> moves(open->vertex_count(), 0);
        for (const std::uint32_t v : made.moved) moves[v] = 1;
        for (std::size_t v = 0; v < open->vertex_count(); ++v)
            if (!moves[v]) {
                ASSERT_EQ(open->positions[v], made.rest->positions[v]);
            }
        double reach = 0;
        for (const Incision& each : incisions) reach = std::max(reach, each.width);
        for (std::size_t i = 0; i < made.moved.size(); ++i)
            EXPECT_LE(
                glm::distance(open->positions[made.moved[i]], made.rest->positions[made.moved[i]]),
                reach * static_cast<double>(incisions.size()));
    });
}

TEST_P(OnPrimitives, TheTopologyDoesNotDependOnWidths)
{
    for_cuts(12, [](const SlitSkin& skin, std::vector<Incision> incisions) {
        const InciseOptions free{.guarded = false};
        const IncisedMesh made = incise(skin, incisions, free);
        for (Incision& each : incisions) each.width *= 0.3;
        const IncisedMesh narrow = incise(skin, incisions, free);
        EXPECT_EQ(narrow.rest->corners, made.rest->corners);
        EXPECT_EQ(narrow.rest->points, made.rest->points);
    });
}

TEST_P(OnPrimitives, OneThreadAndTwoGiveTheSameBits)
{
    for_cuts(12, [](const SlitSkin& skin, const std::vector<Incision>& incisions) {
        const std::vector<IncisionOpening> openings(incisions.size(), {0.8, 0, 0.7});
        const auto made = [&](int threads) {
            const ThreadLimit limit(threads);
            return opened(incise(skin, incisions), openings);
        };
        EXPECT_EQ(*made(1), *made(2));
    });
}

INSTANTIATE_TEST_SUITE_P(Incise, OnPrimitives, ::testing::Range<std::size_t>(0, 5));

} // namespace
} // namespace trivar::testing
