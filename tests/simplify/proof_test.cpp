// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/proof.h"

#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// Where a quarter of the nodes get less tolerance, round after round.
TEST(SimplifyProof, FindsInALaterRoundWhatItWouldFindInTheFirst)
{
    const Mesh mesh = bumpy_torus({64, 32});
    const Fans fans = fans_of(mesh);
    VertexPlaces places(1);
    for (const glm::vec3& p : mesh.positions) places[0].emplace_back(p);
    NodePlaces nodes(1);
    for (const std::uint32_t v : fans.vertex) nodes[0].push_back(places[0][v]);
    constexpr double distance = 0.02;
    Proof rounds(fans, places, distance);
    DecimationTarget target{0, std::vector<double>(fans.vertex.size(), distance)};
    std::size_t found = 0;
    for (std::size_t round = 0; round < 4; ++round) {
        const Decimation left = decimated(mesh, fans, nodes, target);
        const std::vector<std::uint32_t> bad = rounds.unproven_nodes(left);
        EXPECT_EQ(bad, Proof(fans, places, distance).unproven_nodes(left));
        found += bad.size();
        for (std::size_t n = round; n < target.tolerance.size(); n += 16) target.tolerance[n] /= 2;
    }
    EXPECT_GT(found, 0u);
}

} // namespace trivar::testing
