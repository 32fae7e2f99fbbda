// SPDX-License-Identifier: GPL-3.0-or-later
// What incisions do to each other.
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

double gap_of(const IncisedMesh& made, std::size_t k, const std::vector<Incision>& cuts)
{
    return made.outcomes[k].widest * cuts[k].width;
}

double distance_to(const std::vector<SurfacePoint>& stroke, const glm::dvec3& p)
{
    double out = 1e300;
    for (const SurfacePoint& each : stroke) out = std::min(out, glm::distance(each.p, p));
    return out;
}

// Three that cross at one place, and a small one over one of them, away from that.
std::vector<Incision> star_and_small_one()
{
    std::vector<Incision> out;
    for (const double angle : {0.1, 1.15, 2.2}) {
        const double y = 0.4 * std::cos(angle), z = 0.4 * std::sin(angle);
        out.push_back(cut_on_sphere({{1, -y, -z}, {1, y, z}}, 0.1, 0.08));
    }
    out.push_back(cut_on_sphere({{1, 0.22, -0.02}, {1, 0.24, 0.1}}, 0.03, 0.02));
    return out;
}

TEST(NewIncisions, ChangeOlderOnesOnlyWhereTheyMeet)
{
    const SlitSkin skin = skin_of(icosphere(5));
    const std::vector<Incision> all = star_and_small_one();
    const std::vector<Incision> older(all.begin(), all.end() - 1);
    const IncisedMesh before = incise(skin, older), after = incise(skin, all);
    for (std::size_t k = 0; k < older.size(); ++k) {
        EXPECT_EQ(after.outcomes[k].widest, before.outcomes[k].widest);
        EXPECT_NEAR(after.outcomes[k].depth, before.outcomes[k].depth, 1e-9);
    }
    const Ref<Mesh> open = opened(after, std::vector<IncisionOpening>(4)),
                    open_before = opened(before, std::vector<IncisionOpening>(3));
    const double reach = reach_of(all[3], length_of(all[3].stroke));
    std::size_t beyond = 0;
    for (std::size_t v = 0; v < skin.mesh()->vertex_count(); ++v) {
        if (distance_to(all[3].stroke, glm::dvec3(skin.mesh()->positions[v])) < 1.5 * reach)
            continue;
        EXPECT_LT(glm::distance(open->positions[v], open_before->positions[v]), 1e-5f);
        beyond += open->positions[v] != skin.mesh()->positions[v];
    }
    EXPECT_GT(beyond, 200u); // what the older ones move
    EXPECT_GT(after.outcomes[3].widest, 0.9);
}

TEST(NewIncisions, NeverMakeOlderOnesNarrowerThanTheyWere)
{
    for (std::size_t body = 0; body < 5; ++body) {
        const SlitSkin skin = skin_of(any_closed_primitive(body));
        for (const std::size_t kind : {0u, 1u, 6u}) { // an angle, a T and three
            RandomHand hand(skin, 700 + 10 * body + kind);
            const std::vector<Incision> all = random_set(skin, hand, kind);
            if (all.size() < 2) continue;
            const std::vector<Incision> older(all.begin(), all.end() - 1);
            const IncisedMesh before = incise(skin, older), after = incise(skin, all);
            for (std::size_t k = 0; k < older.size(); ++k)
                EXPECT_GT(gap_of(after, k, all), 0.9 * gap_of(before, k, all))
                    << body << " " << kind << " " << k;
        }
    }
}

TEST(NewIncisions, OpenBesideAShutOneAsIfItWereNotThere)
{
    for (std::size_t body = 0; body < 5; ++body) {
        const SlitSkin skin = skin_of(any_closed_primitive(body));
        for (const std::size_t kind : {0u, 1u, 3u, 9u}) { // an angle, a T, side by side, two depths
            RandomHand hand(skin, 300 + 10 * body + kind);
            const std::vector<Incision> all = random_set(skin, hand, kind);
            if (all.size() != 2) continue;
            const IncisedMesh both = incise(skin, all);
            for (std::size_t k = 0; k < 2; ++k) {
                const IncisedMesh alone = incise(skin, std::vector{all[k]});
                if (!both.outcomes[k].refusal.empty() || !alone.outcomes[0].refusal.empty())
                    continue;
                EXPECT_GT(both.outcomes[k].widest_alone, 0.7 * alone.outcomes[0].widest)
                    << body << " " << kind << " " << k << " " << alone.outcomes[0].widest;
            }
        }
    }
}

TEST(NewIncisions, PierceNothingWhicheverOfThemAreOpen)
{
    for (std::size_t body = 0; body < 5; ++body) {
        const SlitSkin skin = skin_of(any_closed_primitive(body));
        for (std::size_t kind = 0; kind < cut_kinds.size(); kind += 3) {
            RandomHand hand(skin, 900 + 10 * body + kind);
            const std::vector<Incision> all = random_set(skin, hand, kind);
            const IncisedMesh made = incise(skin, all);
            for (int round = 0; round < 4; ++round) {
                std::vector<IncisionOpening> openings(all.size());
                for (IncisionOpening& each : openings)
                    each.share = hand.number() < 0.5 ? 0 : hand.number() < 0.5 ? 1 : 0.6;
                EXPECT_EQ(piercings_at(made, openings), 0u) << body << " " << kind;
            }
        }
    }
}

} // namespace
} // namespace trivar::testing
