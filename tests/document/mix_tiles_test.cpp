// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "tests/document/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

constexpr Id base_ball = 2, layer_stud = 8, other_box = 9; // of mixed_document()

// A layer of cylinders on a ball, mixed with a box that is red.
Document mixed_document(double own = 1, double of_box = 1)
{
    Document document = after(fitting_document(), ClearTiles{{layer_stud}});
    document = after(document, AddBox{.shape = {.size = {0.2, 0.2, 0.1}}});
    document = after(document, SetMaterial{{other_box}, {.base_color = {1, 0, 0, 1}}});
    TileStroke stroke = a_tile_stroke();
    stroke.radius = 0.15;
    stroke.size = 0.05;
    document = after(document, PaintTiles{layer_stud, base_ball, stroke});
    return after(document, MixTiles{layer_stud, own, {{other_box, of_box}}});
}

Ref<EvaluatedObject> shown_mix(const Document& document)
{
    return new_evaluator()(document, 1).objects.at(layer_stud);
}

std::size_t tiles_of_part(const Part& part)
{
    return part.tiles->tiles->size();
}

void expect_no_mix(const Command& command, const char* why)
{
    try {
        after(mixed_document(), command);
        ADD_FAILURE() << "taken";
    } catch (const Rejected& rejected) {
        EXPECT_THAT(rejected.what(), ::testing::HasSubstr(why));
    }
}

TEST(MixTiles, PutsBothObjectsAmongTheTilesWithTheirMaterials)
{
    const Ref<EvaluatedObject> mixed = shown_mix(mixed_document());
    ASSERT_EQ(mixed->parts.size(), 2u);
    EXPECT_GT(tiles_of_part(mixed->parts[0]), 5u);
    EXPECT_GT(tiles_of_part(mixed->parts[1]), 5u);
    EXPECT_NE(mixed->parts[0].key, mixed->parts[1].key);
    const Mesh& boxes = *mixed->parts[1].mesh();
    ASSERT_FALSE(boxes.face_material.empty());
    EXPECT_EQ(mixed->materials->at(boxes.face_material[0]).base_color, glm::vec4(1, 0, 0, 1));
    const Mesh& own = *mixed->parts[0].mesh();
    const std::uint32_t first = own.face_material.empty() ? 0 : own.face_material[0];
    EXPECT_NE(mixed->materials->at(first).base_color, glm::vec4(1, 0, 0, 1));
}

TEST(MixTiles, KeepsEveryTileWhereItWas)
{
    const auto count = [](const Document& document) {
        std::size_t all = 0;
        const Ref<EvaluatedObject> shown = shown_mix(document); // the loop keeps no temporary
        for (const Part& part : shown->parts) all += tiles_of_part(part);
        return all;
    };
    const std::size_t alone = count(after(mixed_document(), MixTiles{layer_stud, 1, {}}));
    EXPECT_EQ(count(mixed_document()), alone);
    EXPECT_EQ(count(mixed_document(0, 1)), alone);
    EXPECT_EQ(shown_mix(mixed_document(0, 1))->parts.size(), 1u);
}

TEST(MixTiles, FollowsTheOtherObject)
{
    Document document = mixed_document();
    document = after(document, SetMaterial{{other_box}, {.base_color = {0, 1, 0, 1}}});
    const Ref<EvaluatedObject> mixed = shown_mix(document);
    EXPECT_EQ(mixed->materials->back().base_color, glm::vec4(0, 1, 0, 1));
    // It stands nowhere else, unless somebody shows it.
    EXPECT_TRUE(object(document, other_box).hidden);
    EXPECT_EQ(shown_mix(after(document, Show{{other_box}}))->parts.size(), 2u);
    const Document shown =
        after(after(document, Show{{other_box}}), MixTiles{layer_stud, 1, {{other_box, 3}}});
    EXPECT_FALSE(object(shown, other_box).hidden);
    // And where it goes the layer is all of its own tile again.
    const Document without = after(document, Delete{{other_box}});
    EXPECT_TRUE(object(without, layer_stud).tiles->others.empty());
    EXPECT_EQ(shown_mix(without)->parts.size(), 1u);
}

TEST(MixTiles, MayBeginWithAStroke)
{
    const Document before = after(mixed_document(), ClearTiles{{layer_stud}});
    const Document painted =
        after(before, PaintTiles{layer_stud, base_ball, a_tile_stroke(), {{other_box, 0.5}}});
    EXPECT_EQ(object(painted, layer_stud).tiles->others,
              (std::vector<MixedTile>{{other_box, 0.5}}));
    EXPECT_TRUE(object(painted, other_box).hidden);
    const Document again = after(painted, PaintTiles{layer_stud, base_ball, a_tile_stroke(), {}});
    EXPECT_EQ(object(again, layer_stud).tiles->others, object(painted, layer_stud).tiles->others);
}

TEST(MixTiles, LeavesOutWhatBecameALayerItself)
{
    const Document document =
        after(mixed_document(), PaintTiles{other_box, base_ball, a_tile_stroke()});
    EXPECT_EQ(shown_mix(document)->parts.size(), 1u);
}

TEST(MixTiles, IsPastedWithWhatItIsMixedWith)
{
    const Document document = mixed_document();
    const Document pasted =
        after(document, copied(document, {base_ball, layer_stud, other_box}, "/"));
    const Object& layer = object(pasted, document.next_id + 1);
    ASSERT_TRUE(layer.tiles);
    ASSERT_EQ(layer.tiles->others.size(), 1u);
    EXPECT_EQ(layer.tiles->others[0].object, document.next_id + 2);
    const Document alone = after(document, copied(document, {layer_stud}, "/"));
    EXPECT_EQ(object(alone, document.next_id).tiles->others[0].object, other_box);
}

TEST(MixTiles, IsRefusedInASentence)
{
    expect_no_mix(MixTiles{layer_stud, 1, {{layer_stud, 1}}}, "is the layer itself");
    expect_no_mix(MixTiles{layer_stud, 1, {{other_box, 1}, {other_box, 2}}}, "twice");
    expect_no_mix(MixTiles{layer_stud, 1, {{99, 1}}}, "99");
    expect_no_mix(MixTiles{other_box, 1, {{base_ball, 1}}}, "no layer of tiles");
    expect_no_mix(MixTiles{layer_stud, 1, {{3, 1}}}, "lies on a stroke");
    expect_no_mix(MixTiles{layer_stud, 1, {{other_box, -1}}}, "weight");
    // What is mixed in cannot be painted on the layer, nor laid on it.
    expect_no_mix(PaintTiles{other_box, layer_stud, a_tile_stroke()}, "depends on");
}

} // namespace
} // namespace trivar
