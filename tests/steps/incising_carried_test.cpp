// SPDX-License-Identifier: GPL-3.0-or-later
// What is cut rides with all that bends, lays, covers, copies and exports it.
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "core/placement/placement.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/support/scenes/incised_ball.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

// A long ball in place of the bar, whose faces share no points.
Model rigged_ball()
{
    Model model = testing::rigged_model();
    Mesh ball = sphere_mesh(0.5, 48, 24);
    Mesh::MorphTarget thicker;
    for (glm::vec3& p : ball.positions) {
        p.x = 2 + 3 * p.x;
        const float tip = glm::clamp((p.x - 1) / 2, 0.0f, 1.0f);
        ball.influences.push_back({{0, 1, 0, 0}, {1 - tip, tip, 0, 0}});
        thicker.positions.push_back(0.3f * glm::vec3(0, p.y, p.z));
    }
    thicker.normals.resize(ball.positions.size());
    ball.tangents.assign(ball.positions.size(), {1, 0, 0, 1});
    ball.uvs.clear();
    ball.morph_targets = {std::move(thicker)};
    model.meshes = {make_ref(std::move(ball))};
    return model;
}

TEST(IncisingCarried, RidesWithTheObjectAndUnderALattice)
{
    Transform turned;
    turned.translation = {3, 0, 0};
    turned.rotation_deg = {0, 90, 20};
    const Document moved = after(incised_ball(), SetTransform{.object = 1, .transform = turned});
    const Ref<EvaluatedObject> ball = ball_in(moved);
    EXPECT_EQ(*ball->parts.at(0).mesh(), *ball_in(incised_ball())->parts.at(0).mesh());
    EXPECT_EQ(ball->parts.at(0).to_world, turned.matrix());

    Document bent = after(incised_ball(), AddLattice{.objects = {1}});
    bent = after(bent, WarpVolume{.object = 2, .warp = {.twist_deg = 60}});
    const Ref<EvaluatedObject> twisted = ball_in(bent);
    ASSERT_TRUE(twisted->parts.at(0).bent);
    EXPECT_EQ(twisted->parts.at(0).mesh()->corners,
              ball_in(incised_ball())->parts.at(0).mesh()->corners);
    EXPECT_TRUE(is_closed_body(*twisted->parts.at(0).mesh()));
}

TEST(IncisingCarried, OpensOnAStrokeWithoutLayingAgain)
{
    Document document = after(Document{}, AddBox{.shape = {.size = {4, 4, 0.5}}});
    document = after(document, AddSphere{.shape = {.radius = 1, .segments = 48, .rings = 24}});
    document = after(document, Place{2, testing::small_sketch(), {}, {1}});
    Evaluator evaluator = new_evaluator();
    const auto placement = [&](double opening) {
        NamedIncision cut = over_ball({0.3, -0.4, 1}, {0.2, 0.4, 1});
        cut.opening.share = opening;
        const Evaluation all = evaluator(after(document, Incise{2, cut}), 1);
        EXPECT_TRUE(is_closed_body(*all.objects.at(2)->parts.at(0).mesh()));
        return all.objects.at(2)->placement;
    };
    const Ref<Placement> whole = evaluator(document, 1).objects.at(2)->placement;
    ASSERT_TRUE(whole);
    EXPECT_EQ(placement(1), whole);
    EXPECT_EQ(placement(0.4), whole);
}

TEST(IncisingCarried, BendsWithASkinAndAMorph)
{
    const TemporaryFolder folder;
    testing::write_file(folder.file("bar.gltf"), testing::gltf_text(rigged_ball()));
    ImportModel import;
    import.file.path = "bar.gltf";
    import.file.up = UpAxis::z;
    Evaluator evaluator(std::make_shared<const AssetStore>(folder.path().string()));
    Document document = after(Document{}, import);
    const Ref<EvaluatedObject> whole = evaluator(document, 1).objects.at(1);
    const Shape::NodeMesh& bar = whole->shape->meshes.at(0);
    Box box = bounding_box(*bar.rest, bar.to_model);
    NamedIncision cut;
    const glm::dvec3 middle = box.center(), size = box.size();
    for (int i = 0; i <= 8; ++i)
        cut.cut.stroke.push_back({{middle.x + 0.3 * size.x * (i / 8.0 - 0.5),
                                   middle.y + 0.1 * size.y * (i / 8.0 - 0.5), box.hi.z},
                                  {0, 0, 1}});
    cut.cut.depth = 0.3 * size.z;
    cut.cut.width = 0.1 * size.y;
    document = after(document, Incise{1, cut});
    for (const char* clip : {"bend", "swell"}) {
        const Document moving = after(document, PlayClip{{1}, {.clip = clip}});
        const Ref<EvaluatedObject> first = evaluator(moving, 1).objects.at(1),
                                   later = evaluator(moving, 13).objects.at(1);
        EXPECT_THAT(first->incisions.at(0).refusal, ::testing::IsEmpty());
        EXPECT_EQ(first->parts.at(0).mesh()->corners, later->parts.at(0).mesh()->corners);
        EXPECT_NE(first->parts.at(0).mesh()->positions, later->parts.at(0).mesh()->positions);
        EXPECT_GT(first->parts.at(0).mesh()->face_count(), bar.rest->face_count());
        EXPECT_TRUE(is_closed_body(*later->parts.at(0).mesh())) << clip;
    }
}

TEST(IncisingCarried, LetsTilesStayOnWhatIsCut)
{
    Document document =
        after(ball_to_incise(), AddBox{.shape = {.size = {0.2, 0.2, 0.1}, .segments = {1, 1, 1}}});
    TileStroke fill;
    fill.brush = TileBrush::fill;
    fill.size = 0.2;
    fill.samples = {{{{0, -1, 0}, {0, -1, 0}}}};
    document = after(document, PaintTiles{2, 1, fill});
    const auto painted = [&](const Document& of) {
        return new_evaluator()(of, 1).objects.at(2)->painted;
    };
    EXPECT_GT(painted(after(document, Incise{1, across_the_front()})), painted(document) * 3 / 4);
    EXPECT_EQ(effects_of(after(document, Incise{1, across_the_front(0)})), effects_of(document));
}

TEST(IncisingCarried, IsExportedClosedWithItsWalls)
{
    const TemporaryFolder folder;
    const Document document = incised_ball();
    const Model model = model_of(new_evaluator()(document, 1), document);
    for (const char* name : {"ball.glb", "ball.obj"}) {
        write_model(model, folder.file(name));
        const Model read = read_model(folder.file(name));
        ASSERT_EQ(read.meshes.size(), 1u) << name;
        EXPECT_TRUE(is_closed_body(*read.meshes[0])) << name;
        EXPECT_GT(read.meshes[0]->face_count(),
                  ball_in(ball_to_incise())->parts[0].mesh()->face_count());
    }
}

TEST(IncisingCarried, IsCopiedWithTheObject)
{
    const Document document = incised_ball();
    const Document twice = after(document, copied(document, {1}, ""));
    EXPECT_EQ(object(twice, 2).incising, object(document, 1).incising);
    const Command command = Incise{1, across_the_front(0.3)};
    EXPECT_EQ(command_from_json_line(to_json_line(command)), command);
}

} // namespace
} // namespace trivar::testing
