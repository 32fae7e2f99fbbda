// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/split/cap.h"
#include "core/split/split.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

struct Plane {
    glm::dvec3 normal;
    double offset;
};

struct CutInTwo {
    CutMesh cut;
    Caps caps;
};

CutInTwo cut_by(const Mesh& mesh, const Plane& plane, double longest = 0)
{
    const glm::dvec3 n = glm::normalize(plane.normal);
    const glm::dvec3 x = glm::normalize(
        glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(n, x);
    std::vector<double> heights;
    for (const glm::vec3& p : mesh.positions)
        heights.push_back(glm::dot(n, glm::dvec3(p)) - plane.offset);
    CutInTwo out{cut(mesh, heights), {}};
    CapOptions options;
    for (const glm::vec3& p : out.cut.places)
        options.places.emplace_back(glm::dot(x, glm::dvec3(p)), glm::dot(y, glm::dvec3(p)));
    options.point = [=](const glm::dvec2& at) { return plane.offset * n + at.x * x + at.y * y; };
    options.normal = [=](const glm::dvec2&) { return n; };
    if (longest > 0)
        options.coarseness = [=](const std::array<glm::dvec2, 3>& t) {
            const std::array<double, 3> edges{glm::distance(t[0], t[1]) / longest,
                                              glm::distance(t[1], t[2]) / longest,
                                              glm::distance(t[2], t[0]) / longest};
            return TriangleCoarseness{edges, std::ranges::max(edges)};
        };
    out.caps = cap(out.cut, options);
    return out;
}

void expect_two_closed_halves(const Mesh& mesh, const CutInTwo& halves)
{
    double sum = 0;
    for (const bool above : {false, true}) {
        const Mesh half = half_of(halves.cut.mesh, halves.cut.above, above);
        const Closedness closed = closedness(half);
        EXPECT_EQ(closed.open, 0u);
        EXPECT_EQ(closed.twice, 0u);
        EXPECT_EQ(closed.euler % 2, 0);
        EXPECT_GT(half.face_count(), 0u);
        EXPECT_GT(volume(half), 0);
        sum += volume(half);
    }
    EXPECT_NEAR(sum, volume(mesh), 2e-7 * volume(mesh));
}

TEST(Cut, PartsATorusIntoClosedHalves)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {120, 60}));
    expect_two_closed_halves(torus, cut_by(torus, {{1, 0.2, 0.1}, 0.05}));  // two discs
    expect_two_closed_halves(torus, cut_by(torus, {{0.15, 0.1, 1}, 0.03})); // a ring
    expect_two_closed_halves(torus, cut_by(torus, {{0.15, 0.1, 1}, 0.03}, 0.02));
    expect_two_closed_halves(torus, cut_by(torus, {{0, 0, 1}, 0})); // through vertices
}

TEST(Cut, GoesThroughVerticesOfFacesThatItMeetsAtRightAngles)
{
    const Mesh box = welded(box_mesh({2, 2, 2}, {4, 4, 4}));
    for (const Plane& plane : {Plane{{1, 0, 0}, 0}, Plane{{0, 1, 0}, 0.5}, Plane{{1, 1, 0}, 0},
                               Plane{{0, 0, 1}, 1e-9}, Plane{{1, 0, 1}, -1e-12}}) {
        const CutInTwo halves = cut_by(box, plane);
        expect_two_closed_halves(box, halves);
        EXPECT_EQ(halves.caps.fans, 0u);
        EXPECT_GT(std::ranges::max(halves.cut.moved), 0);
        EXPECT_LE(std::ranges::max(halves.cut.moved), 1e-3);
    }
}

TEST(Cut, PartsHalvesOfTheTorusThatAreEqualEqually)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {100, 50}));
    const CutInTwo halves = cut_by(torus, {{0, 0, 1}, 0});
    EXPECT_NEAR(volume(half_of(halves.cut.mesh, halves.cut.above, true)), volume(torus) / 2,
                2e-4 * volume(torus));
}

TEST(Cut, ClosesHalvesByRandomPlanes)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Mesh torus = welded(torus_mesh(1, 0.4, {40, 20}));
    for (int i = 0; i < 300; ++i) {
        const CutInTwo halves = cut_by(
            torus, {{uniform(random), uniform(random), uniform(random)}, 0.9 * uniform(random)},
            i % 3 ? 0 : 0.1);
        if (halves.cut.rim.empty()) continue;
        expect_two_closed_halves(torus, halves);
        EXPECT_EQ(halves.caps.fans, 0u);
    }
}

TEST(Cut, LeavesWhatItDoesNotTouchAsItIs)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {40, 20}));
    const CutInTwo none = cut_by(torus, {{0, 0, 1}, 5});
    EXPECT_EQ(none.cut.mesh, torus);
    const CutInTwo some = cut_by(torus, {{1, 0, 0}, 1.3});
    for (std::size_t v = 0; v < torus.vertex_count(); ++v)
        EXPECT_EQ(some.cut.mesh.positions[v], torus.positions[v]);
}

// The first faces of a mesh.
Mesh part_of_mesh(Mesh mesh, std::size_t faces)
{
    mesh.corners.resize(mesh.face_begin[faces]);
    mesh.face_begin.resize(faces + 1);
    return mesh;
}

TEST(Cut, LeavesASheetOpenAndSaysSo)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {40, 20}));
    const CutInTwo halves =
        cut_by(part_of_mesh(torus, torus.face_count() / 4), {{0.1, 0.1, 1}, 0.1});
    EXPECT_GT(halves.cut.rim.size(), 0u);
    EXPECT_EQ(halves.caps.open, halves.cut.rim.size());
    EXPECT_EQ(halves.cut.mesh.face_count(), halves.caps.first_face);
}

TEST(Cut, GoesStraightAcrossASmallHoleAndSaysSo)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {40, 20}));
    const CutInTwo halves =
        cut_by(part_of_mesh(torus, torus.face_count() - 30), {{0.1, 0.1, 1}, 0.1});
    EXPECT_EQ(halves.caps.open, 0u);
    EXPECT_GT(halves.caps.gaps, 0u);
    EXPECT_GT(halves.cut.mesh.face_count(), halves.caps.first_face);
}

TEST(Cut, IsAsFineAcrossAHoleAsElsewhere)
{
    const Mesh torus = welded(torus_mesh(1, 0.4, {120, 60}));
    constexpr double longest = 0.08; // edges of the skin are shorter
    const CutInTwo halves =
        cut_by(part_of_mesh(torus, torus.face_count() - 270), {{0.1, 0.1, 1}, 0.1}, longest);
    ASSERT_GT(halves.caps.gaps, 0u);
    const Mesh& mesh = halves.cut.mesh;
    for (std::size_t f = halves.caps.first_face; f < mesh.face_count(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = [&](std::size_t k) {
                return halves.caps.parameters[mesh.corners[mesh.face_begin[f] + k % 3] -
                                              halves.caps.first_vertex];
            };
            EXPECT_LE(glm::distance(at(i), at(i + 1)), longest);
        }
}

} // namespace
} // namespace trivar::testing
