// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/subdivide.h"
#include "tests/limit/cages.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

double size_of(const Mesh& mesh)
{
    return glm::length(bounding_box(mesh).size());
}

bool all_quads(const Mesh& mesh)
{
    return mesh.corners.size() == 4 * mesh.face_count();
}

// Where a corner of a face of a subdivided cage is on the charts: child k of a face is its k-th
// quarter.
ChartPlace place_of_corner(std::size_t face, int corner, int levels)
{
    glm::dvec2 uv = chart_corner(corner);
    for (int level = 0; level < levels; ++level, face /= 4)
        uv = (uv + chart_corner(static_cast<int>(face % 4))) / 2.0;
    return {static_cast<std::uint32_t>(face), uv};
}

TEST(LimitSurfaces, AreWhatSubdivisionConvergesTo)
{
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        constexpr int levels = 4;
        const Mesh fine = subdivide(cage.mesh, levels);
        const LimitSurface surface = limit_of(cage.mesh);
        const int below_chart = all_quads(cage.mesh) ? levels : levels - 1;
        double most_off = 0, most_turned = 0;
        for (std::size_t f = 0; f < fine.face_count(); ++f)
            for (int k = 0; k < 4; ++k) {
                const std::uint32_t v =
                    fine.corners[fine.face_begin[f] + static_cast<std::uint32_t>(k)];
                const ChartPlace at = place_of_corner(f, k, below_chart);
                const glm::dvec3 p(fine.positions[v]), n(fine.normals[v]);
                most_off = std::max(most_off, glm::distance(surface.position(at), p));
                // On a crease a mesh has one normal for both sides.
                const bool inside = at.uv.x > 0 && at.uv.x < 1 && at.uv.y > 0 && at.uv.y < 1;
                if (inside)
                    most_turned = std::max(most_turned, glm::distance(surface.normal(at), n));
            }
        EXPECT_LT(most_off, 2e-6 * size_of(cage.mesh));
        EXPECT_LT(most_turned, 1e-3);
    }
}

TEST(LimitSurfaces, HaveTheDerivativesOfTheirPoints)
{
    std::mt19937 random(1);
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitSurface surface = limit_of(cage.mesh);
        for (int k = 0; k < 200; ++k) {
            ChartPlace at = random_chart_place(surface, random);
            if (!surface.is_regular(at.chart)) continue;
            at.uv = 0.01 + 0.98 * at.uv;
            const LimitJet j = surface.jet(at);
            const SurfaceFrame frame = frame_of(j);
            constexpr double h = 1e-5;
            const auto slope = [&](auto&& value, const glm::dvec2& d) {
                const auto there = [&](double s) {
                    return value(surface.jet({at.chart, at.uv + s * d}));
                };
                return (there(h) - there(-h)) / (2 * h);
            };
            const auto point = [](const LimitJet& a) { return a.p; };
            const auto along_u = [](const LimitJet& a) { return a.u; };
            const auto along_v = [](const LimitJet& a) { return a.v; };
            const auto unit_normal = [](const LimitJet& a) { return frame_of(a).normal; };
            EXPECT_LT(glm::distance(j.u, slope(point, {1, 0})), 1e-8);
            EXPECT_LT(glm::distance(j.v, slope(point, {0, 1})), 1e-8);
            EXPECT_LT(glm::distance(j.uu, slope(along_u, {1, 0})), 1e-7);
            EXPECT_LT(glm::distance(j.uv, slope(along_u, {0, 1})), 1e-7);
            EXPECT_LT(glm::distance(j.vv, slope(along_v, {0, 1})), 1e-7);
            EXPECT_LT(glm::distance(frame.normal_u, slope(unit_normal, {1, 0})), 1e-6);
            EXPECT_LT(glm::distance(frame.normal_v, slope(unit_normal, {0, 1})), 1e-6);
        }
    }
}

TEST(LimitSurfaces, BendAwayFromTheirNormalsByTheCurvatureOfASphere)
{
    std::mt19937 random(2);
    const LimitSurface& sphere = limit_sphere();
    for (int k = 0; k < 500; ++k) {
        const ChartPlace at = random_chart_place(sphere, random);
        EXPECT_NEAR(glm::length(sphere.position(at)), 1, sphere.is_regular(at.chart) ? 2e-4 : 1e-3);
        if (!sphere.is_regular(at.chart)) continue;
        const SurfaceFrame frame = frame_of(sphere.jet(at));
        EXPECT_NEAR(frame.k1, -1, 0.1);
        EXPECT_NEAR(frame.k2, -1, 0.1);
        EXPECT_LT(glm::distance(frame.normal, glm::normalize(sphere.position(at))), 0.01);
    }
}

TEST(LimitSurfaces, MeetOverTheEdgesOfTheirCharts)
{
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitSurface surface = limit_of(cage.mesh);
        for (std::uint32_t c = 0; c < surface.net().size(); ++c)
            for (int e = 0; e < 4; ++e) {
                if (surface.net().across(c, e).chart == ChartNet::none) continue;
                for (const double t : {0.0, 0.125, 0.3, 0.5, 0.8, 1.0}) {
                    const ChartPlace here{c, on_edge(e, t)}, there = surface.net().beyond(here, e);
                    EXPECT_LT(glm::distance(surface.position(here), surface.position(there)),
                              1e-14 * size_of(cage.mesh));
                    if (surface.net().is_crease(c, e) || t == 0 || t == 1) continue;
                    EXPECT_LT(glm::distance(surface.normal(here), surface.normal(there)), 1e-6);
                }
            }
    }
}

TEST(LimitSurfaces, FollowTheirCageAsIfTheyWereMadeAnew)
{
    std::mt19937 random(3);
    std::normal_distribution<double> shift(0, 0.1);
    for (const NamedCage& each : all_cages()) {
        SCOPED_TRACE(each.name);
        Cage cage = cage_of(ready_to_subdivide(each.mesh));
        const LimitSurface before(cage);
        for (glm::dvec3& p : cage.points)
            p += glm::dvec3(shift(random), shift(random), shift(random));
        const LimitSurface moved = before.moved(cage.points), anew(cage);
        for (int k = 0; k < 50; ++k) {
            const ChartPlace at = random_chart_place(moved, random);
            EXPECT_EQ(moved.position(at), anew.position(at));
            EXPECT_EQ(moved.normal(at), anew.normal(at));
            EXPECT_NE(moved.position(at), before.position(at));
        }
    }
}

TEST(LimitSurfaces, OfAMirroredMeshAreMirroredAndShowTheirOutside)
{
    const Mesh mesh = ready_to_subdivide(tower_cage());
    const glm::dmat4 mirror(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    const LimitSurface here(cage_of(mesh)), there(cage_of(mesh, mirror));
    double sum = 0;
    for (std::uint32_t c = 0; c < there.net().size(); ++c) {
        const glm::dvec3 p = there.position({c, glm::dvec2(0.5)});
        sum += glm::dot(p - glm::dvec3(0, 0, 0.2), there.normal({c, glm::dvec2(0.5)}));
    }
    EXPECT_GT(sum, 0.3 * static_cast<double>(there.net().size()));
}

TEST(LimitSurfaces, OfTooManyFacesAreRefused)
{
    Cage cage;
    cage.points.resize(4);
    for (std::size_t f = 0; f <= most_charts; ++f) {
        cage.face_sizes.push_back(4);
        for (int k = 0; k < 4; ++k) cage.corners.push_back(k);
    }
    EXPECT_THROW(LimitSurface{cage}, Rejected);
}

} // namespace
} // namespace trivar::testing
