// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/paste.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Ref<EvaluatedObject> result_of(const Document& document, Id id)
{
    return Evaluator(std::make_shared<const AssetStore>("/nowhere"))(document).objects.at(id);
}

Document ball()
{
    return after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 64, .rings = 32}});
}

TEST(SimplifiedObjects, HaveTheirShareOfTriangles)
{
    const Ref<EvaluatedObject> few = result_of(after(ball(), Simplify{{1}, {.keep = 0.1}}), 1);
    EXPECT_LE(few->triangles, few->triangles_before / 10 + 1);
    EXPECT_GE(few->triangles, few->triangles_before / 12);
    EXPECT_EQ(triangles(*few->parts.at(0).rest).size(), few->triangles);
    EXPECT_TRUE(few->notices.empty());
}

TEST(SimplifiedObjects, KeepMoreThanThatWhereItWouldTakeThemTooFar)
{
    const Ref<EvaluatedObject> few =
        result_of(after(ball(), Simplify{{1}, {.keep = 1e-3, .deviation = 0.02}}), 1);
    EXPECT_GT(few->triangles, few->triangles_before / 100);
    for (const glm::vec3& p : few->parts.at(0).mesh()->positions)
        EXPECT_NEAR(glm::length(p), 1, 1e-5) << "vertices are old ones";
}

TEST(SimplifiedObjects, AreBentWithTheTrianglesThatTheyHaveLeft)
{
    Document document = after(ball(), Simplify{{1}, {.keep = 0.1}});
    document = after(document, AddLattice{.objects = {1}, .shape = {.size = {2, 2, 2}}});
    document = after(document, WarpVolume{2, {.twist_deg = 45}});
    const Ref<EvaluatedObject> bent = result_of(document, 1);
    EXPECT_EQ(triangles(*bent->parts.at(0).rest).size(), bent->triangles);
    ASSERT_TRUE(bent->parts.at(0).bent);
}

TEST(SimplifiedObjects, GetAllTheirTrianglesBack)
{
    const Document few = after(ball(), Simplify{{1}, {.keep = 0.1}});
    EXPECT_NE(digest(few), digest(ball()));
    EXPECT_EQ(digest(after(few, ClearSimplify{{1}})), digest(ball()));
    EXPECT_EQ(result_of(after(few, ClearSimplify{{1}}), 1)->triangles_before, 0u);
}

TEST(SimplifiedObjects, AreCopiedAsTheyAre)
{
    const Document few = after(ball(), Simplify{{1}, {.keep = 0.25}});
    const Document both = after(few, copied(few, {1}, "/nowhere"));
    ASSERT_TRUE(both.objects.at(2)->simplifying);
    EXPECT_EQ(both.objects.at(2)->simplifying->keep, 0.25);
}

TEST(SimplifiedObjects, AreNoGroups)
{
    const Document group = after(ball(), Group{{1}});
    EXPECT_THAT(
        [&] {
            after(group, Simplify{{2}, {}});
        },
        ThrowsMessage<Rejected>(HasSubstr("simplify the objects in it")));
    EXPECT_THAT(
        [&] {
            after(ball(), Simplify{{1}, {.keep = 0}});
        },
        ThrowsMessage<Rejected>(HasSubstr("keep")));
}

} // namespace
} // namespace trivar
