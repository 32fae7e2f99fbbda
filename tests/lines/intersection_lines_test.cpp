// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/intersection_lines.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

using Placed = std::vector<std::pair<Ref<Mesh>, glm::dmat4>>;

glm::dmat4 moved(const glm::dvec3& by)
{
    glm::dmat4 out(1);
    out[3] = glm::dvec4(by, 1);
    return out;
}

TriangleBody body(const Mesh& mesh, const glm::dvec3& at = glm::dvec3(0))
{
    return triangle_body(Placed{{make_ref(mesh), moved(at)}});
}

double length_of(const IntersectionLines& found)
{
    double out = 0;
    for (std::size_t c = 0; c < found.lines.count(); ++c) {
        const std::uint32_t first = found.lines.first[c], last = found.lines.first[c + 1];
        for (std::uint32_t i = first; i < last; ++i) {
            if (i + 1 == last && !found.lines.closed[c]) break;
            const std::uint32_t next = i + 1 < last ? i + 1 : first;
            out += double{glm::distance(found.lines.points[i].p, found.lines.points[next].p)};
        }
    }
    return out;
}

TEST(IntersectionLines, OfABallAndAPlaneAreACircle)
{
    constexpr double height = 0.3;
    const TriangleBody ball = body(sphere_mesh(1, 96, 48)),
                       plane = body(plane_mesh({4, 4}, {3, 5}), {0, 0, height});
    const IntersectionLines found = intersection_lines(ball, plane);
    ASSERT_EQ(found.lines.count(), 1u);
    EXPECT_TRUE(found.lines.closed[0]);
    ASSERT_EQ(found.normals.size(), found.lines.points.size());
    for (std::size_t i = 0; i < found.normals.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(found.lines.points[i].p) + found.origin;
        EXPECT_NEAR(p.z, height, 1e-6);
        EXPECT_NEAR(glm::length(glm::dvec2(p)), std::sqrt(1 - height * height), 3e-3);
        EXPECT_NEAR(glm::dot(found.normals[i][0], glm::vec3(glm::normalize(p))), 1, 1e-2);
        EXPECT_NEAR(std::abs(found.normals[i][1].z), 1, 1e-6);
    }
}

// The intersection of two boxes is a box of 0.6 x 0.7 x 0.65, of which two edges along each axis
// are between a face of one and a face of the other.
TEST(IntersectionLines, OfTwoBoxesAreSixEdgesOfWhatTheyShare)
{
    for (const int segments : {1, 4}) {
        const Mesh box = box_mesh(glm::dvec3(1), glm::ivec3(segments));
        const IntersectionLines found = intersection_lines(body(box), body(box, {0.4, -0.3, 0.35}));
        EXPECT_NEAR(length_of(found), 2 * (0.6 + 0.7 + 0.65), 1e-5);
        EXPECT_EQ(found.lines.count(), 6u) << "they end at corners";
    }
}

TEST(IntersectionLines, AreNoneOfWhatOnlyTouches)
{
    const Mesh box = box_mesh(glm::dvec3(1), glm::ivec3(3));
    EXPECT_EQ(
        intersection_lines(body(box), body(plane_mesh({4, 4}, {2, 2}), {0, 0, -0.5})).lines.count(),
        0u);
    EXPECT_EQ(intersection_lines(body(box), body(box, {1, 0, 0})).lines.count(), 0u);
    EXPECT_EQ(intersection_lines(body(box), body(box, {5, 0, 0})).lines.count(), 0u);
    EXPECT_EQ(intersection_lines(body(box)).lines.count(), 0u) << "with itself";
    EXPECT_EQ(intersection_lines(body(Mesh{}), body(box)).lines.count(), 0u);
}

TEST(IntersectionLines, OfABodyWithItselfAreThoseOfItsShells)
{
    const Ref<Mesh> ball = make_ref(sphere_mesh(1, 64, 32));
    const Placed two{{ball, glm::dmat4(1)}, {ball, moved({1, 0.01, 0.02})}};
    const IntersectionLines found = intersection_lines(triangle_body(two));
    ASSERT_EQ(found.lines.count(), 1u);
    EXPECT_TRUE(found.lines.closed[0]);
    EXPECT_NEAR(length_of(found), 2 * 3.14159 * std::sqrt(0.75), 0.02);
}

TEST(IntersectionLines, AreTheSameForAnyNumberOfThreads)
{
    const TriangleBody pot = body(teapot_mesh(1, 10)),
                       ball = body(sphere_mesh(0.5, 64, 32), {0, 0, 0.5});
    const auto points = [&] {
        std::vector<glm::vec3> out;
        for (const SilhouettePoint& p : intersection_lines(pot, ball).lines.points)
            out.push_back(p.p);
        return out;
    };
    const std::vector<glm::vec3> many = points();
    EXPECT_FALSE(many.empty());
    const ThreadLimit one(1);
    EXPECT_EQ(many, points());
}

} // namespace
} // namespace trivar::testing
