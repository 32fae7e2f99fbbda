// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/split/split.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

// Whatever an obstacle or a model is, nothing crashes, and what is not closed is said.
namespace trivar::testing {
namespace {

SplitObstacle obstacle_of(Mesh mesh, const std::string& name = "obstacle")
{
    return {name, {{std::make_shared<const RayMesh>(make_ref(std::move(mesh)))}}, 0.005, 0};
}

Mesh upright_bar()
{
    return bar([](double s) { return glm::dvec3(0, 0, 4 * s - 2); }, 0.18);
}

Mesh both(Mesh a, const Mesh& b)
{
    const auto first = static_cast<std::uint32_t>(a.vertex_count());
    a.normals.clear();
    a.uvs.clear();
    a.points.clear();
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t c = b.face_begin[f]; c < b.face_begin[f + 1]; ++c)
            face.push_back(first + b.corners[c]);
        add_face(a, face);
    }
    return a;
}

Mesh with_faces(const Mesh& mesh, const std::vector<std::size_t>& faces)
{
    Mesh out = mesh;
    out.corners.clear();
    out.face_begin = {0};
    for (const std::size_t f : faces)
        add_face(out, std::span(mesh.corners.data() + mesh.face_begin[f],
                                mesh.corners.data() + mesh.face_begin[f + 1]));
    return out;
}

bool all_finite(const Mesh& mesh)
{
    return std::ranges::all_of(mesh.positions, [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

// Parts a ball by obstacles, which may be refused with a sentence. The parts are closed.
void expect_closed_or_refused(const std::vector<SplitObstacle>& obstacles)
{
    try {
        const SplitField field = split_field(obstacles, {});
        for (const double v : {-0.7, -0.2, 0.0, 0.4}) {
            const Mesh model = ball({0.05, v, 0}, 0.9, 32);
            const std::optional<SplitMesh> parted =
                split(model, field, {.tolerance = 5e-3, .most_triangles = 100000});
            if (!parted) continue;
            EXPECT_TRUE(all_finite(parted->mesh));
            const Closedness closed = closedness(parted->mesh);
            EXPECT_EQ(closed.unequal, 0u);
            EXPECT_EQ(parted->open, 0u);
        }
    } catch (const Rejected& error) {
        EXPECT_GT(std::string(error.what()).size(), 10u);
    }
}

// Parts a model by a bar at some places of its way. What is open is said.
void expect_closed_or_said(Mesh model)
{
    const SplitField field = split_field({obstacle_of(upright_bar())}, {});
    if (model.points.empty()) model.points = points_by_position(model.positions);
    const bool was_closed = closedness(model).unequal == 0;
    for (const double v : {-0.5, 0.0, 0.3}) {
        Mesh there = model;
        for (glm::vec3& p : there.positions) p.y += static_cast<float>(v);
        const std::optional<SplitMesh> parted =
            split(there, field, {.tolerance = 5e-3, .most_triangles = 100000});
        if (!parted) continue;
        EXPECT_TRUE(all_finite(parted->mesh));
        if (!was_closed) continue;
        EXPECT_EQ(closedness(parted->mesh).unequal, 0u);
        EXPECT_EQ(parted->open, 0u);
    }
}

TEST(BadObstacle, MayBeOpen)
{
    Mesh open = upright_bar();
    std::vector<std::size_t> faces(open.face_count() / 2);
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = 2 * f;
    expect_closed_or_refused({obstacle_of(with_faces(open, faces))});
    Mesh sheet = plane_mesh({0.4, 0.6}, {3, 3});
    for (glm::vec3& p : sheet.positions) p = {p.x * p.y + 0.1f * p.x, p.x, p.y};
    expect_closed_or_refused({obstacle_of(sheet)});
}

TEST(BadObstacle, MayRunThroughItself)
{
    const Mesh across = bar([](double s) { return glm::dvec3(0.6 * s - 0.3, 0, s - 0.5); }, 0.1);
    expect_closed_or_refused({obstacle_of(both(upright_bar(), across))});
}

TEST(BadObstacle, IsRefusedWhereItIsFlat)
{
    for (const int axis : {0, 1, 2}) {
        Mesh flat = upright_bar();
        for (glm::vec3& p : flat.positions) p[axis] = 0.25f;
        EXPECT_THROW(split_field({obstacle_of(flat)}, {}), Rejected);
    }
    EXPECT_THROW(split_field({obstacle_of(Mesh{})}, {}), Rejected);
}

TEST(BadObstacle, MayBeTinyHugeOrFarAway)
{
    for (const float scale : {1e-7f, 1e-4f, 1e3f, 1e7f}) {
        Mesh scaled = ball(glm::dvec3(0), 1, 16);
        for (glm::vec3& p : scaled.positions) p *= scale;
        expect_closed_or_refused({obstacle_of(scaled)});
    }
    Mesh far = upright_bar();
    for (glm::vec3& p : far.positions) p.x += 1e6f;
    expect_closed_or_refused({obstacle_of(far)});
    expect_closed_or_refused({obstacle_of(far), obstacle_of(upright_bar())});
    Mesh needle = upright_bar();
    for (glm::vec3& p : needle.positions) p = {1e-5f * p.x, 1e-5f * p.y, 100 * p.z};
    expect_closed_or_refused({obstacle_of(needle)});
    Mesh plate = upright_bar();
    for (glm::vec3& p : plate.positions) p = {1e-5f * p.x, 5 * p.y, p.z};
    expect_closed_or_refused({obstacle_of(plate)});
}

TEST(BadObstacle, MayBeInsideTheModel)
{
    expect_closed_or_refused({obstacle_of(ball({0.1, 0, 0.1}, 0.1, 16))});
}

TEST(BadObstacle, MayBeThereTwice)
{
    expect_closed_or_refused({obstacle_of(upright_bar(), "a"), obstacle_of(upright_bar(), "b")});
    const Mesh one = upright_bar();
    expect_closed_or_refused({obstacle_of(both(one, one))});
}

TEST(BadObstacle, MayHaveFlippedAndDegenerateFaces)
{
    std::mt19937 random(5);
    Mesh damaged = upright_bar();
    for (std::size_t f = 0; f < damaged.face_count(); ++f) {
        std::uint32_t* const c = &damaged.corners[3 * f];
        if (random() % 3 == 0) std::swap(c[0], c[1]);
        if (random() % 7 == 0) c[2] = c[1];
    }
    expect_closed_or_refused({obstacle_of(damaged)});
}

TEST(BadModel, MayHaveTJunctions)
{
    // A box, of which one face ends in the middle of the edges of two others
    Mesh box = welded(box_mesh({0.8, 0.8, 0.8}, {2, 2, 2}));
    std::vector<std::size_t> faces;
    for (std::size_t f = 0; f < box.face_count(); ++f) faces.push_back(f);
    Mesh open = with_faces(box, {faces.begin() + 4, faces.end()});
    expect_closed_or_said(open);
    // Its hole is filled by one face, whose edges no other face has
    std::vector<std::uint32_t> corners;
    const std::uint32_t* const c = &box.corners[0];
    corners.assign(c, c + 4);
    add_face(open, corners);
    expect_closed_or_said(open);
}

TEST(BadModel, MayHaveEdgesOfFourFaces)
{
    Mesh two;
    for (const float x : {0.0f, 0.5f})
        for (const float y : {0.0f, 0.5f}) {
            if ((x > 0) != (y > 0)) continue; // two boxes that share the edge x = y = 0.25
            Mesh box = box_mesh({0.5, 0.5, 0.5}, {1, 1, 1});
            for (glm::vec3& p : box.positions) p += glm::vec3(x - 0.3f, y - 0.3f, 0);
            two = both(std::move(two), box);
        }
    expect_closed_or_said(two);
    // and the shared edge lies across the cut
    for (glm::vec3& p : two.positions) p = {p.z, p.y, -p.x};
    expect_closed_or_said(two);
    for (glm::vec3& p : two.positions) p = {p.x + 0.3f * p.z, p.y, p.z + 0.2f * p.y};
    expect_closed_or_said(two);
}

TEST(BadModel, MayRunThroughItself)
{
    expect_closed_or_said(both(ball({0, 0, 0}, 0.6, 24), ball({0.1, 0.1, 0.2}, 0.6, 24)));
    const Mesh same = ball({0, 0, 0}, 0.6, 24);
    expect_closed_or_said(both(same, same));
}

TEST(BadModel, MayBeDamagedInAnyWay)
{
    std::mt19937 random(11);
    for (int k = 0; k < 60; ++k) {
        Mesh mesh = ball({0, 0, 0}, 0.7, 14);
        mesh.normals.clear();
        mesh.uvs.clear();
        std::vector<std::uint32_t>& corners = mesh.corners;
        for (int damage = 0; damage < k % 8; ++damage) {
            const std::size_t at = random() % corners.size(), other = random() % corners.size();
            switch (random() % 5) {
            case 0: std::swap(corners[at], corners[other]); break;
            case 1: corners[at] = corners[other]; break;
            case 2: mesh.positions[corners[at]] = mesh.positions[corners[other]]; break;
            case 3: mesh.positions[corners[at]] *= 1e5f; break;
            default: {
                const std::size_t f = random() % mesh.face_count();
                std::reverse(corners.begin() + mesh.face_begin[f],
                             corners.begin() + mesh.face_begin[f + 1]);
            }
            }
        }
        if (k % 2) mesh.points.clear();
        expect_closed_or_said(mesh);
    }
}

} // namespace
} // namespace trivar::testing
