// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/field_surface.h"

#include "core/base/parallel.h"
#include "core/meshing/parted_cells.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/field_fit.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

struct Body {
    SimplexField field;
    std::vector<bool> inside; // by cell: x > 0
};

// A fit in a cube of side 2 that is cut at x = 0.
Body fitted(const std::function<double(const glm::dvec3&)>& f)
{
    PartedCells cells{box_cells(glm::dvec3(2), glm::ivec3(2)), {}};
    for (const auto& cell : cells.mesh.cells) {
        double x = 0;
        for (const int v : cell) x += cells.mesh.vertices[static_cast<std::size_t>(v)].x;
        cells.inside.push_back(x > 0);
    }
    const auto basis = make_ref(SimplexBasis<3>(
        with_clouds<3>(cells.mesh.vertices, cells.mesh.cells, 2, {}, cuts_between(cells, 2))));
    std::vector<FieldSample> samples;
    for (int i = 0; i < 4096; ++i) {
        const glm::dvec3 at = (glm::dvec3(i % 16, i / 16 % 16, i / 256) + 0.5) / 8.0 - 1.0;
        samples.push_back({at, f(at)});
    }
    return {fitted_field(basis, samples).field, cells.inside};
}

// How many edges have not as many triangles on one side as on the other.
int open_edges(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.point(mesh.corners[3 * f + i]),
                                b = mesh.point(mesh.corners[3 * f + (i + 1) % 3]);
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    int out = 0;
    for (const auto& [edge, count] : edges) out += count != 0 ? 1 : 0;
    return out;
}

double volume(const Mesh& mesh)
{
    double out = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto at = [&](std::size_t i) {
            return glm::dvec3(mesh.positions[mesh.corners[3 * f + i]]);
        };
        out += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    return out;
}

TEST(FieldSurface, LiesOnTheFunctionAndHasItsNormals)
{
    const Body ball = fitted([](const glm::dvec3& p) { return 1 - glm::dot(p, p); });
    const Mesh mesh = field_surface(ball.field, ball.inside, 0.53, 8);
    EXPECT_EQ(open_edges(mesh), 0);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(mesh.positions[v]), std::sqrt(0.47), 1e-6);
        EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(mesh.positions[v])), 1 - 1e-6);
    }
    EXPECT_NEAR(volume(mesh), 4.18879 * std::pow(0.47, 1.5), 0.03);
}

TEST(FieldSurface, HasTheCutsAtWhichItJumpsAndTheBorder)
{
    const Body half = fitted([](const glm::dvec3& p) { return p.x > 0 ? 1 : 0; });
    const Mesh mesh = field_surface(half.field, half.inside, 0.5, 3);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_NEAR(volume(mesh), 4, 1e-6);
    const Mesh other = field_surface(half.field, half.inside, -0.5, 3);
    EXPECT_EQ(open_edges(other), 0);
    EXPECT_NEAR(volume(other), 8, 1e-6);
    EXPECT_EQ(field_surface(half.field, half.inside, 1.5, 3).face_count(), 0U);
}

TEST(FieldSurface, IsClosedWhereTheLevelCrossesACut)
{
    const Body steps = fitted([](const glm::dvec3& p) { return p.x > 0 ? p.z : p.y + 0.3; });
    const Mesh mesh = field_surface(steps.field, steps.inside, 0.05, 4);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_NEAR(volume(mesh), 2 * 0.95 + 2 * 1.25, 1e-5);
    const ThreadLimit more(7);
    EXPECT_EQ(field_surface(steps.field, steps.inside, 0.05, 4), mesh);
}

} // namespace
} // namespace trivar
