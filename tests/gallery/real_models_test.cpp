// SPDX-License-Identifier: GPL-3.0-or-later
// Spot, the bunny and the camel, laid by strokes on a mountain, on a face and on each other.

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

class RealDataStory : public ::testing::Test {
protected:
    void SetUp() override
    {
        const std::string folder = testing::real_data_folder();
        if (folder.empty()) GTEST_SKIP() << "there is no folder of real models here";
        const std::string path = TRIVAR_SOURCE_DIR "/tests/logs/real/spot_bunny_camel.trivar";
        document_ = replay(read_log(read_text_file(path), path)).document();
        assets_ = std::make_shared<const AssetStore>(folder + "/meshes");
    }
    Document document_;
    Ref<AssetStore> assets_;
};

TEST_F(RealDataStory, EveryStrokeLaysItsModelAndNothingPenetrates)
{
    int placed = 0;
    for (const auto& [id, object] : Evaluator(assets_)(document_).objects) {
        EXPECT_EQ(object->rejected, "") << "object " << id;
        if (!object->placement) continue;
        ++placed;
        EXPECT_LE(object->placement->report.penetration, 1e-3) << "object " << id;
    }
    EXPECT_EQ(placed, 9);
}

TEST_F(RealDataStory, IsTheSameBitsForOneThreadAndForTwo)
{
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return digest(Evaluator(assets_)(document_));
    };
    EXPECT_EQ(with_threads(1), with_threads(2));
}

} // namespace
} // namespace trivar
