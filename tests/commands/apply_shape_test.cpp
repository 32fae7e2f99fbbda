// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/placement/apply_shape.h"
#include "core/commands/placement/place.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::small_document;

const ImportedFile pot_file{"Pot plain_001.glb", {}};

void expect_no_apply(const Document& document, const ApplyShape& command, const char* why)
{
    try {
        after(document, command);
        FAIL() << "it was not refused: " << why;
    } catch (const Rejected& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(ApplyShape, LeavesNothingOfTheStrokeAndWhatBelongsToTheObject)
{
    Document document = small_document();
    document = after(document, SetMaterial{{3}, {}});
    document = after(document, Simplify{{3}, {.keep = 0.5}});
    const Transform stands{.translation = {1, 2, 3}};
    const Document applied_to =
        after(document, ApplyShape{.object = 3, .file = pot_file, .transform = stands});
    const Object& before = object(document, 3);
    const Object& now = object(applied_to, 3);
    EXPECT_EQ(std::get<ImportedFile>(now.source), pot_file);
    EXPECT_EQ(now.name, before.name);
    EXPECT_EQ(now.parent, before.parent);
    EXPECT_EQ(now.surfacing, before.surfacing);
    EXPECT_EQ(now.transform, stands);
    EXPECT_FALSE(now.stroke || now.refining || now.simplifying);
    EXPECT_TRUE(now.shaping.empty() && now.tracks.empty());
    for (const auto& [id, each] : document.objects)
        if (id != 3) {
            EXPECT_EQ(applied_to.objects.at(id), each) << "others are not touched";
        }
}

TEST(ApplyShape, WhatItCarriesIsCarriedAsSaidAndElseStaysInTheWorld)
{
    Document document = small_document();
    Sketch sketch = testing::small_sketch();
    const Attachment by_pot{{attached_host(3, glm::dmat4(1), true)}};
    document = after(document, AddBox{});
    const Id rider = document.next_id - 1;
    document = after(document, Place{rider, sketch, {}, {3}, by_pot});
    const Document left =
        after(document, ApplyShape{.object = 3, .file = pot_file, .transform = {}});
    EXPECT_FALSE(object(left, rider).stroke->attach);
    EXPECT_EQ(object(left, rider).stroke->sketch, sketch);
    glm::dmat4 stands(1);
    stands[3] = {1, 2, 3, 1};
    const Attachment renewed{{attached_host(3, stands, true)}};
    sketch.samples.back().p_px.y += 3;
    const Document kept = after(document, ApplyShape{.object = 3,
                                                     .file = pot_file,
                                                     .transform = {},
                                                     .riders = {rider},
                                                     .strokes = {sketch},
                                                     .attach = {renewed}});
    EXPECT_EQ(object(kept, rider).stroke->attach, renewed);
    EXPECT_EQ(object(kept, rider).stroke->sketch, sketch);
}

TEST(ApplyShape, RefusesWhatMakesNoSense)
{
    const Document document = small_document();
    expect_no_apply(document, {.object = 1, .file = pot_file, .transform = {}}, "object 1");
    expect_no_apply(document, {.object = 3, .file = {}, .transform = {}}, "names no file");
    expect_no_apply(
        document, {.object = 3, .file = pot_file, .transform = {.scale = glm::dvec3(0)}}, "scale");
    expect_no_apply(document, {.object = 3, .file = pot_file, .transform = {}, .riders = {2}},
                    "0 and 0 entries for 1 riders");
    expect_no_apply(document,
                    {.object = 3,
                     .file = pot_file,
                     .transform = {},
                     .riders = {2},
                     .strokes = {testing::small_sketch()},
                     .attach = {{{attached_host(3, glm::dmat4(1), true)}}}},
                    "is not attached to");
}

} // namespace
} // namespace trivar
