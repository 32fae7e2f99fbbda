// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

TEST(Kernel, FallsFromOneToZeroWithinItsBounds)
{
    for (const SplitKernel kernel :
         {SplitKernel::quadratic, SplitKernel::smooth, SplitKernel::gaussian, SplitKernel::hat}) {
        EXPECT_EQ(kernel_at(kernel, 0).value, 1);
        EXPECT_EQ(kernel_at(kernel, 0).first, 0);
        EXPECT_NEAR(kernel_at(kernel, 1).value, 0, 1e-15);
        constexpr double h = 1e-5;
        for (double x = h; x < 1.2; x += 0.001) {
            const KernelValue at = kernel_at(kernel, x);
            EXPECT_LE(at.first, 0);
            EXPECT_LE(-at.first, steepest(kernel));
            EXPECT_NEAR(at.first,
                        (kernel_at(kernel, x + h).value - kernel_at(kernel, x - h).value) / (2 * h),
                        3e-4);
            EXPECT_LE(std::abs(kernel_at(kernel, x + h).first - at.first) / h,
                      most_bent(kernel) * (1 + 1e-6));
        }
    }
}

TEST(Kernel, IsBoundedOverIntervals)
{
    for (const SplitKernel kernel :
         {SplitKernel::quadratic, SplitKernel::smooth, SplitKernel::gaussian, SplitKernel::hat})
        for (double from = 0; from < 1.1; from += 0.0137)
            for (double length = 0.001; length < 1; length *= 2) {
                const KernelBound bound = kernel_bound(kernel, from, from + length);
                constexpr int steps = 50;
                for (int k = 0; k < steps; ++k) {
                    const double x = from + length * k / steps, y = from + length * (k + 1) / steps;
                    const KernelValue a = kernel_at(kernel, x), b = kernel_at(kernel, y);
                    EXPECT_LE(a.value, bound.value);
                    EXPECT_LE(std::abs(a.first), bound.first + 1e-12);
                    EXPECT_LE(std::abs(b.first - a.first), (bound.second + 1e-9) * (y - x) + 1e-14);
                }
            }
}

SplitObstacle obstacle(const std::string& name, Mesh mesh)
{
    SplitObstacle out;
    out.name = name;
    out.bodies = {{std::make_shared<const RayMesh>(make_ref(std::move(mesh))), glm::dmat4(1), 1}};
    out.clearance = 0.004;
    return out;
}

SplitObstacle with_smooth_ends(SplitObstacle obstacle)
{
    obstacle.ends = SplitEnds::smooth;
    obstacle.margin = smooth_margin;
    return obstacle;
}

struct Named {
    std::string name;
    std::vector<SplitObstacle> obstacles;
};

std::vector<Named> scenes()
{
    const auto leaning = [](const glm::dvec3& at, const glm::dvec3& lean) {
        return [=](double s) { return at + lean * (4 * s - 2) + glm::dvec3(0, 0, 4 * s - 2); };
    };
    std::vector<Named> out;
    out.push_back({"upright bar", {obstacle("bar", bar(leaning({0.1, 0, 0}, {}), 0.18))}});
    out.push_back({"leaning bar", {obstacle("bar", bar(leaning({}, {0.84, 0.36, 0}), 0.18))}});
    out.push_back({"bent bar",
                   {obstacle("bar", bar(
                                        [](double s) {
                                            const double z = 4 * s - 2;
                                            return glm::dvec3(0.35 * std::sin(3 * z), 0, z);
                                        },
                                        0.15, 48))}});
    out.push_back({"ball", {obstacle("ball", ball({0.1, 0, 0.05}, 0.3, 48))}});
    const Named smooth{"smooth ends", {with_smooth_ends(out[1].obstacles[0])}};
    const Named smooth_ball{"ball, smooth ends", {with_smooth_ends(out[3].obstacles[0])}};
    Named three{"three leaning bars", {}};
    for (int k = -1; k <= 1; ++k)
        three.obstacles.push_back(
            obstacle("bar " + std::to_string(k + 2),
                     bar(leaning({0.75 * k, 0.2 * k, 0}, {0.3, 0.25, 0}), 0.12)));
    out.push_back(three);
    out.push_back(smooth);
    out.push_back(smooth_ball);
    return out;
}

// Whether a point in the world lies in any obstacle: a ray to the outside leaves more often than it
// enters.
bool inside(const RayScene& scene, const glm::dvec3& p)
{
    const std::optional<Hit> hit = scene.hit({p, glm::normalize(glm::dvec3(0.31, 0.93, 0.2))});
    return hit && hit->back_face;
}

RayScene scene_of(const std::vector<SplitObstacle>& obstacles)
{
    std::vector<RayScene::Entry> entries;
    for (const SplitObstacle& each : obstacles)
        entries.insert(entries.end(), each.bodies.begin(), each.bodies.end());
    return RayScene(entries);
}

TEST(SplitField, MovesNothingIntoAnObstacleAndFoldsNothing)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const Named& named : scenes()) {
        SCOPED_TRACE(named.name);
        const SplitField field = split_field(named.obstacles, {});
        EXPECT_EQ(field.openings.size(), named.obstacles.size());
        const RayScene scene = scene_of(named.obstacles);
        const std::vector<char> on(field.openings.size(), 0);
        for (int k = 0; k < 20000; ++k) {
            const glm::dvec3 p(2.5 * uniform(random), 1.5 * uniform(random), 1.1 * uniform(random));
            std::vector<char> sides;
            for (const Opening& o : field.openings) sides.push_back(o.height(p) >= 0);
            const SplitField::Moved moved = field.moved(p, sides, on);
            EXPECT_GT(moved.gradient.x, 0.01);
            EXPECT_FALSE(inside(scene, {moved.u, p.y, p.z}));
            // The derivative is that of differences
            constexpr double h = 1e-6;
            for (int axis = 1; axis < 3; ++axis) {
                glm::dvec3 q = p;
                q[axis] += h;
                EXPECT_NEAR(moved.gradient[axis], (field.moved(q, sides, on).u - moved.u) / h,
                            1e-3);
            }
        }
    }
}

TEST(Split, ClosesEveryFrameAndClearsTheObstacle)
{
    for (const Named& named : scenes()) {
        SCOPED_TRACE(named.name);
        const SplitField field = split_field(named.obstacles, {});
        const RayScene scene = scene_of(named.obstacles);
        for (int frame = 0; frame < 9; ++frame) {
            SCOPED_TRACE(frame);
            const Mesh model = ball({0.05, -2 + 0.5 * frame, 0}, 0.9, 40);
            const std::optional<SplitMesh> parted =
                split(model, field, {.tolerance = 2e-3, .keep_rest = true});
            if (!parted) continue;
            const Closedness closed = closedness(parted->mesh);
            EXPECT_EQ(closed.open, 0u);
            EXPECT_EQ(closed.twice, 0u);
            EXPECT_EQ(parted->fans, 0u);
            EXPECT_EQ(parted->gaps, 0u);
            EXPECT_LE(parted->off, 2e-3);
            Mesh rest = parted->mesh;
            rest.positions = parted->rest_positions;
            EXPECT_NEAR(volume(rest), volume(model), 1e-5);
            for (const glm::vec3& p : parted->mesh.positions)
                EXPECT_FALSE(inside(scene, glm::dvec3(p)));
        }
    }
}

// A ring round u and v is cut where the bar is, and not on its other side, where nothing parts
TEST(Split, CutsOnlyWhereHalvesPart)
{
    const SplitField field = split_field(scenes()[0].obstacles, {});
    for (const double v : {-1.0, 1.0}) {
        Mesh ring = welded(torus_mesh(1, 0.3, {96, 48}));
        for (glm::vec3& p : ring.positions) p.y += static_cast<float>(v);
        const std::optional<SplitMesh> parted = split(ring, field, {.tolerance = 2e-3});
        ASSERT_TRUE(parted);
        const Closedness closed = closedness(parted->mesh);
        EXPECT_EQ(closed.open + closed.twice, 0u);
        EXPECT_EQ(closed.euler, 2);
        EXPECT_LE(parted->off, 2e-3);
        for (std::size_t i = 0; i < ring.vertex_count(); ++i)
            if (v * ring.positions[i].y > 1) {
                EXPECT_EQ(parted->mesh.positions[i], ring.positions[i]);
            }
    }
}

TEST(Split, LeavesAModelBeforeAndBehindAsItIs)
{
    const SplitField field = split_field(scenes()[0].obstacles, {});
    EXPECT_FALSE(split(ball({0, -3, 0}, 0.9, 40), field, {}));
    EXPECT_FALSE(split(ball({0, 3, 0}, 0.9, 40), field, {}));
}

TEST(Split, GivesTheSameBitsForAnyNumberOfThreads)
{
    const SplitField field = split_field(scenes()[4].obstacles, {});
    const Mesh model = ball({0.05, -0.2, 0}, 0.9, 120);
    const SplitOptions options{.tolerance = 1e-3, .keep_rest = true};
    const std::optional<SplitMesh> many = split(model, field, options);
    const ThreadLimit one(1);
    const std::optional<SplitMesh> alone = split(model, field, options);
    ASSERT_TRUE(many && alone);
    EXPECT_EQ(many->mesh, alone->mesh);
    EXPECT_EQ(many->rest_positions, alone->rest_positions);
    EXPECT_EQ(many->off, alone->off);
}

TEST(Split, GivesTheSameBitsInTheMemoryOfAnyOtherFrame)
{
    SplitMemory memory;
    for (const Named& named : scenes()) {
        SCOPED_TRACE(named.name);
        const SplitField field = split_field(named.obstacles, {});
        for (const int segments : {60, 24, 96})
            for (const double at : {-0.8, 0.1, 0.9}) {
                const Mesh model = ball({0.05, at, 0}, 0.9, segments);
                const SplitOptions options{.tolerance = 4e-3, .keep_rest = segments == 24};
                const std::optional<SplitMesh> fresh = split(model, field, options);
                std::optional<SplitMesh> again = split(model, field, options, memory);
                ASSERT_EQ(fresh.has_value(), again.has_value());
                if (!fresh) continue;
                EXPECT_EQ(fresh->mesh, again->mesh);
                EXPECT_EQ(fresh->rest_positions, again->rest_positions);
                EXPECT_EQ(fresh->off, again->off);
                memory.mesh = std::move(again->mesh);
            }
    }
}

TEST(Split, LeavesWhatIsOutOfReachInPlace)
{
    const SplitField field = split_field(scenes()[0].obstacles, {});
    const Mesh model = ball({0.05, 0, 0}, 0.9, 60);
    const std::optional<SplitMesh> parted = split(model, field, {});
    ASSERT_TRUE(parted);
    const Box reach = field.reach();
    std::size_t far = 0;
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
        const glm::dvec3 uvw = field.frame.uvw(glm::dvec3(model.positions[v]));
        if (glm::all(glm::greaterThanEqual(uvw, reach.lo)) &&
            glm::all(glm::lessThanEqual(uvw, reach.hi)))
            continue;
        ++far;
        EXPECT_EQ(parted->mesh.positions[v], model.positions[v]);
    }
    EXPECT_GT(far, model.vertex_count() / 3);
    EXPECT_TRUE(parted->rest_positions.empty());
}

TEST(SplitField, LeavesZeroWithABendOrSmoothly)
{
    const SplitObstacle sharp = scenes()[0].obstacles[0];
    double begin = 0;
    for (const bool smooth : {false, true}) {
        const SplitField field = split_field({smooth ? with_smooth_ends(sharp) : sharp}, {});
        const Opening& opening = field.openings.at(0);
        EXPECT_GE(opening.walls[0].clear, 0.002);
        const glm::dvec2 lo = opening.walls[0].lo(), hi = opening.walls[0].hi();
        if (smooth) {
            EXPECT_LT(lo.x, begin);
        }
        begin = lo.x;
        for (const BicubicCells& wall : opening.wall_cells)
            for (const double way : {1.0, -1.0}) {
                const double end = way > 0 ? lo.x : hi.x;
                double most_bent = 0;
                for (int k = 1; k < 20; ++k) {
                    const double w = glm::mix(lo.y, hi.y, k / 20.0);
                    constexpr double h = 1e-5;
                    EXPECT_NEAR(wall.jet({end, w}).value, 0, 1e-15);
                    EXPECT_NEAR(wall.jet({end, w}).u, 0, 1e-12);
                    most_bent = std::max(most_bent, way * wall.jet({end + way * h, w}).u / h);
                }
                EXPECT_EQ(most_bent > 0.1, !smooth) << most_bent;
            }
    }
}

TEST(SplitField, TakesInterlockedObstaclesAsOne)
{
    const Mesh first = bar([](double s) { return glm::dvec3(2 * s - 1, 0, 0.1); }, 0.1);
    Mesh second = bar([](double s) { return glm::dvec3(0, 0, 2 * s - 1); }, 0.1);
    const SplitField field =
        split_field({obstacle("a", first), obstacle("b", std::move(second))}, {});
    ASSERT_EQ(field.openings.size(), 1u);
    EXPECT_EQ(field.openings[0].name, "a and b");
}

TEST(SplitField, MakesTheWallsOfALargeBoxBesideAFineTubeCertain)
{
    const auto bent = [](double s) {
        const double z = 2 * s - 1;
        return glm::dvec3(0.2 * std::sin(4 * z) - 0.2, 0.1 * z, 1.5 * z);
    };
    Mesh box = welded(box_mesh({0.2, 0.4, 2}, {1, 1, 1}));
    const glm::dvec3 x = glm::normalize(glm::dvec3(1, 0.4, -0.5));
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.3, 0, 1), x));
    for (glm::vec3& p : box.positions)
        p = glm::vec3(glm::dmat3(x, y, glm::cross(x, y)) * glm::dvec3(p));
    const SplitField field =
        split_field({obstacle("box", std::move(box)), obstacle("tube", bar(bent, 0.08, 40))}, {});
    ASSERT_EQ(field.openings.size(), 1u);
    for (const OpeningWall& wall : field.openings[0].walls)
        EXPECT_GE(wall.clear, 0.5 * 0.004 - 1e-12);
}

TEST(SplitField, RefusesObstaclesWithoutRoomBetweenThem)
{
    const auto upright = [](double x) {
        return bar([=](double s) { return glm::dvec3(x, 0, 2 * s - 1); }, 0.2);
    };
    EXPECT_THROW(split_field({obstacle("a", upright(0)), obstacle("b", upright(0.42))}, {}),
                 Rejected);
}

} // namespace
} // namespace trivar::testing
