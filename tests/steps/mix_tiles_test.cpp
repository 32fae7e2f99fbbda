// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/paste.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

constexpr Id base_ball = 2, layer_stud = 8, other_box = 13; // of mixed_document()

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
        const Ref<EvaluatedObject> shown = shown_mix(document);
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

TEST(MixTiles, TakesModelsIntoTheSceneInTheSameStep)
{
    TileFile thorn, scale;
    thorn.file.path = "thorn.glb";
    thorn.name = "Thorn";
    scale.file.path = "scale.glb";
    const Document before = after(mixed_document(), Show{{other_box}});
    const Id fresh = before.next_id;
    const PaintTiles paint{0, base_ball, a_tile_stroke(), {{other_box, 0.5}}, 0, {thorn, scale}};
    const Document painted = after(before, paint);
    ASSERT_EQ(painted.objects.size(), before.objects.size() + 2);
    const Object& layer = object(painted, fresh);
    EXPECT_EQ(layer.name, "Thorn");
    ASSERT_TRUE(layer.tiles);
    EXPECT_EQ(layer.tiles->base, base_ball);
    EXPECT_EQ(layer.tiles->others, (std::vector<MixedTile>{{other_box, 0.5}, {fresh + 1, 1}}));
    EXPECT_EQ(object(painted, fresh + 1).name, "scale");
    EXPECT_TRUE(object(painted, fresh + 1).hidden);
    EXPECT_FALSE(layer.hidden);
    EXPECT_EQ(step_title(paint, before, painted).text(), "Scatter Thorn on Ball");

    const CoverWithTiles cover{0, base_ball, {.pattern = TilePattern::grid}, {}, {thorn}};
    EXPECT_EQ(object(after(before, cover), fresh).tiles->cover.pattern, TilePattern::grid);
    EXPECT_EQ(step_title(cover, before, after(before, cover)).text(), "Cover Ball with Thorn");

    const MixTiles mix{layer_stud, 1, {}, {scale}};
    const Document mixed = after(before, mix);
    EXPECT_EQ(object(mixed, layer_stud).tiles->others, (std::vector<MixedTile>{{fresh, 1}}));
    EXPECT_TRUE(object(mixed, fresh).hidden);
    expect_no_mix(PaintTiles{0, base_ball, a_tile_stroke()}, "0");
    expect_no_mix(PaintTiles{0, base_ball, a_tile_stroke(), {}, 0, {TileFile{}}}, "path");
    EXPECT_EQ(command_from_json_line(to_json_line(paint)), Command(paint));
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
    // An object that is mixed in cannot be painted on the layer, nor laid on it.
    expect_no_mix(PaintTiles{other_box, layer_stud, a_tile_stroke()}, "depends on");
}

constexpr Id morphing = 13, morph_into = 14; // of morphing_document()

// A layer of cubes on the ball that become flat boxes, or what `into` makes.
Document morphing_document(const Command& into = AddBox{.shape = {.size = {0.2, 0.2, 0.05},
                                                                  .segments = {1, 1, 1}}},
                           TileLook look = {})
{
    Document document = after(fitting_document(), ClearTiles{{layer_stud}});
    document = after(document, AddBox{.shape = {.size = {0.2, 0.2, 0.2}, .segments = {1, 1, 1}}});
    document = after(document, into);
    TileStroke stroke = a_tile_stroke();
    stroke.radius = 0.15;
    stroke.size = 0.02;
    document = after(document, PaintTiles{morphing, base_ball, stroke, {}});
    document = after(document, MorphTiles{morphing, morph_into});
    return after(document, SetTiles{{morphing}, look});
}

// The greatest height of the tiles of each part over the ball.
std::vector<double> heights_of(const Document& document)
{
    std::vector<double> out;
    const Evaluation shown = new_evaluator()(document, 1);
    for (const Part& part : shown.objects.at(morphing)->parts) {
        double highest = 0;
        for (const glm::vec3& p : part.mesh()->positions)
            highest = std::max(highest, static_cast<double>(glm::length(p)) - 0.4);
        out.push_back(highest);
    }
    return out;
}

TEST(MorphTiles, GoFromOneShapeToTheOtherAndBeyond)
{
    const auto height = [](double morph) {
        return heights_of(morphing_document(
                              AddBox{.shape = {.size = {0.2, 0.2, 0.05}, .segments = {1, 1, 1}}},
                              {.morph = morph}))
            .at(0);
    };
    EXPECT_NEAR(height(0), 0.02, 1e-3);
    EXPECT_NEAR(height(0.5), 0.0125, 1e-3);
    EXPECT_NEAR(height(1), 0.005, 1e-3);
    EXPECT_NEAR(height(-0.5), 0.0275, 1e-3);
}

TEST(MorphTiles, ComeOneAfterTheOther)
{
    const auto heights = [](double morph) {
        return heights_of(
            morphing_document(AddBox{.shape = {.size = {0.2, 0.2, 0.05}, .segments = {1, 1, 1}}},
                              {.morph = morph, .morph_variation = 1, .phases = 4}));
    };
    ASSERT_EQ(heights(0.5).size(), 4u);
    for (const double each : heights(0)) EXPECT_NEAR(each, 0.02, 1e-3);
    for (const double each : heights(1)) EXPECT_NEAR(each, 0.005, 1e-3);
    std::vector<double> halfway = heights(0.5);
    EXPECT_NEAR(halfway.front(), 0.005, 1e-3);
    EXPECT_NEAR(halfway.back(), 0.02, 1e-3);
    EXPECT_TRUE(std::ranges::is_sorted(halfway));
}

TEST(MorphTiles, FollowAMask)
{
    const auto heights = [](double value) {
        const Document document =
            morphing_document(AddBox{.shape = {.size = {0.2, 0.2, 0.05}, .segments = {1, 1, 1}}},
                              {.morph = 1, .phases = 3});
        return heights_of(after(
            document,
            MaskTiles{morphing, 0, {.drives = MaskDrives::morph, .low = value, .high = value}}));
    };
    for (const auto& [value, height] :
         {std::pair(0.0, 0.02), std::pair(0.5, 0.0125), std::pair(1.0, 0.005)}) {
        ASSERT_EQ(heights(value).size(), 1u);
        EXPECT_NEAR(heights(value).at(0), height, 1e-3);
    }
}

TEST(MorphTiles, SayWhyTheyStayWhatTheyAre)
{
    const Document document = morphing_document(AddSphere{}, {.morph = 1});
    const Ref<EvaluatedObject> layer = new_evaluator()(document, 1).objects.at(morphing);
    EXPECT_THAT(layer->notices,
                ::testing::Contains(::testing::HasSubstr("its tiles cannot become Sphere")));
    EXPECT_NEAR(heights_of(document).at(0), 0.02, 1e-3);
    EXPECT_TRUE(object(document, morph_into).hidden);
    expect_no_mix(MorphTiles{layer_stud, layer_stud}, "is the layer itself");
    expect_no_mix(MorphTiles{other_box, base_ball}, "no layer of tiles");
    EXPECT_EQ(object(after(document, Delete{{morph_into}}), morphing).tiles->into, 0);
}

TEST(SlidingTiles, GoOverTheirBase)
{
    const auto middle = [](const glm::dvec2& slide) {
        glm::dvec3 sum(0);
        double count = 0;
        Document document = morphing_document();
        TileStroke one = a_tile_stroke();
        one.brush = TileBrush::line;
        one.samples.resize(1);
        one.size = 0.02;
        document = after(document, RemoveTileStrokes{morphing, {}});
        document = after(document, PaintTiles{morphing, base_ball, one, {}});
        document = after(document, SetTiles{{morphing}, {.slide_x = slide.x, .slide_y = slide.y}});
        const Evaluation shown = new_evaluator()(document, 1);
        for (const Part& part : shown.objects.at(morphing)->parts)
            for (const glm::vec3& p : part.mesh()->positions) {
                sum += glm::dvec3(p);
                ++count;
            }
        return sum / count;
    };
    const glm::dvec3 at = middle({0, 0}), ahead = middle({5, 0}), aside = middle({0, 5});
    EXPECT_NEAR(glm::length(at), glm::length(ahead), 1e-3);
    const double angle = std::acos(glm::dot(glm::normalize(at), glm::normalize(ahead)));
    EXPECT_NEAR(angle, 5 * 0.02 / 0.4, 0.01); // 5 sides along a great circle
    EXPECT_NEAR(glm::dot(glm::normalize(ahead - at), glm::normalize(aside - at)), 0, 0.1);
}

} // namespace
} // namespace trivar
