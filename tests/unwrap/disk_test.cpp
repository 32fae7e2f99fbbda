// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/disk.h"

#include "core/unwrap/uv_stretch.h"

#include <cmath>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// A grid of n by n quads, cut into triangles, whose points are where place(u, v) says.
Disk grid_disk(int n, auto&& place)
{
    Disk disk;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) disk.points.push_back(place(double(i) / n, double(j) / n));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            disk.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            disk.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return disk;
}

struct Stretches {
    double angle = 1, length = 1; // the largest factors, of lengths beside the usual one
    double mean = 0;              // square of what lengths are off by
};
Stretches stretches(const Disk& disk, const std::vector<glm::dvec2>& map)
{
    std::vector<UvStretch> all;
    std::vector<double> areas;
    double flat = 0, bent = 0;
    for (const glm::uvec3& t : disk.triangles) {
        const std::array p{disk.points[t.x], disk.points[t.y], disk.points[t.z]};
        all.push_back(uv_stretch(p, {map[t.x], map[t.y], map[t.z]}));
        areas.push_back(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2);
        flat += areas.back() * all.back().area();
        bent += areas.back();
    }
    Stretches out;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const double most = all[k].most / std::sqrt(flat / bent),
                     least = all[k].least / std::sqrt(flat / bent);
        out.angle = std::max(out.angle, all[k].angle());
        out.length = std::max({out.length, most, 1 / least});
        out.mean += areas[k] / bent * (std::pow(most - 1, 2) + std::pow(least - 1, 2));
    }
    return out;
}

glm::dvec3 on_cylinder(double u, double v)
{
    return {std::cos(3 * u), std::sin(3 * u), 2 * v};
}
glm::dvec3 on_cone(double u, double v)
{
    const double r = 1 + v;
    return {r * std::cos(2 * u), r * std::sin(2 * u), 1.5 * r};
}
glm::dvec3 on_cap(double u, double v)
{
    const glm::dvec2 p = 1.4 * glm::dvec2(u - 0.5, v - 0.5);
    return {p.x, p.y, std::sqrt(1 - p.x * p.x - p.y * p.y)};
}

TEST(ConformalMap, UnrollsWhatCanBeUnrolled)
{
    // A strip of flat quads along u unrolls exactly, whatever the angles between them.
    const Disk roof = grid_disk(16, [](double u, double v) {
        return glm::dvec3(on_cylinder(u, 0).x, on_cylinder(u, 0).y, 2 * v);
    });
    const auto [angle, length, mean] = stretches(roof, conformal_map(roof));
    EXPECT_NEAR(angle, 1, 1e-6);
    EXPECT_NEAR(length, 1, 1e-6);
    EXPECT_FALSE(is_folded(roof, conformal_map(roof)));
}

TEST(ConformalMap, UnrollsACone)
{
    // The quads of a cone are flat too, and their sides meet in its tip.
    const Disk cone = grid_disk(24, on_cone);
    const auto [angle, length, mean] = stretches(cone, conformal_map(cone));
    EXPECT_NEAR(angle, 1, 1e-6);
    EXPECT_NEAR(length, 1, 1e-6);
}

TEST(ConformalMap, KeepsAnglesBetterTheFinerTheMesh)
{
    double before = 10;
    for (const int n : {8, 16, 32}) {
        const Disk cap = grid_disk(n, on_cap);
        const double off = stretches(cap, conformal_map(cap)).angle - 1;
        EXPECT_LT(off, 0.75 * before) << n;
        before = off;
    }
}

TEST(RigidMap, StretchesLessThanTheConformalOne)
{
    const Disk cap = grid_disk(24, on_cap);
    const std::vector<glm::dvec2> conformal = conformal_map(cap);
    const std::vector<glm::dvec2> rigid = rigid_map(cap, conformal, 30);
    EXPECT_FALSE(is_folded(cap, rigid));
    EXPECT_LT(stretches(cap, rigid).mean, 0.5 * stretches(cap, conformal).mean);
    EXPECT_GT(stretches(cap, rigid).angle, stretches(cap, conformal).angle);
}

TEST(RigidMap, LeavesWhatIsFlatAsItIs)
{
    const Disk flat = grid_disk(6, [](double u, double v) { return glm::dvec3(2 * u, v, 0); });
    std::vector<glm::dvec2> start;
    for (const glm::dvec3& p : flat.points) start.emplace_back(p);
    const std::vector<glm::dvec2> map = rigid_map(flat, start, 5);
    for (std::size_t p = 0; p < map.size(); ++p) EXPECT_LT(glm::distance(map[p], start[p]), 1e-12);
}

TEST(CircleMap, TurnsNoTriangleOver)
{
    // A star of one face, which is far from convex
    Disk star;
    for (int k = 0; k < 10; ++k) {
        const double r = k % 2 ? 0.2 : 1, angle = 0.628318 * k;
        star.points.push_back({r * std::cos(angle), r * std::sin(angle), 0.5 * (k % 3)});
    }
    for (std::uint32_t k = 1; k + 1 < 10; ++k) star.triangles.emplace_back(0, k, k + 1);
    EXPECT_FALSE(is_folded(star, circle_map(star)));
}

TEST(FoldedMaps, AreFound)
{
    const Disk flat = grid_disk(4, [](double u, double v) { return glm::dvec3(u, v, 0); });
    std::vector<glm::dvec2> map;
    for (const glm::dvec3& p : flat.points) map.emplace_back(p);
    EXPECT_FALSE(is_folded(flat, map));
    map[12] += glm::dvec2(0.4, 0); // beyond its neighbours
    EXPECT_TRUE(is_folded(flat, map));

    // A band that goes round more than once lies over itself, though no triangle is turned over.
    const Disk spiral = grid_disk(40, [](double u, double v) { return glm::dvec3(u, v, 0); });
    map.clear();
    for (const glm::dvec3& p : spiral.points)
        map.push_back((2 - p.y) * glm::dvec2(std::cos(7 * p.x), std::sin(7 * p.x)));
    EXPECT_TRUE(is_folded(spiral, map));
}

TEST(UvStretch, IsWhatAMatrixDoes)
{
    const std::array<glm::dvec3, 3> triangle{glm::dvec3(0, 0, 1), {2, 0, 1}, {0, 1, 1}};
    const UvStretch s = uv_stretch(triangle, {glm::dvec2(0, 0), {0, 6}, {0.5, 0}});
    EXPECT_NEAR(s.most, 3, 1e-14);
    EXPECT_NEAR(s.least, 0.5, 1e-14);
    EXPECT_TRUE(s.turned);
    EXPECT_NEAR(s.angle(), 6, 1e-13);
    EXPECT_NEAR(s.area(), 1.5, 1e-14);
}

} // namespace
} // namespace trivar::testing
