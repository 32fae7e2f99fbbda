// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/tiles.h"

#include "core/base/rejected.h"
#include "tests/support/scenes/commands.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::small_document;

std::string said(const Document& before, const Command& command)
{
    return step_title(command, before, after(before, command)).text();
}
std::string said(const Command& command)
{
    return said(small_document(), command);
}

TEST(StepTitle, IsWhatAPersonWouldSayOfEveryCommand)
{
    const std::vector<std::string> expected{
        "Import snail.obj",
        "File of snail shell.obj",
        "Files of 3 objects",
        "Add Plane 4 × 4 m",
        "Add Box 1 × 1 × 1 m",
        "Add Sphere radius 0.5 m",
        "Add Cylinder radius 0.5 m",
        "Add Torus radius 0.5 m",
        "Add Moebius band radius 0.5 m",
        "Add Teapot 1 m",
        "Add Text “Text”",
        "Letters of Text “Ab”",
        "Move Ball 0.348 m",
        "Rotate and scale Ball and Table",
        "Give Table and Ball a plain material",
        "Give Table its own material back",
        "Rename Table to Desk",
        "Hide Table and Ball",
        "Show Ball",
        "Lock Table and Ball",
        "Unlock Ball",
        "Delete Ball",
        "Duplicate Pot and Furniture 1 m",
        "Group Ball and Pot as Both",
        "Ungroup Furniture",
        "Reorder Pot and Table",
        "Place Ball on Table",
        "Lay Pot round Ball",
        "Offset of Pot 1",
        "Take Pot off its stroke",
        "Let Pot travel 0.5 m/s",
        "Let snail play walk",
        "Animate 2 values of Pot",
        "Refine Pot 0.01 m",
        "Give Pot its own triangles back",
        "Press Pot Gaussian 0.1 m",
        "Move a control point of Pot 0.0224 m",
        "Refine the volume of Pot 2 knots",
        "Coarsen the volume of Pot to 8 points along the stroke",
        "Repair folds in Pot",
        "Let Pot fold in places",
        "Take back the shaping of Pot",
        "Paste 3 objects",
        "Keep side",
        "Forget front",
        "Look clay",
        "Frames 3 values",
        "Put a lattice round Ball 4 × 4 × 4",
        "Density of Lattice 4 × 4 × 6",
        "Turn Lattice into tetrahedra",
        "Put tetrahedra round Heights 2 × 2 × 2",
        "Boxes of Tetrahedra 3 × 2 × 2",
        "Pull by 0.1 m in Tetrahedra",
        "Remove edit 1 of Tetrahedra",
        "Add Simplex sheet 2 × 2 m",
        "Degree of Simplex sheet 3",
        "Twist of Lattice 30°",
        "Delete Lattice and keep its shape",
        "Simplify Table to 25 %",
        "Give Table all triangles back",
        "Twist and taper of Lattice",
        "Attach Pot to Table",
        "Let Ball go with Table",
        "Make the shape of Pot final 0.002 m",
        "Scatter Cylinder on Ball",
        "Change stroke 1 of Cylinder",
        "Remove stroke 1 of Cylinder",
        "Tiles of Cylinder",
        "Make Cylinder a single object again",
        "Mix the tiles of Cylinder with Ball",
        "Let the tiles of Cylinder become Ball",
        "Cover Ball with Cylinder",
        "Mask the scale of Cylinder",
        "Remove all masks of Cylinder",
        "Add Heights hills.png",
        "Picture of Heights dunes.png",
        "Displace Ball by hills.png",
        "Add Volume data head.nrrd",
        "Remove level of Volume data",
        "Unwrap Table",
        "Give Table its own UVs back",
        "Shade Table by angle 20°",
        "Split Table at Ball",
        "Close Table",
        "Cut through Table",
        "Remove cut 1 of snail",
        "Make Table whole",
        "Incise Ball",
        "Width and opening of incision 1 of snail",
        "Layers in the incisions of snail",
        "Remove incision 1 of snail",
        "Remove all incisions of snail",
        "Swap incision 1 and incision 2 of snail",
        "Peel a flap of snail 0.0425 m",
        "Lay flap 1 of snail back",
        "Draw Table in lines",
        "Draw Table without lines",
        "Bind Cylinder to Table",
    };
    const std::vector<Command> commands = testing::fitting_commands();
    ASSERT_EQ(commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(said(testing::fitting_document(), commands[i]), expected[i]);
}

TEST(StepTitle, NamesWhatChangedOfATravel)
{
    const Travel before{.speed = 0.5};
    const Document document = after(small_document(), SetTravel{{3}, before});
    const auto edited = [&](auto change) {
        Travel travel = before;
        change(travel);
        return said(document, SetTravel{{3}, travel});
    };
    EXPECT_EQ(edited([](Travel& t) { t.speed = 0; }), "Let Pot rest");
    EXPECT_EQ(edited([](Travel& t) { t.speed = 0.75; }), "Speed of Pot 0.75 m/s");
    EXPECT_EQ(edited([](Travel& t) { t.ends = Ends::back_and_forth; }),
              "Ends of Pot back and forth");
    EXPECT_EQ(edited([](Travel& t) { t.start_frame = 24; }), "Start of Pot at frame 24");
    EXPECT_EQ(edited([](Travel& t) { t.ease_in = t.ease_out = 0.5; }),
              "Ease in and ease out of Pot");
    EXPECT_EQ(said(document, SetTime{{1, 120, 24}}), "Last frame 120");
}

TEST(StepTitle, NamesKeysInTheWordsOfThePanels)
{
    const auto keys = [](std::vector<Track> tracks) { return Animate{{{2, std::move(tracks)}}}; };
    const std::string up = "transform.translation.z";
    EXPECT_EQ(said(keys({{up, {{24, 0.5}}}})), "Animate position Z of Ball 0.5 m in frame 24");
    EXPECT_EQ(said(keys({{up, {{1, 0}, {24, 0.5}}}})), "Animate position Z of Ball");
    EXPECT_EQ(said(keys({{"transform.translation.x", {{1, 0}}}, {up, {{1, 0}}}})),
              "Animate position of Ball");
    EXPECT_EQ(said(keys({{up, {}}})), "Clear keys of position Z of Ball");
    EXPECT_EQ(said(Animate{{{0, {{"render.look", {{9, 1}}}}}}}),
              "Animate look of the scene Clay in frame 9");
    const Document document = after(small_document(), keys({{up, {{1, 0}, {24, 0.5}}}}));
    EXPECT_EQ(said(document, keys({{up, {{1, 0}, {24, 0.75}}}})),
              "Animate position Z of Ball 0.75 m in frame 24");
}

TEST(StepTitle, NamesTheOneNumberOfAPlacementThatChanged)
{
    const auto edited = [](auto change) {
        EditPlacement edit{.object = 3, .parameters = {}, .sketch = {}, .onto = {}};
        change(edit.parameters);
        return said(edit);
    };
    using P = PlacementParameters;
    EXPECT_EQ(edited([](P& p) { p.width = 0.24; }), "Width of Pot 0.24 m");
    EXPECT_EQ(edited([](P& p) { p.springs = false; }), "Gaps of Pot not bridged");
    EXPECT_EQ(edited([](P& p) { p.grid = {40, 9, 4}; }), "Density of Pot 40 × 9 × 4");
    EXPECT_EQ(edited([](P& p) { p.misses = Misses::ground; }), "Misses of Pot drop to the ground");
    EXPECT_EQ(edited([](P& p) { p.roll_deg = 90; }), "Roll of Pot 90°");
    EXPECT_EQ(edited([](P& p) { p.along = LengthAxis::z; }), "Axis along of Pot z");
    EXPECT_EQ(edited([](P& p) { p.contact_level = 0.25; }), "Contact level of Pot 0.25");
    EXPECT_EQ(edited([](P& p) {
                  p.rise_profile = {{0, 0}, {1, 1}};
              }),
              "Height distribution of Pot 2 points");
    EXPECT_EQ(edited([](P& p) { p.width = p.height = 1; }), "Width and height of Pot");
    EXPECT_EQ(edited([](P& p) { p.width = p.height = p.offset = 1; }), "Placement of Pot 3 values");
    EXPECT_EQ(edited([](P&) {}), "Placement of Pot as before");
}

TEST(StepTitle, TellsAStrokeDrawnAgainAndOneThatWasReshaped)
{
    Sketch other = testing::small_sketch();
    other.samples.back().p_px.y += 9;
    EXPECT_EQ(said(Place{.object = 3, .sketch = other, .parameters = {}, .onto = {1}}),
              "Place Pot again on Table");
    EXPECT_EQ(
        said(Place{.object = 3, .sketch = other, .parameters = {}, .onto = {1}, .copy = true}),
        "Place a copy of Pot on Table");
    PlacementParameters grounded;
    grounded.on_ground = true;
    const auto onto = [&](std::vector<Id> hosts) {
        return said(
            Place{.object = 3, .sketch = other, .parameters = grounded, .onto = std::move(hosts)});
    };
    EXPECT_EQ(onto({1}), "Place Pot again on Table and the ground");
    EXPECT_EQ(onto({1, 2}), "Place Pot again on Table, Ball and the ground");
    EXPECT_EQ(said(EditPlacement{.object = 3, .parameters = {}, .sketch = other, .onto = {}}),
              "Stroke of Pot");
    Sketch moved = testing::small_sketch();
    moved.camera.eye.x += 1;
    moved.camera.target.x += 1;
    EXPECT_EQ(said(EditPlacement{.object = 3, .parameters = {}, .sketch = moved, .onto = {}}),
              "Slide Pot");
    Attachment met{{attached_host(1, glm::dmat4(1), true)}};
    met.samples.assign(moved.samples.size(), {.host = 0, .normal = {0, 0, 1}});
    EXPECT_EQ(said(EditPlacement{3, {}, moved, {}, met}), "Slide Pot 1 m");
    Sketch grown = testing::small_sketch();
    grown.camera.eye += grown.camera.eye - grown.camera.target;
    EXPECT_EQ(said(EditPlacement{.object = 3, .parameters = {}, .sketch = grown, .onto = {}}),
              "Scale Pot on the surface × 2");
    EXPECT_EQ(said(EditPlacement{
                  .object = 3, .parameters = {}, .sketch = {}, .onto = std::vector<Id>{2}}),
              "Lay Pot on Ball");
}

// Samples in a row along X about (1, 2, 0), on a face that looks upward.
Attachment met_in_a_row(std::size_t count, const glm::dmat4& by = glm::dmat4(1))
{
    Attachment out{{attached_host(1, glm::dmat4(1), true)}};
    for (std::size_t i = 0; i < count; ++i) {
        const double along = static_cast<double>(i) / static_cast<double>(count - 1) - 0.5;
        const glm::dvec3 p(by * glm::dvec4(1 + along, 2, 0, 1));
        out.samples.push_back({.host = 0, .drawn = p, .normal = {0, 0, 1}});
    }
    return out;
}

TEST(StepTitle, TellsATurnOnTheSurfaceFromAMoveOverIt)
{
    const Sketch sketch = testing::small_sketch();
    Document before = small_document();
    before = after(before, EditPlacement{3, {}, sketch, {}, met_in_a_row(sketch.samples.size())});
    const auto said_of = [&](const glm::dmat4& by) {
        Sketch now = sketch;
        now.camera = carried(now.camera, by);
        return said(before, EditPlacement{3, {}, now, {}, {}});
    };
    const auto turn_about = [](const glm::dvec3& p, double angle_deg) {
        const glm::dmat4 turn = Transform{.rotation_deg = {0, 0, angle_deg}}.matrix();
        return glm::translate(glm::dmat4(1), p) * turn * glm::translate(glm::dmat4(1), -p);
    };
    for (const double angle : {-120, -1, 5, 90, 179})
        EXPECT_EQ(said_of(turn_about({1, 2, 0}, angle)),
                  fmt::format("Turn Pot on the surface {}°", angle));
    // About a middle that is not quite that of the stroke, and far from it: along a bend.
    EXPECT_EQ(said_of(turn_about({1.2, 2, 0}, 45)), "Turn Pot on the surface 45°");
    EXPECT_EQ(said_of(turn_about({1, -6, 0}, 10)), "Slide Pot 1.4 m");
    // An obstacle changed the stroke's camera: the hits on its hosts tell the turn.
    Sketch seen_anew = sketch;
    seen_anew.camera.perspective = !sketch.camera.perspective;
    for (StrokeSample& each : seen_anew.samples) each.p_px *= 0.5;
    const Attachment turned = met_in_a_row(sketch.samples.size(), turn_about({1, 2, 0}, 30));
    EXPECT_EQ(said(before, EditPlacement{3, {}, seen_anew, {}, turned}),
              "Turn Pot on the surface 30°");
}

TEST(StepTitle, TellsWhatGoesWithWhat)
{
    EXPECT_EQ(said(Attach{.object = 3,
                          .attach = Attachment{{attached_host(1, glm::dmat4(1), true),
                                                attached_host(2, glm::dmat4(1), false)}}}),
              "Attach Pot to Table");
    EXPECT_EQ(said(SetParent{.objects = {2}, .parent = 1}), "Let Ball go with Table");
}

TEST(StepTitle, TellsOfTiles)
{
    const Document before = testing::fitting_document();
    TileStroke stroke = testing::a_tile_stroke();
    EXPECT_EQ(said(before, PaintTiles{8, 2, stroke}), "Scatter Cylinder on Ball");
    stroke.brush = TileBrush::comb;
    EXPECT_EQ(said(before, PaintTiles{8, 2, stroke}), "Comb Cylinder on Ball");
    stroke.brush = TileBrush::color;
    EXPECT_EQ(said(before, PaintTiles{8, 2, stroke}), "Colour Cylinder on Ball");
    stroke.brush = TileBrush::adjust;
    stroke.turn_deg = 20;
    EXPECT_EQ(said(before, PaintTiles{8, 2, stroke}), "Turn tiles of Cylinder on Ball");
    stroke.factor = 0;
    EXPECT_EQ(said(before, PaintTiles{8, 2, stroke}), "Remove tiles of Cylinder on Ball");
    EXPECT_EQ(said(before, EditTileStroke{8, 1, stroke}), "Change stroke 1 of Cylinder");
    EXPECT_EQ(said(before, RemoveTileStrokes{8, {1}}), "Remove stroke 1 of Cylinder");
    EXPECT_EQ(said(before, RemoveTileStrokes{8, {}}), "Remove all strokes of Cylinder");
    EXPECT_EQ(said(before, SetTiles{{8}, {.height = 2}}), "Tiles of Cylinder");
    EXPECT_EQ(said(before, ClearTiles{{8}}), "Make Cylinder a single object again");
    const CoverWithTiles cover{8, 2, {.pattern = TilePattern::brick}};
    EXPECT_EQ(said(before, cover), "Cover Ball with Cylinder");
    EXPECT_EQ(said(after(before, cover), cover), "Change the cover of Ball by Cylinder");
    EXPECT_EQ(said(before, CoverWithTiles{8, 2, {}}), "Uncover Ball from Cylinder");
    const MaskTiles mask{8, 0, {.drives = MaskDrives::height}};
    EXPECT_EQ(said(before, mask), "Mask the height of Cylinder");
    EXPECT_EQ(said(after(before, mask), MaskTiles{8, 1, {}}), "Change mask 1 of Cylinder density");
    EXPECT_EQ(said(after(before, mask), RemoveTileMasks{8, {1}}), "Remove mask 1 of Cylinder");
    EXPECT_EQ(said(before, RemoveTileMasks{8, {}}), "Remove all masks of Cylinder");
    EXPECT_EQ(said(before, SetHeights{9, {.image = "a/dunes.png"}}),
              "Picture of Heights dunes.png");
    EXPECT_EQ(said(before, Displace{.base = 2, .shape = {.image = "hills.png"}}),
              "Displace Ball by hills.png");
}

TEST(StepTitle, TellsMovingFromTurningAndScaling)
{
    const auto changed = [](const Transform& t) { return said(SetTransform{2, t}); };
    EXPECT_EQ(changed({.translation = {0, 0, 1.2}}), "Move Ball 1.2 m");
    EXPECT_EQ(changed({.rotation_deg = {0, 0, -30}}), "Rotate Ball -30° about Z");
    EXPECT_EQ(changed({.rotation_deg = {90, 0, 90}}), "Rotate Ball 120°");
    EXPECT_EQ(changed({.scale = {1.5, 1.5, 1.5}}), "Scale Ball × 1.5");
    EXPECT_EQ(changed({.scale = {1, 2, 1}}), "Scale Ball × 2 along Y");
    EXPECT_EQ(changed({.translation = {3, 4, 0}, .rotation_deg = {0, 0, 5}}),
              "Move and rotate Ball 5 m");
}

TEST(StepTitle, TellsWhatHappenedToSeveralObjectsAtOnce)
{
    const auto arranged = [](const Transform& one, const Transform& other) {
        return said(Arrange{{1, 2}, {one, other}});
    };
    EXPECT_EQ(arranged({.translation = {0, 0, 2}}, {.translation = {1, 0, 2}}),
              "Move Table and Ball 2 m");
    EXPECT_EQ(arranged({.rotation_deg = {0, 0, 30}},
                       {.translation = {1, 2, 0}, .rotation_deg = {0, 0, 30}}),
              "Rotate Table and Ball 30° about Z");
    EXPECT_EQ(said(Arrange{{2}, {{.translation = {0, 0, 1.2}}}}), "Move Ball 1.2 m");
}

TEST(StepTitle, NamesTheValueOfAMaterialThatChanged)
{
    Surfacing first;
    const Document plain = after(small_document(), SetMaterial{{2}, first});
    Surfacing rough = first, red = first;
    rough.roughness = 0.4f;
    red.base_color = {1, 0, 0, 1};
    EXPECT_EQ(said(plain, SetMaterial{{2}, rough}), "Roughness of Ball 0.4");
    EXPECT_EQ(said(plain, SetMaterial{{2}, red}), "Colour of Ball #FF0000");
}

TEST(StepTitle, OfAnyAcceptedCommandIsNotEmpty)
{
    std::mt19937 random(41);
    Document document = small_document();
    for (int i = 0; i < 4000; ++i) {
        const Command command = testing::random_command(random);
        try {
            EXPECT_FALSE(said(document, command).empty()) << verb(command);
        } catch (const Rejected&) {
        }
    }
}

} // namespace
} // namespace trivar
