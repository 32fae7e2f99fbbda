// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/incise.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/lattice.h"
#include "editor/tools/split/split.h"
#include "editor/tools/split/split_handles.h"
#include "tests/editor/laid.h"
#include "tests/editor/tools/incise/incise_rig.h"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

// A drawn cut goes where it is seen, whatever was done with the object before.

namespace trivar {
namespace {

using testing::Rig;

struct SeenCutRig : Rig {
    SeenCutRig() : Rig({900, 640}) {}
    Id id = 1;
    const EvaluatedObject& shown() const { return *editor.session.evaluated().objects.at(id); }
    const Object& own() const { return object(editor.session.committed(), id); }

    void take_tool(SplitAt at)
    {
        editor.session.selected = id;
        if (editor.active_tool().name() != "Split") key({'K'});
        wait();
        dynamic_cast<SplitTool&>(editor.active_tool()).set_at(editor.session, at);
        wait();
    }
    void look(const glm::dvec3& from)
    {
        editor.session.view.camera.target = shown().bounds->center();
        editor.session.view.camera.eye = shown().bounds->center() + from;
        wait();
    }
    void drag(const std::vector<glm::vec2>& path)
    {
        move(path.front());
        wait();
        draw(path);
        wait();
    }
    // Makes the last cut stand open that far.
    void open_last(double gap)
    {
        Cutting cutting = *own().cutting;
        cutting.cuts.back().gap = gap;
        ASSERT_TRUE(editor.session.run(CutThrough{{id}, cutting}));
        wait();
    }
    std::vector<std::vector<glm::dvec3>> parts() const // places of vertices, in the world
    {
        std::vector<std::vector<glm::dvec3>> out;
        for (const Part& part : shown().parts) {
            out.emplace_back();
            for (const glm::vec3& p : part.mesh()->positions)
                out.back().emplace_back(part.to_world * glm::dvec4(glm::dvec3(p), 1));
        }
        return out;
    }
    // How far a point of the world is seen to the left of a line in the window, in pixels.
    double beside(const glm::dvec3& p, const glm::vec2& a, const glm::vec2& b) const
    {
        const glm::dvec2 way = glm::normalize(glm::dvec2(b - a));
        const glm::dvec2 to = glm::dvec2(seen_at(p)) - glm::dvec2(a);
        return way.x * to.y - way.y * to.x;
    }
    // Draws a line amid the object at a random angle, and looks for the cut under it.
    void cut_at_random(std::mt19937& random)
    {
        std::uniform_real_distribution<float> uniform(-1, 1);
        const float angle = std::numbers::pi_v<float> * uniform(random);
        const glm::vec2 way(std::cos(angle), std::sin(angle)),
            middle = seen_at(shown().bounds->center()) +
                     12.0f * glm::vec2(uniform(random), uniform(random));
        const glm::vec2 a = glm::round(middle - 180.0f * way),
                        b = glm::round(middle + 180.0f * way);
        const auto before = parts();
        const std::size_t cuts = own().cutting ? own().cutting->cuts.size() : 0;
        drag({a, b});
        ASSERT_TRUE(own().cutting);
        ASSERT_EQ(own().cutting->cuts.size(), cuts + 1);
        open_last(0);
        std::size_t on_line = 0;
        for (const auto& part : parts()) {
            double least = 1e300, most = -1e300;
            for (const glm::dvec3& p : part) {
                const double off = beside(p, a, b);
                least = std::min(least, off);
                most = std::max(most, off);
                const bool known = std::ranges::any_of(before, [&](const auto& old) {
                    return std::ranges::any_of(
                        old, [&](const glm::dvec3& q) { return glm::distance(p, q) < 1e-5; });
                });
                if (known) continue;
                ++on_line;
                EXPECT_LT(std::abs(off), 1);
            }
            EXPECT_TRUE(least > -1 || most < 1); // no piece reaches over the line
        }
        EXPECT_GT(on_line, 5u);
        open_last(0.2);
        for (const auto& part : parts()) {
            const double off = beside(part.front(), a, b);
            for (const glm::dvec3& p : part)
                EXPECT_GT(beside(p, a, b) * off, 0); // nothing is there
        }
    }
    // The handles of the last cut stand on the line, and those of its gap on the faces beside it.
    void expect_handles_near(const glm::vec2& a, const glm::vec2& b) const
    {
        const auto number = static_cast<int>(own().cutting->cuts.size()) - 1;
        const std::vector<Handle> all = cut_handles(editor.session, 1);
        const auto level = std::ranges::find(all, HandleKey{"level", {number}}, &Handle::key);
        ASSERT_NE(level, all.end());
        EXPECT_LT(std::abs(beside(level->p_world, a, b)), 2);
    }
};

glm::dvec3 random_way(std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    return glm::normalize(glm::dvec3(uniform(random), uniform(random), 0.6 * uniform(random)));
}

void add_ball(Rig& rig, const Transform& transform = {})
{
    ASSERT_TRUE(rig.editor.session.run(
        AddSphere{.shape = {.radius = 1, .segments = 24, .rings = 12}, .transform = transform}));
    rig.wait();
}

TEST(SeenCuts, GoUnderTheLineThroughWhatIsCutAlready)
{
    std::mt19937 random(1);
    for (int scene = 0; scene < 3; ++scene) {
        SeenCutRig rig;
        Transform transform;
        transform.translation = {3, -2, 1};
        transform.rotation_deg = {20, -40, 10.0 * scene};
        transform.scale = {1, 1 + 0.5 * scene, 1 - 0.2 * scene};
        add_ball(rig, transform);
        rig.take_tool(SplitAt::plane);
        for (int k = 0; k < 4; ++k) {
            rig.look(7.0 * random_way(random));
            rig.cut_at_random(random);
            if (::testing::Test::HasFatalFailure()) return;
            rig.open_last(0.5);
        }
    }
}

TEST(SeenCuts, GoUnderTheLineThroughWhatAnObstacleParts)
{
    std::mt19937 random(2);
    SeenCutRig rig;
    add_ball(rig);
    ASSERT_TRUE(rig.editor.session.run(AddCylinder{.shape = {.radius = 0.2, .height = 3}}));
    ASSERT_TRUE(rig.editor.session.run(
        Split{{1}, {.obstacles = {{.object = 2, .clearance = 0.05}}, .opening = {1, 0, 0}}}));
    ASSERT_TRUE(rig.editor.session.run(Hide{{2}}));
    rig.take_tool(SplitAt::plane);
    for (int k = 0; k < 3; ++k) {
        rig.look(7.0 * random_way(random));
        rig.cut_at_random(random);
        rig.open_last(0.4);
    }
    EXPECT_TRUE(rig.own().cutting->cuts.back().parted);
}

TEST(SeenCuts, GoUnderTheLineThroughWhatALatticeBends)
{
    std::mt19937 random(3);
    SeenCutRig rig;
    add_ball(rig);
    ASSERT_TRUE(rig.editor.session.run(AddLattice{.objects = {1}}));
    ASSERT_TRUE(rig.editor.session.run(MovePoints{
        .object = 2, .shift = {.points = {{1, 1, 3}, {2, 2, 3}, {2, 1, 3}}, .by = {0.4, 0, 0.7}}}));
    rig.wait();
    rig.take_tool(SplitAt::plane);
    for (int k = 0; k < 3; ++k) {
        rig.look(7.0 * random_way(random));
        rig.cut_at_random(random);
        rig.open_last(0.3);
    }
}

TEST(SeenCuts, GoUnderTheLineThroughWhatLiesOnAStroke)
{
    std::mt19937 random(4);
    SeenCutRig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    rig.id = 2;
    ASSERT_TRUE(rig.shown().placement);
    rig.take_tool(SplitAt::plane);
    for (int k = 0; k < 2; ++k) {
        rig.look(6.0 * (random_way(random) + glm::dvec3(0, 0, 1)));
        rig.cut_at_random(random);
        rig.open_last(0.1);
    }
}

TEST(SeenCuts, GoUnderTheLineThroughAnIncision)
{
    std::mt19937 random(5);
    SeenCutRig rig;
    add_ball(rig);
    rig.editor.session.view.camera.eye = {0, -5, 0.5};
    rig.editor.session.view.camera.target = {0, 0, 0};
    rig.editor.session.selected = 1;
    rig.key({'C'});
    rig.wait();
    const glm::vec2 c = rig.layout().view.center();
    rig.drag({c + glm::vec2(-60, 10), c + glm::vec2(0, -20), c + glm::vec2(60, 10)});
    ASSERT_TRUE(rig.own().incising);
    rig.take_tool(SplitAt::plane);
    for (int k = 0; k < 2; ++k) {
        rig.look({0.4 * k, -6, 1});
        rig.cut_at_random(random);
        rig.open_last(0.3);
    }
}

TEST(SeenCuts, HaveHandlesWhereTheBodyIsShown)
{
    SeenCutRig rig;
    add_ball(rig);
    rig.take_tool(SplitAt::plane);
    rig.look({0, -7, 0});
    const glm::vec2 c = rig.layout().view.center();
    rig.drag({c + glm::vec2(-200, 0), c + glm::vec2(200, 0)});
    rig.open_last(0.8);
    // Through the upper half, where it is seen
    const glm::vec2 a = c + glm::vec2(-200, -75), b = c + glm::vec2(200, -75);
    rig.drag({a, b});
    rig.open_last(0.2);
    ASSERT_EQ(rig.shown().parts.size(), 3u);
    const Cutting& cutting = *rig.own().cutting;
    const std::vector<Handle> handles = cut_handles(rig.editor.session, 1);
    EXPECT_EQ(handles.size(), 6u);
    for (const Handle& point : handles) {
        if (point.key == HandleKey{"level", {1}}) {
            EXPECT_LT(std::abs(rig.beside(point.p_world, a, b)), 1);
        }
        // Gap handles stand where a part ends along the way of its gap
        if (point.key.kind == "gap") {
            const glm::dvec3 normal =
                glm::normalize(cutting.cuts[static_cast<std::size_t>(point.key.numbers[0])].normal);
            const auto along = [&](const glm::dvec3& p) { return glm::dot(p, normal); };
            double nearest = 1e300;
            for (const auto& part : rig.parts()) {
                const auto [lo, hi] = std::ranges::minmax(part, {}, along);
                for (const glm::dvec3& end : {lo, hi})
                    nearest = std::min(nearest, std::abs(along(point.p_world) - along(end)));
            }
            EXPECT_LT(nearest, 1e-4);
        }
    }
}

TEST(SeenCuts, StayInTheMaterialWhenEarlierGapsChange)
{
    SeenCutRig rig;
    add_ball(rig);
    rig.take_tool(SplitAt::plane);
    rig.look({0, -7, 0});
    const glm::vec2 c = rig.layout().view.center();
    rig.drag({c + glm::vec2(-200, 0), c + glm::vec2(200, 0)});
    rig.open_last(0.8);
    rig.drag({c + glm::vec2(-200, -75), c + glm::vec2(200, -75)});
    const auto sizes = [&] {
        std::vector<double> out;
        for (const Part& part : rig.shown().parts) out.push_back(part.bounds.size().z);
        std::ranges::sort(out);
        return out;
    };
    const std::vector<double> before = sizes();
    Cutting cutting = *rig.own().cutting;
    cutting.cuts[0].gap = 0.1;
    ASSERT_TRUE(rig.editor.session.run(CutThrough{{1}, cutting}));
    rig.wait();
    EXPECT_EQ(sizes(), before);
    ASSERT_TRUE(rig.editor.session.run(RemoveCut{1, 1}));
    EXPECT_TRUE(rig.own().cutting->cuts.at(0).opened.empty());
}

} // namespace
} // namespace trivar
