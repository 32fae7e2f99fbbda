// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for cuts of primitives holds for those of real models.
#include "core/files/read_model.h"
#include "tests/incise/bodies.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"
#include "tests/support/fixtures.h"

#include <cstring>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

class RealDataIncise : public ::testing::TestWithParam<const char*> {};

TEST_P(RealDataIncise, SetsThatCrossLeaveTheSkinAsClosedAsItWasAndShutAreTheModelItself)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Model model = read_model(real_data_folder() + "/meshes/" + GetParam());
    const SlitSkin skin = skin_of(*model.meshes.front());
    std::size_t cut = 0;
    for (std::size_t i = 0; i < 3 * cut_kinds.size(); ++i) {
        SCOPED_TRACE(std::string(cut_kinds[i % cut_kinds.size()]) + " #" + std::to_string(i));
        RandomHand hand(skin, 900 + i);
        const std::vector<Incision> incisions = random_set(skin, hand, i % cut_kinds.size());
        const IncisedMesh made = incise(skin, incisions);
        EXPECT_TRUE(faults_of(made).none());
        EXPECT_EQ(copies_apart(*opened(made, std::vector<IncisionOpening>(incisions.size()))), 0u);
        const std::vector<IncisionOpening> all_shut(incisions.size(), {0, 0, 1});
        EXPECT_EQ(opened(made, all_shut), skin.mesh());
        cut += made.rest != made.original;
    }
    EXPECT_GE(cut, 3 * cut_kinds.size() - 2);
}

INSTANTIATE_TEST_SUITE_P(Of, RealDataIncise, ::testing::Values("face.obj", "spot.obj", "camel.off"),
                         [](const auto& name) {
                             return std::string(name.param, std::strchr(name.param, '.'));
                         });

} // namespace
} // namespace trivar::testing
