// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of real models whose few gestures ended the program once.
#include "core/base/text.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::IsEmpty;

struct RealDataDeadlyScenes : ::testing::TestWithParam<const char*> {
    const std::string folder = testing::real_data_folder();
    void SetUp() override
    {
        if (folder.empty()) GTEST_SKIP() << "no real models are here";
    }
    // Whatever fails in a step ends the test.
    Evaluation evaluated() const
    {
        const std::string path = folder + "/found3/" + GetParam();
        return Evaluator(std::make_shared<const AssetStore>(folder + "/found3"))(
            replay(read_log(read_text_file(path), path)).document());
    }
};

TEST_P(RealDataDeadlyScenes, AreEvaluated)
{
    const Evaluation evaluation = evaluated();
    ASSERT_FALSE(evaluation.objects.empty());
    for (const auto& [id, object] : evaluation.objects) {
        EXPECT_THAT(object->lacks, IsEmpty()) << id;
        for (const Part& part : object->parts) EXPECT_GT(part.mesh()->face_count(), 0u) << id;
    }
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataDeadlyScenes,
                         ::testing::Values("crash_cut_pull.trivar",
                                           "crash_incision_off_skin.trivar",
                                           "crash_incision_leg_to_leg.trivar"));

} // namespace
} // namespace trivar
