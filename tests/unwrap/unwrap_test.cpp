// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/unwrap/uv_stretch.h"
#include "tests/unwrap/surfaces.h"

#include <gmock/gmock.h>
#include <set>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The triangles of the mesh with its new texture coordinates.
std::vector<std::array<glm::dvec2, 3>> flat_triangles(const Mesh& mesh)
{
    std::vector<std::array<glm::dvec2, 3>> out;
    for (const glm::uvec3& t : triangles(mesh))
        out.push_back({mesh.uvs[0][t.x], mesh.uvs[0][t.y], mesh.uvs[0][t.z]});
    return out;
}

// The number of pixel centres that are in several triangles.
std::size_t covered_twice(const Mesh& mesh, int pixels)
{
    std::vector<std::uint8_t> count(static_cast<std::size_t>(pixels) * pixels, 0);
    for (const auto& t : flat_triangles(mesh)) {
        const glm::dvec2 low = glm::min(t[0], glm::min(t[1], t[2])) * double(pixels),
                         high = glm::max(t[0], glm::max(t[1], t[2])) * double(pixels);
        for (int y = int(low.y); y <= std::min(int(high.y), pixels - 1); ++y)
            for (int x = int(low.x); x <= std::min(int(high.x), pixels - 1); ++x) {
                const glm::dvec2 p((x + 0.5) / pixels, (y + 0.5) / pixels);
                // strictly inside: pixels on an edge between two triangles count for neither
                count[std::size_t(y) * pixels + x] += turn(t[0], t[1], p) > 1e-15 &&
                                                      turn(t[1], t[2], p) > 1e-15 &&
                                                      turn(t[2], t[0], p) > 1e-15;
            }
    }
    return static_cast<std::size_t>(std::ranges::count_if(count, [](int n) { return n > 1; }));
}

class EverySurface : public ::testing::TestWithParam<UnwrapMethod> {
protected:
    UnwrapOptions options() const { return {.method = GetParam()}; }
};
INSTANTIATE_TEST_SUITE_P(ByBothMethods, EverySurface,
                         ::testing::Values(UnwrapMethod::conformal, UnwrapMethod::rigid));

TEST_P(EverySurface, LiesFlatWithNoTriangleTurnedOver)
{
    for (const NamedMesh& each : surfaces_to_unwrap()) {
        const Unwrapped out = unwrapped_alone(each.mesh, options());
        for (const auto& t : flat_triangles(with_uvs(each.mesh, out.uvs[0])))
            ASSERT_GT(turn(t[0], t[1], t[2]), 0) << each.name;
        EXPECT_EQ(out.facts.left_out, 0u) << each.name;
        EXPECT_GT(out.facts.filled, 0.3) << each.name;
    }
}

TEST_P(EverySurface, IsNowhereOverItself)
{
    for (const NamedMesh& each : surfaces_to_unwrap()) {
        const Mesh mesh = with_uvs(each.mesh, unwrapped_alone(each.mesh, options()).uvs[0]);
        EXPECT_EQ(covered_twice(mesh, 1024), 0u) << each.name;
        for (const glm::vec2& uv : mesh.uvs[0]) {
            ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1) << each.name;
        }
    }
}

TEST_P(EverySurface, KeepsItsPointsAndFaces)
{
    for (const NamedMesh& each : surfaces_to_unwrap()) {
        const Mesh mesh = with_uvs(each.mesh, unwrapped_alone(each.mesh, options()).uvs[0]);
        ASSERT_EQ(mesh.face_begin, each.mesh.face_begin);
        for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
            const std::uint32_t now = mesh.corners[c], before = each.mesh.corners[c];
            ASSERT_EQ(mesh.positions[now], each.mesh.positions[before]);
            ASSERT_EQ(mesh.normals[now], each.mesh.normals[before]);
            ASSERT_EQ(mesh.point(now), each.mesh.point(before));
        }
        EXPECT_NO_THROW(validate(mesh, each.name));
    }
}

TEST_P(EverySurface, HasChartsThatKeepTheirDistance)
{
    constexpr double apart = 1.0 / 128;
    for (const NamedMesh& each : surfaces_to_unwrap()) {
        const Unwrapped out = unwrapped_alone(each.mesh, {.method = GetParam(), .margin = apart});
        std::vector<std::pair<glm::dvec2, std::uint32_t>> points; // with their chart
        for (std::size_t f = 0; f < each.mesh.face_count(); ++f)
            for (std::size_t c = each.mesh.face_begin[f]; c < each.mesh.face_begin[f + 1]; ++c)
                points.emplace_back(out.uvs[0][c], out.chart[0][f]);
        const double least =
            2 * std::min(apart, 0.25 / std::sqrt(static_cast<double>(out.facts.charts)));
        std::ranges::sort(points, {}, [](const auto& p) { return p.first.x; });
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = a + 1; b < points.size(); ++b) {
                const glm::dvec2 way = glm::abs(points[b].first - points[a].first);
                if (way.x > least) break;
                if (points[a].second == points[b].second) continue;
                ASSERT_GE(std::max(way.x, way.y), least - 1e-6) << each.name;
            }
    }
}

TEST_P(EverySurface, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = bumpy_ball(64, 0.25);
    const Unwrapped many = unwrapped_alone(mesh, options());
    const ThreadLimit limit(1);
    EXPECT_EQ(unwrapped_alone(mesh, options()).uvs, many.uvs);
}

TEST_P(EverySurface, IsBentLittle)
{
    for (const NamedMesh& each : surfaces_to_unwrap()) {
        const UnwrapFacts facts = unwrapped_alone(each.mesh, options()).facts;
        EXPECT_LT(facts.angle, 1.5) << each.name;
        EXPECT_LT(facts.length, 2.5) << each.name;
    }
}

TEST(Unwrapping, CutsABoxIntoItsSides)
{
    const Unwrapped out = unwrapped_alone(box_mesh({1, 2, 3}, {3, 3, 3}));
    EXPECT_EQ(out.facts.charts, 6u);
    EXPECT_NEAR(out.facts.angle, 1, 1e-5);
    EXPECT_NEAR(out.facts.length, 1, 1e-5);
}

TEST(Unwrapping, NeverJoinsTwoMaterials)
{
    Mesh mesh = plane_mesh({1, 1}, {8, 8});
    mesh.face_material.assign(mesh.face_count(), 0);
    for (std::size_t f = 20; f < 40; ++f) mesh.face_material[f] = 1;
    const Unwrapped out = unwrapped_alone(mesh);
    std::set<std::pair<std::uint32_t, std::uint32_t>> charts;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        charts.emplace(out.chart[0][f], mesh.face_material[f]);
    EXPECT_EQ(charts.size(), out.facts.charts);
}

TEST(Unwrapping, GivesAllMeshesTheSameTexelsPerLength)
{
    const std::vector<UnwrapInput> both{{make_ref(plane_mesh({1, 1}, {4, 4})), 1},
                                        {make_ref(plane_mesh({1, 1}, {4, 4})), 3}};
    const Unwrapped out = unwrapped(both, {});
    std::vector<double> sides;
    for (std::size_t m = 0; m < 2; ++m) {
        const UvAreas areas = uv_areas(with_uvs(*both[m].mesh, out.uvs[m]));
        sides.push_back(std::sqrt(areas.of_texture / areas.of_surface));
    }
    EXPECT_NEAR(sides[1] / sides[0], 3, 1e-4);
}

TEST(Unwrapping, LeavesOutFacesThatUseAPointTwice)
{
    Mesh mesh = plane_mesh({1, 1}, {2, 2});
    add_face(mesh, std::vector<std::uint32_t>{0, 1, 0});
    const Unwrapped out = unwrapped_alone(mesh);
    EXPECT_EQ(out.facts.left_out, 1u);
    EXPECT_EQ(out.facts.charts, 1u);
}

TEST(Unwrapping, TakesTrianglesWithoutArea)
{
    Mesh mesh = plane_mesh({1, 1}, {6, 6});
    for (glm::vec3& p : mesh.positions) // two columns on one line
        if (p.x > 0.1f && p.x < 0.2f) p.x = 1.0f / 3;
    const Unwrapped out = unwrapped_alone(mesh);
    EXPECT_EQ(out.facts.left_out, 0u);
    EXPECT_LT(out.facts.length, 1.01);
}

TEST(Unwrapping, RefusesWhatHasNoFacesAndWhatIsNoNumber)
{
    EXPECT_THAT([] { unwrapped_alone(Mesh{}); }, ThrowsMessage<Rejected>(HasSubstr("no faces")));
    Mesh mesh = plane_mesh({1, 1}, {2, 2});
    mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT([&] { unwrapped_alone(mesh); }, ThrowsMessage<Rejected>(HasSubstr("no number")));
}

TEST(Unwrap, CanBeStoppedWhereverItIs)
{
    const Ref<Mesh> ball = make_ref(sphere_mesh(1, 96, 48));
    const UnwrapInput input{ball, 1};
    const Unwrapped whole = unwrapped({&input, 1}, {});
    std::size_t stopped = 0;
    bool ended = false;
    for (int at = 1; at < 40 && !ended; ++at) {
        int calls = 0;
        const Progress stops = [&](double fraction, std::string_view) {
            EXPECT_GE(fraction, 0);
            EXPECT_LE(fraction, 1);
            if (++calls == at) throw Cancelled();
        };
        try {
            const Unwrapped out = unwrapped({&input, 1}, {}, stops);
            EXPECT_EQ(out.uvs, whole.uvs);
            ended = true;
        } catch (const Cancelled&) {
            ++stopped;
        }
    }
    EXPECT_GE(stopped, 1u);
    EXPECT_TRUE(ended);
}

TEST(Unwrap, MayBeStoppedBeforeTheLastLook)
{
    // The input lives for as long as the work that was left needs it.
    for (int round = 0; round < 3; ++round) {
        const UnwrapInput input{make_ref(torus_mesh(1, 0.4, {60, 40})), 1};
        EXPECT_THROW(
            unwrapped({&input, 1}, {}, [](double, std::string_view) { throw Cancelled(); }),
            Cancelled);
    }
}

} // namespace
} // namespace trivar::testing
