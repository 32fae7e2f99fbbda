// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/text.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/tiles/tiles.h"
#include "core/scene_lines/line_sheet.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/voxels/volume_writers.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

// A look along Y at one metre each of the objects that stand before and behind each other.
Camera from_the_front()
{
    Camera out;
    out.eye = {0.3, -8, 0.5};
    out.target = {0, 0, 0};
    out.perspective = false;
    out.height_world = 3;
    out.size_px = {600, 600};
    return out;
}

// Lengths tell how much is drawn of an object, in pixels of its lines.
struct Lengths {
    double seen = 0, hidden = 0;
};

class LinesOfScenes : public ::testing::Test {
protected:
    void add(const Command& command) { document_ = after(document_, command); }
    void add_box(const std::string& name, const glm::dvec3& size, const glm::dvec3& at)
    {
        add(AddBox{.name = name, .shape = {size, glm::ivec3(1)}, .transform = {.translation = at}});
    }
    // Its hidden lines are drawn, too.
    void draw_in_lines(Id id, bool intersections = false)
    {
        add(SetLineDrawing{
            {id},
            {.intersections = intersections, .ink = {.taper = 0, .hidden = HiddenLines::dashed}}});
    }
    // The left half of what stands behind it is covered.
    void add_screen() { add_box("Screen", {1, 0.1, 2}, {-0.5, -1, 0}); }
    void add_ball_of_data(bool surface)
    {
        VoxelGrid grid;
        grid.size = glm::ivec3(24);
        std::vector<std::uint8_t> samples;
        for (int k = 0; k < 24; ++k)
            for (int j = 0; j < 24; ++j)
                for (int i = 0; i < 24; ++i)
                    samples.push_back(static_cast<std::uint8_t>(
                        std::max(0.0, 100 - 10 * glm::length(glm::dvec3(i, j, k) - 11.5))));
        grid.samples = std::move(samples);
        grid.to_metres = glm::dmat4(glm::dmat3(0.1));
        grid.to_metres[3] = glm::dvec4(glm::dvec3(-1.15), 1);
        write_file(folder_.file("ball.nrrd"), write_nrrd(grid));
        VoxelShape shape{.path = "ball.nrrd"};
        shape.levels = {{.value = 20, .surface = surface, .ink = {.hidden = HiddenLines::dashed}}};
        add(AddVoxels{.shape = shape});
    }
    LineScene scene()
    {
        Evaluator evaluate(std::make_shared<const AssetStore>(folder_.path()));
        return line_scene(evaluate(document_), document_, from_the_front());
    }
    bool simple() { return scene().is_simple(); }
    SceneLines lines(const LineOptions& options = {}) { return LineDrawer()(scene(), options); }
    static Lengths lengths_of(const SceneLines& all, Id id, const std::string& kind = {})
    {
        Lengths out;
        for (const Ref<ObjectLines>& object : all.objects)
            for (const ObjectLines::Layer& layer : object->layers)
                for (const InkedLine& line : layer.drawing.lines)
                    for (std::size_t i = 1; i < line.points.size(); ++i)
                        if (object->object == id && (kind.empty() || layer.drawing.name == kind))
                            (line.hidden ? out.hidden : out.seen) +=
                                double{glm::distance(line.points[i].at, line.points[i - 1].at)};
        return out;
    }
    Lengths lengths(Id id, const std::string& kind = {}) { return lengths_of(lines(), id, kind); }

    TemporaryFolder folder_;
    Document document_;
};

TEST_F(LinesOfScenes, AreHiddenWhereASurfaceOfAnotherObjectIsBeforeThem)
{
    add_box("Behind", {1, 1, 1}, {0, 1, 0});
    draw_in_lines(1);
    add_screen();
    const Camera camera = from_the_front();
    const glm::dvec3 to_eye = glm::normalize(camera.eye - camera.target);
    // Whether the line of sight goes through the screen or through the box itself.
    const auto is_covered = [&](const glm::dvec3& p) {
        const double way = (-1 - p.y) / to_eye.y;
        const glm::dvec3 there = p + way * to_eye;
        return std::abs(there.x + 0.5) < 0.5 && std::abs(there.z) < 1;
    };
    const auto is_behind_itself = [&](const glm::dvec3& p) {
        return p.y > 1.49 && (p.x < 0.49 || p.z < 0.49) && !(p.x > 0.49) && !(p.z > 0.49);
    };
    std::size_t right = 0, wrong = 0;
    for (const Ref<ObjectLines>& object : lines().objects)
        for (const ObjectLines::Layer& layer : object->layers)
            for (const InkedLine& line : layer.drawing.lines)
                for (const InkedLine::Point& point : line.points) {
                    const glm::dvec3 p(layer.to_world * glm::dvec4(glm::dvec3(point.p), 1));
                    if (is_behind_itself(p)) continue;
                    ++(line.hidden == is_covered(p) ? right : wrong);
                }
    EXPECT_GT(right, 300u);
    EXPECT_LE(wrong, right / 50) << "but for a point at each end";
}

TEST_F(LinesOfScenes, AreHiddenByTextByTilesAndByLevelsOfVolumeData)
{
    add_box("Behind", {1, 1, 1}, {0, 2, 0});
    draw_in_lines(1);
    const Document alone = document_;
    const double whole = lengths(1).seen;
    const auto seen_behind = [&] {
        const double out = lengths(1).seen / whole;
        document_ = alone;
        return out;
    };
    const Transform upright{.translation = {-0.5, -1, -0.3}, .rotation_deg = {90, 0, 0}};
    add(AddText{.shape = {.text = "HOW", .size = 0.7}, .transform = upright});
    EXPECT_GT(seen_behind(), 0.2);
    add(AddText{.shape = {.text = "HOW", .size = 0.7}, .transform = upright});
    EXPECT_LT(seen_behind(), 0.95);
    add(AddPlane{.shape = {{1, 2}, {1, 1}},
                 .transform = {.translation = {-0.5, -1, 0}, .rotation_deg = {90, 0, 0}}});
    add(AddBox{.shape = {glm::dvec3(1), glm::ivec3(1)}, .transform = {}});
    add(CoverWithTiles{3, 2, {.pattern = TilePattern::grid, .per_face = 4}});
    add(Hide{{2}});
    EXPECT_NEAR(seen_behind(), 0.6, 0.1) << "which the screen covers from the right";
    add_ball_of_data(true);
    EXPECT_LT(seen_behind(), 0.5);
    add_ball_of_data(false);
    EXPECT_EQ(seen_behind(), 1) << "lines alone hide nothing";
}

TEST_F(LinesOfScenes, OfVolumeDataAreHiddenByMeshes)
{
    add_ball_of_data(false);
    const Lengths alone = lengths(1);
    EXPECT_EQ(alone.hidden, 0);
    add_box("Screen", {2, 0.1, 2}, {-1, -2, 0});
    const Lengths covered = lengths(1);
    EXPECT_NEAR(covered.seen / alone.seen, 0.5, 0.1);
    EXPECT_NEAR(covered.seen + covered.hidden, alone.seen, 0.02 * alone.seen);
}

TEST_F(LinesOfScenes, AreNotHiddenByItsOwnLevelButByOthersThatAreShown)
{
    add_ball_of_data(true);
    EXPECT_EQ(lengths(1).hidden, 0);
    VoxelShape shape = std::get<VoxelShape>(document_.objects.at(1)->source);
    shape.levels.push_back({.value = 80, .surface = false, .ink = {.hidden = HiddenLines::dashed}});
    add(SetVoxels{1, shape});
    EXPECT_EQ(lengths(1, "Level 80").seen, 0);
    const auto reach = [&](LineEffort effort) {
        return lines({.effort = effort}).objects.at(0)->layers.at(0).own_reach;
    };
    EXPECT_FALSE(simple());
    EXPECT_TRUE(std::isinf(reach(LineEffort::full)));
    EXPECT_FALSE(std::isinf(reach(LineEffort::quick))) << "the picture's depth hides them";
    shape.levels[0].surface = false;
    add(SetVoxels{1, shape});
    EXPECT_EQ(lengths(1, "Level 80").hidden, 0);
}

TEST_F(LinesOfScenes, AreNotHiddenByWhatIsNotShownOrLetsLightThrough)
{
    add_box("Behind", {1, 1, 1}, {0, 2, 0});
    draw_in_lines(1);
    const double whole = lengths(1).seen;
    add_screen();
    EXPECT_LT(lengths(1).seen, 0.7 * whole);
    add(SetMaterial{{2}, {.base_color = {0.5f, 0.5f, 0.5f, 0.3f}}});
    EXPECT_EQ(lengths(1).seen, whole) << "glass";
    add(SetMaterial{{2}, {}});
    add(SetLineDrawing{{2}, {.surface = false}});
    EXPECT_EQ(lengths(1).seen, whole) << "lines alone";
    add(SetLineDrawing{{2}, {}});
    EXPECT_LT(lengths(1).seen, 0.7 * whole);
    add(Hide{{2}});
    EXPECT_EQ(lengths(1).seen, whole);
}

TEST_F(LinesOfScenes, OfABoxOnATableKeepItsLowerEdges)
{
    add_box("Box", {1, 1, 1}, {0, 0, 0});
    draw_in_lines(1);
    const double alone = lengths(1).seen;
    for (const double sunk : {0.0, 1e-4}) {
        add(AddPlane{.shape = {{3, 3}, {2, 2}}, .transform = {.translation = {0, 0, -0.5 + sunk}}});
        EXPECT_NEAR(lengths(1).seen, alone, 0.01 * alone) << sunk;
    }
}

TEST_F(LinesOfScenes, AreAsAloneWhereNothingIsBeforeThem)
{
    const auto points = [&] {
        std::vector<glm::vec2> out;
        const SceneLines all = lines();
        for (const ObjectLines::Layer& layer : all.objects.at(0)->layers)
            for (const InkedLine& line : layer.drawing.lines)
                for (const InkedLine::Point& p : line.points) out.push_back(p.at);
        return out;
    };
    add(AddSphere{.shape = {0.5, 24, 12}, .transform = {}});
    draw_in_lines(1);
    const std::vector<glm::vec2> alone = points();
    add_box("Wall", {4, 0.1, 4}, {0, 3, 0});
    EXPECT_EQ(points(), alone);
    const ThreadLimit one(1);
    EXPECT_EQ(points(), alone) << "on one thread";
}

TEST_F(LinesOfScenes, ShowWhereBodiesMeetIfThatIsWanted)
{
    add_box("A", {1, 1, 1}, {0, 0, 0});
    add_box("B", {1, 1, 1}, {0.4, 0.3, 0.35});
    draw_in_lines(1);
    draw_in_lines(2);
    EXPECT_EQ(lengths(1, "intersections").seen, 0);
    draw_in_lines(1, true);
    const Lengths once = lengths(1, "intersections");
    EXPECT_GT(once.seen, 100);
    EXPECT_GT(once.hidden, 100);
    draw_in_lines(2, true);
    EXPECT_EQ(lengths(1, "intersections").seen, once.seen);
    EXPECT_EQ(lengths(2, "intersections").seen, 0) << "they are not drawn twice";
    EXPECT_EQ(lengths_of(lines({.effort = LineEffort::quick}), 1, "intersections").seen, 0);
}

TEST_F(LinesOfScenes, OfTilesAreTheirEdges)
{
    add(AddPlane{.shape = {{1, 1}, {1, 1}},
                 .transform = {.translation = {}, .rotation_deg = {90, 0, 0}}});
    add(AddBox{.shape = {glm::dvec3(1), glm::ivec3(1)}, .transform = {}});
    add(CoverWithTiles{2, 1, {.pattern = TilePattern::grid, .per_face = 2}});
    draw_in_lines(2);
    const SceneLines all = lines();
    // Four fronts of half a metre, of 200 pixels a metre.
    EXPECT_GT(lengths_of(all, 2).seen, 4 * 4 * 0.5 * 200 * 0.95);
    EXPECT_TRUE(all.notices.empty());
    EXPECT_TRUE(lines({.effort = LineEffort::quick}).objects.at(0)->layers.empty());
}

TEST_F(LinesOfScenes, OfTooManyTilesAreThoseThatAreSeenLargest)
{
    add(AddPlane{.shape = {{1, 1}, {1, 1}}, .transform = {}});
    add(AddBox{.shape = {glm::dvec3(1), glm::ivec3(1)}, .transform = {}});
    add(CoverWithTiles{2, 1, {.pattern = TilePattern::grid, .per_face = 8}});
    Evaluator evaluate(std::make_shared<const AssetStore>("."));
    const Evaluation evaluated = evaluate(document_);
    const Part& part = evaluated.objects.at(2)->parts.at(0);
    ASSERT_TRUE(part.drawn_from_tiles());
    const Camera camera = from_the_front();
    const SeenTiles whole = seen_tiles(*part.tiles, part.to_world, camera);
    EXPECT_EQ(whole.drawn, 64u);
    EXPECT_EQ(whole.mesh, part.mesh());
    EXPECT_NEAR(whole.tile_size, std::sqrt(3.0) / 8, 0.05);
    const SeenTiles some = seen_tiles(*part.tiles, part.to_world, camera, 20 * 12);
    EXPECT_EQ(some.all, 64u);
    EXPECT_GE(some.drawn, 15u);
    EXPECT_LE(some.drawn, 20u);
    EXPECT_EQ(some.mesh->face_count(), some.drawn * 6);
    Camera far = camera;
    far.height_world = 300;
    EXPECT_EQ(seen_tiles(*part.tiles, part.to_world, far, 10).drawn, 0u) << "too small";
    Camera beside = camera;
    beside.target.x += 10;
    beside.eye.x += 10;
    EXPECT_EQ(seen_tiles(*part.tiles, part.to_world, beside, 10).drawn, 0u);
}

TEST_F(LinesOfScenes, AreLayersOfASheetOnBlackOrWhite)
{
    add_box("A", {1, 1, 1}, {0, 0, 0});
    add_box("A", {1, 1, 1}, {2, 0, 0});
    draw_in_lines(1);
    draw_in_lines(2);
    Evaluator evaluate(std::make_shared<const AssetStore>("."));
    const LineSheet sheet = line_sheet(evaluate(document_), document_, from_the_front());
    EXPECT_EQ(sheet.sheet.paper, glm::vec3(1));
    std::vector<std::string> names;
    for (const DrawingLayer& layer : sheet.sheet.layers) names.push_back(layer.name);
    EXPECT_THAT(names, ::testing::Contains("A: silhouettes"));
    EXPECT_THAT(names, ::testing::Contains("A.2: silhouettes"));
}

TEST_F(LinesOfScenes, EndWhereTheyAreCancelled)
{
    add_box("A", {1, 1, 1}, {0, 0, 0});
    draw_in_lines(1);
    EXPECT_THROW(lines({.progress = [](double, std::string_view) { throw Cancelled(); }}),
                 Cancelled);
}

TEST_F(LinesOfScenes, AreSimpleWhereAWindowCanDrawThemAtOnce)
{
    add_box("A", {1, 1, 1}, {0, 0, 0});
    EXPECT_TRUE(simple()) << "no lines";
    draw_in_lines(1);
    EXPECT_TRUE(simple());
    draw_in_lines(1, true);
    EXPECT_FALSE(simple());
    draw_in_lines(1);
    add_screen();
    EXPECT_FALSE(simple());
    add(Hide{{2}});
    EXPECT_TRUE(simple());
}

} // namespace
} // namespace trivar::testing
