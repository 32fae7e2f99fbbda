// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/refine.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/refinement/refine.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;
using testing::small_document;

constexpr Id pot = 3;

Evaluation evaluated(const Document& document, double frame = 1)
{
    Evaluator evaluator(std::make_shared<const AssetStore>("/nowhere"));
    return evaluator(document, frame);
}

std::size_t triangle_count(const Evaluation& scene)
{
    std::size_t count = 0;
    for (const Part& part : scene.objects.at(pot)->parts) count += triangles(*part.rest).size();
    return count;
}

TEST(Refining, SplitsWhatLiesInAVolumeAndGivesItBack)
{
    const Document before = small_document();
    const Document refined = after(before, Refine{{pot}, {.tolerance = 1e-4}});
    const Evaluation scene = evaluated(refined), plain = evaluated(before);
    ASSERT_TRUE(scene.objects.at(pot)->refined);
    EXPECT_LE(scene.objects.at(pot)->refined->bound, 1e-4);
    EXPECT_THAT(scene.objects.at(pot)->notices, IsEmpty());
    EXPECT_GT(triangle_count(scene), triangle_count(plain));
    EXPECT_NE(digest(refined), digest(before));
    const Document cleared = after(refined, ClearRefine{{pot}});
    EXPECT_EQ(digest(cleared), digest(before));
    EXPECT_EQ(digest(evaluated(cleared)), digest(plain));
}

TEST(Refining, HoldsForEveryFrame)
{
    PlacementParameters p;
    p.fill = 0.3;
    Document document = after(small_document(), EditPlacement{pot, p, {}, {}});
    document = after(document, SetTravel{{pot}, {.speed = 0.5}});
    document = after(document, Refine{{pot}, {.tolerance = 1e-4}});
    std::set<std::size_t> counts;
    for (const double frame : {1.0, 12.0, 30.0}) {
        const Evaluation scene = evaluated(document, frame);
        ASSERT_TRUE(scene.objects.at(pot)->refined);
        EXPECT_LE(scene.objects.at(pot)->refined->bound, 1e-4);
        counts.insert(triangle_count(scene));
    }
    EXPECT_GT(counts.size(), 1u) << "the same triangles in every frame";
}

TEST(Refining, SaysWhatIsNotCertified)
{
    const auto notice = [](const Refining& refining) {
        const Evaluation scene = evaluated(after(small_document(), Refine{{pot}, refining}));
        const auto& notices = scene.objects.at(pot)->notices;
        return notices.empty() ? std::string() : notices.front();
    };
    EXPECT_THAT(notice({.tolerance = 1e-5, .budget = 700}),
                HasSubstr("the 700 triangles that it may have are spent"));
    EXPECT_THAT(notice({.tolerance = 1e-3, .rule = RefinementRule::chua_neumann_midpoint}),
                HasSubstr("certifies nothing"));
    EXPECT_THAT(notice({.tolerance = 1e-8}),
                HasSubstr("finer than the precision of the coordinates"));
}

TEST(Refining, IsRefusedInASentence)
{
    const auto why = [](const Command& command) {
        try {
            after(small_document(), command);
        } catch (const Rejected& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    EXPECT_THAT(why(Refine{{pot}, {.tolerance = 0}}), HasSubstr("tolerance"));
    EXPECT_THAT(why(Refine{{pot}, {.tolerance = -1}}), HasSubstr("tolerance"));
    EXPECT_THAT(why(Refine{{2}, {}}), HasSubstr("is neither placed"));
    EXPECT_THAT(why(Refine{{pot}, {.method = BoundMethod::thesis_circumradius}}),
                HasSubstr("is wrong"));
}

} // namespace
} // namespace trivar
