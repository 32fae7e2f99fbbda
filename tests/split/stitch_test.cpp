// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "core/split/along_obstacles.h"
#include "core/split/seam.h"
#include "core/split/split.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <set>

// Halves that are stitched: their skin is drawn in beside the obstacle until its lips meet.
namespace trivar::testing {
namespace {

SplitObstacle sewn_round(Mesh mesh, double clearance = 0.01)
{
    SplitObstacle out;
    out.name = "obstacle";
    out.bodies = {{std::make_shared<const RayMesh>(make_ref(std::move(mesh))), glm::dmat4(1), 1}};
    out.clearance = clearance;
    return out;
}

// A bar along w that leans, from far below to `top`.
SplitObstacle leaning_bar(double top = 2, double lean = 0.2)
{
    return sewn_round(bar(
        [=](double s) {
            const double z = (top + 2) * s - 2;
            return glm::dvec3(lean * z, 0.1 * lean * z, z);
        },
        0.2));
}

const SplitOptions stitched{
    .tolerance = 2e-3, .closing = SplitClosing::stitched, .keep_rest = true};

std::optional<SplitMesh> sewn(const Mesh& mesh, const SplitField& field)
{
    return split(mesh, field, stitched);
}

// How often points of the mesh's triangles lie in the obstacle.
std::size_t samples_inside(const Mesh& mesh, const SplitObstacle& obstacle)
{
    const RayScene scene(obstacle.bodies);
    std::size_t count = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = glm::dvec3(mesh.positions[mesh.corners[mesh.face_begin[f] + i]]);
        for (const glm::dvec3& at : {p[0], (p[0] + p[1]) / 2.0, (p[0] + p[1] + p[2]) / 3.0}) {
            if (std::abs(at.y) > 0.5 || std::abs(at.x) > 0.8) continue;
            const std::optional<Hit> hit =
                scene.hit({at, glm::normalize(glm::dvec3(0.31, 0.93, 0.2))});
            count += hit && hit->back_face;
        }
    }
    return count;
}

// How many pieces hang together by points.
std::size_t pieces(const Mesh& mesh)
{
    std::vector<std::uint32_t> root(point_count(mesh));
    std::iota(root.begin(), root.end(), 0u);
    const auto root_of = [&](std::uint32_t p) {
        while (root[p] != p) p = root[p] = root[root[p]];
        return p;
    };
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f] + 1; c < mesh.face_begin[f + 1]; ++c)
            root[root_of(mesh.point(mesh.corners[c]))] = root_of(mesh.point(mesh.corners[c - 1]));
    std::set<std::uint32_t> out;
    for (const std::uint32_t v : mesh.corners) out.insert(root_of(mesh.point(v)));
    return out.size();
}

long euler_of(const Mesh& mesh)
{
    return closedness(mesh).euler;
}

// The upper half of a ball, open below.
Mesh bowl()
{
    Mesh mesh = ball({0, 0, 0}, 0.9, 48);
    Mesh out = mesh;
    out.corners.clear();
    out.face_begin = {0};
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        bool up = true;
        for (std::uint32_t c = begin; c < end; ++c)
            up &= mesh.positions[mesh.corners[c]].z > -1e-3f;
        if (up) add_face(out, {mesh.corners.data() + begin, end - begin});
    }
    return without_loose_vertices(std::move(out));
}

TEST(Stitch, ClosesEveryFrameAndClearsTheObstacle)
{
    for (const double lean : {0.0, 0.3, 0.8}) {
        SCOPED_TRACE(lean);
        const SplitObstacle obstacle = leaning_bar(2, lean);
        const SplitField field = split_field({obstacle}, {});
        for (int frame = 0; frame < 9; ++frame) {
            SCOPED_TRACE(frame);
            const Mesh model = ball({0.05, -1.6 + 0.4 * frame, 0}, 0.9, 40);
            const std::optional<SplitMesh> parted = sewn(model, field);
            if (!parted) continue;
            const Closedness closed = closedness(parted->mesh);
            EXPECT_EQ(closed.open, 0u);
            EXPECT_EQ(closed.unequal, 0u);
            EXPECT_TRUE(is_closed_body(parted->mesh));
            EXPECT_LE(parted->off, 2e-3);
            EXPECT_EQ(parted->open, 0u);
            EXPECT_EQ(samples_inside(parted->mesh, obstacle), 0u);
            for (const glm::vec3& n : parted->mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-4);
        }
    }
}

TEST(Stitch, DrawsInAlongABarThatLeans)
{
    for (const double lean : {-0.8, 0.0, 0.3, 1.0}) {
        const SplitObstacle obstacle =
            sewn_round(bar([=](double s) { return (4 * s - 2) * glm::dvec3(0.1, lean, 1); }, 0.2));
        const SplitFrame frame = along_obstacles({obstacle}, {});
        EXPECT_EQ(frame.axes[0], glm::dvec3(1, 0, 0));
        EXPECT_NEAR(glm::determinant(frame.axes), 1, 1e-12);
        EXPECT_LT(glm::distance(frame.axes[2], glm::normalize(glm::dvec3(0, lean, 1))), 0.02);
    }
    const auto kept = [](Mesh mesh) {
        return along_obstacles({sewn_round(std::move(mesh))}, {}) == SplitFrame{};
    };
    EXPECT_TRUE(kept(ball({0, 0, 0}, 0.5, 24)));
    EXPECT_TRUE(kept(bar([](double s) { return glm::dvec3(0, 4 * s, 0.1 * s); }, 0.2)));
}

TEST(Stitch, MakesARingOfABallRoundABar)
{
    const SplitField field = split_field({leaning_bar()}, {});
    const Mesh model = ball({0.05, 0, 0}, 0.9, 40);
    ASSERT_EQ(euler_of(model), 2);
    const std::optional<SplitMesh> parted = sewn(model, field);
    ASSERT_TRUE(parted);
    EXPECT_EQ(euler_of(parted->mesh), 0);
    EXPECT_LT(volume(parted->mesh), volume(model)); // it is drawn in, and not only pushed aside
}

TEST(Stitch, SewsTheLipsTogetherBesideTheObstacle)
{
    const SplitField field = split_field({leaning_bar(2, 0)}, {});
    const std::optional<SplitMesh> parted = sewn(ball({0, 0, 0.1}, 0.9, 40), field);
    ASSERT_TRUE(parted);
    std::size_t lips = 0;
    for (std::size_t v = 0; v < parted->mesh.vertex_count(); ++v) {
        const glm::vec3& rest = parted->rest_positions[v];
        if (std::abs(rest.x) > 1e-6f || std::abs(rest.y) > 0.2f) continue;
        ++lips;
        EXPECT_NEAR(parted->mesh.positions[v].z, 0.1, 0.02); // all at one height
    }
    EXPECT_GT(lips, 20u);
}

TEST(Stitch, SewsBothHalvesTogetherBelowAnObstacleThatEndsInTheModel)
{
    const SplitObstacle obstacle = leaning_bar(0.2, 0);
    const SplitField field = split_field({obstacle}, {});
    const Mesh model = ball({0, 0, 0}, 0.9, 40);
    const std::optional<SplitMesh> parted = sewn(model, field);
    ASSERT_TRUE(parted);
    EXPECT_TRUE(is_closed_body(parted->mesh));
    EXPECT_EQ(euler_of(parted->mesh), 2);
    EXPECT_EQ(samples_inside(parted->mesh, obstacle), 0u);
}

TEST(Stitch, LeavesTheSkinWholeRoundWhatIsHiddenInIt)
{
    const SplitField field = split_field({sewn_round(ball({0, 0, 0}, 0.2, 24))}, {});
    const Mesh model = ball({0.02, 0, 0}, 0.9, 40);
    const std::optional<SplitMesh> parted = sewn(model, field);
    ASSERT_TRUE(parted);
    EXPECT_TRUE(is_closed_body(parted->mesh));
    EXPECT_EQ(euler_of(parted->mesh), 2); // and no second skin round the obstacle
}

TEST(Stitch, KeepsASheetOneSheet)
{
    const SplitObstacle obstacle = leaning_bar();
    const SplitField field = split_field({obstacle}, {});
    const Mesh model = bowl();
    const std::size_t rim = closedness(model).open;
    for (const double way : {-0.5, 0.0, 0.3}) {
        Mesh moved = model;
        for (glm::vec3& p : moved.positions) p.y += static_cast<float>(way);
        const std::optional<SplitMesh> parted = sewn(moved, field);
        ASSERT_TRUE(parted);
        EXPECT_EQ(pieces(parted->mesh), 1u);
        EXPECT_GT(closedness(parted->mesh).open, rim); // the hole through which the obstacle goes
        EXPECT_EQ(parted->open, 0u);
        EXPECT_EQ(samples_inside(parted->mesh, obstacle), 0u);
    }
}

TEST(Stitch, LeavesAModelBeforeAndBehindAsItIs)
{
    const SplitField field = split_field({leaning_bar()}, {});
    EXPECT_FALSE(sewn(ball({0, -3, 0}, 0.9, 40), field));
    EXPECT_FALSE(sewn(ball({0, 3, 0}, 0.9, 40), field));
}

TEST(Stitch, LeavesWhatIsOutOfReachInPlace)
{
    const SplitField field = split_field({leaning_bar()}, {});
    const Mesh model = ball({0.05, 0.1, 0}, 0.9, 60);
    const std::optional<SplitMesh> parted = sewn(model, field);
    ASSERT_TRUE(parted);
    const Box reach = field.reach();
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
        const glm::dvec3 uvw = field.frame.uvw(glm::dvec3(model.positions[v]));
        if (glm::any(glm::lessThan(uvw, reach.lo)) || glm::any(glm::greaterThan(uvw, reach.hi))) {
            EXPECT_EQ(parted->mesh.positions[v], model.positions[v]);
        }
    }
}

TEST(Stitch, GivesTheSameBitsForAnyNumberOfThreads)
{
    const SplitField field = split_field({leaning_bar()}, {});
    const Mesh model = ball({0.05, 0.1, 0}, 0.9, 60);
    const std::optional<SplitMesh> many = sewn(model, field);
    const ThreadLimit one(1);
    const std::optional<SplitMesh> alone = sewn(model, field);
    ASSERT_TRUE(many && alone);
    EXPECT_EQ(many->mesh, alone->mesh);
    EXPECT_EQ(many->off, alone->off);
}

TEST(Seam, FoldsNothingAndKnowsItsDerivatives)
{
    const SplitField field = split_field({leaning_bar(2, 0.4)}, {});
    const Opening& o = field.openings[0];
    const glm::dvec2 lo = o.walls[0].lo(), hi = o.walls[0].hi();
    const std::vector<Seam> seams{
        {{{lo.y, lo.y, 1}, {-0.7, 0.1, 0}, {0.6, 0.1, 0}, {hi.y, hi.y, 1}}, {lo.x, hi.x}, o.ends}};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const std::vector<char> on{0};
    const auto drawn = [&](const glm::dvec3& p) {
        return drawn_in(field, seams, p, std::vector<char>{static_cast<char>(o.height(p) >= 0)},
                        on);
    };
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p(0.6 * uniform(random), 0.5 * uniform(random), 1.5 * uniform(random));
        if (std::abs(o.height(p)) < 1e-4) continue;
        const DrawnIn at = drawn(p);
        EXPECT_NEAR(o.height(at.uvw), o.height(p), 1e-9);    // so it stays on its side
        EXPECT_GE(at.u.x * at.w.z - at.u.z * at.w.x, -1e-9); // the determinant
        constexpr double h = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 q = p;
            q[axis] += h;
            const DrawnIn beside = drawn(q);
            EXPECT_NEAR((beside.uvw.z - at.uvw.z) / h, at.w[axis], 2e-3);
            EXPECT_NEAR((beside.uvw.x - at.uvw.x) / h, at.u[axis], 2e-3);
        }
        // Its bounds hold between two points
        const double w = p.z + 0.2 * uniform(random);
        const SeamBound known = bound(seams[0], std::min(p.z, w), std::max(p.z, w));
        const auto target = seams[0].target((p.z + w) / 2);
        EXPECT_LE(std::abs(target.value - (p.z + w) / 2), known.most + 1e-12);
        EXPECT_LE(target.slope, known.slope + 1e-12);
        EXPECT_LE(std::abs(target.slope - 1), known.slope_less_1 + 1e-12);
        EXPECT_LE(std::abs(seams[0].target(w).slope - seams[0].target(p.z).slope),
                  known.bend * std::abs(w - p.z) + known.kink + 1e-12);
    }
}

} // namespace
} // namespace trivar::testing
