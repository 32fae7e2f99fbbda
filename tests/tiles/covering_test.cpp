// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "core/limit/facet_surface.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/primitives.h"
#include "core/mesh/teapot_patches.h"
#include "core/tiles/covered_tiles.h"
#include "tests/limit/cages.h"
#include "tests/support/fixtures.h"

#include <cstring>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <map>

namespace trivar::testing {
namespace {

// A tile of side 1 of cells by cells quads.
Mesh tile_of(int cells, double (*height)(double x, double y))
{
    Mesh mesh = plane_mesh({1, 1}, glm::ivec2(cells));
    for (glm::vec3& p : mesh.positions) p.z = static_cast<float>(height(p.x + 0.5, p.y + 0.5));
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

double level_height(double, double)
{
    return 0;
}
double bump_height(double x, double y)
{
    return 0.35 * std::sin(glm::pi<double>() * x) * std::sin(glm::pi<double>() * y);
}
double wave_height(double x, double y)
{
    return 0.3 + 0.1 * std::cos(glm::two_pi<double>() * x) +
           0.1 * std::cos(glm::two_pi<double>() * y);
}

struct WeldedCount {
    std::size_t open = 0, crowded = 0;
    long euler = 0;
};

// Vertices whose positions have the same bits are one; faces without area there are none.
WeldedCount welded(const Mesh& mesh)
{
    std::map<std::array<std::uint32_t, 3>, int> known;
    std::vector<int> point;
    for (const glm::vec3& p : mesh.positions) {
        std::array<std::uint32_t, 3> bits{};
        std::memcpy(bits.data(), &p, sizeof bits);
        point.push_back(known.try_emplace(bits, static_cast<int>(known.size())).first->second);
    }
    std::map<std::pair<int, int>, int> uses;
    long faces = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<int> corners;
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            if (const int p = point[mesh.corners[c]]; corners.empty() || corners.back() != p)
                corners.push_back(p);
        if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
        if (corners.size() < 3) continue;
        ++faces;
        for (std::size_t k = 0; k < corners.size(); ++k)
            ++uses[std::minmax(corners[k], corners[(k + 1) % corners.size()])];
    }
    WeldedCount out;
    for (const auto& [edge, count] : uses) {
        out.open += count == 1;
        out.crowded += count > 2;
    }
    out.euler = static_cast<long>(known.size()) - static_cast<long>(uses.size()) + faces;
    return out;
}

// The same of the charts, with `cells` cells along each side of each chart where they are `counts`.
WeldedCount of_the_base(const Covering& covering, const ChartNet& net, int tile_cells)
{
    WeldedCount out;
    std::map<std::pair<std::uint32_t, int>, int> edges; // by the side that comes first
    std::vector<char> used;
    for (std::uint32_t c = 0; c < net.size(); ++c)
        for (int e = 0; e < 4; ++e) {
            const std::uint32_t p = net.point(c, e);
            used.resize(std::max<std::size_t>(used.size(), p + 1), 0);
            used[p] = 1;
            const ChartNet::Side& other = net.across(c, e);
            if (other.chart == ChartNet::none && p == net.point(c, e + 1)) continue; // a pole
            edges[other.chart == ChartNet::none
                      ? std::pair(c, e)
                      : std::min(std::pair(c, e), std::pair(other.chart, other.edge))] = 1;
            if (other.chart != ChartNet::none) continue;
            const glm::ivec2 n = covering.nodes().counts(c) / 3;
            out.open += static_cast<std::size_t>(tile_cells * (e % 2 == 0 ? n.x : n.y));
        }
    out.euler = std::ranges::count(used, 1) - static_cast<long>(edges.size()) +
                static_cast<long>(net.size());
    return out;
}

CoveringPose pose_on(const Covering& covering, const ChartSurface& surface, double height)
{
    CoveringPose pose{covering.points(surface), {}, std::vector<char>(surface.net().size(), 0)};
    pose.heights.assign(pose.points.size(), height);
    return pose;
}

const CoverCell unit_cell{{-0.5, -0.5, 0}, {1, 1, 0.5}};

// At a pole a raised outline would stand on all tiles there.
void expect_no_gaps(const ChartSurface& surface, double size, bool poles = false)
{
    TileCover cover;
    cover.pattern = TilePattern::grid;
    const Covering covering(surface, cover, {size, size});
    CoveringPose pose = pose_on(covering, surface, size);
    constexpr int cells = 8;
    const WeldedCount truth = of_the_base(covering, surface.net(), cells);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> some(0.1, 1);
    for (const bool uneven : {false, true}) {
        if (uneven)
            for (double& each : pose.heights) each = size * some(random);
        for (const auto height : {level_height, bump_height, wave_height}) {
            if (poles && height == wave_height) continue;
            const Mesh tile = tile_of(cells, height);
            const WeldedCount count =
                welded(covered_tiles(tile, glm::dmat4(1), unit_cell, covering, pose));
            EXPECT_EQ(count.open, truth.open);
            EXPECT_EQ(count.crowded, 0u);
            EXPECT_EQ(count.euler, truth.euler);
        }
    }
}

TEST(Coverings, OfLimitSurfacesHaveNoGaps)
{
    for (const NamedCage& cage : all_cages())
        for (const double size : {0.5, 0.13}) {
            SCOPED_TRACE(cage.name);
            expect_no_gaps(limit_of(cage.mesh), size);
        }
}

class RealDataCoverings : public ::testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(RealDataCoverings, HaveNoGaps)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const auto [name, size] = GetParam();
    const Mesh mesh = *read_model(real_data_folder() + "/cages/" + name + ".obj").meshes.front();
    expect_no_gaps(limit_of(mesh), size * glm::length(bounding_box(mesh).size()));
}

INSTANTIATE_TEST_SUITE_P(
    RealData, RealDataCoverings,
    ::testing::Values(std::pair("catmark_torus", 0.05), std::pair("catmark_cube", 0.04),
                      std::pair("catmark_car", 0.02), std::pair("catmark_bishop", 0.02),
                      std::pair("catmark_nonquads", 0.05), std::pair("spot_control_mesh", 0.03)),
    [](const auto& each) { return each.param.first; });

TEST(Coverings, OfMeshesAsTheyAreHaveNoGaps)
{
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        expect_no_gaps(FacetSurface(cage_of(ready_to_subdivide(cage.mesh))), 0.2);
    }
    SCOPED_TRACE("sphere with poles");
    const FacetSurface sphere(cage_of(ready_to_subdivide(sphere_mesh(1, 12, 6))));
    EXPECT_EQ(sphere.net().size(), 72u);
    expect_no_gaps(sphere, 0.2, true);
}

// Newell's patches, joined where the control points along their edges agree.
class TeapotSurface final : public ChartSurface {
public:
    TeapotSurface() : net_(charts()) {}
    const ChartNet& net() const override { return net_; }
    glm::dvec3 position(const ChartPlace& at) const override { return jet(at).p; }
    glm::dvec3 normal(const ChartPlace& at) const override
    {
        const TilePoint here = jet(at),
                        inside = jet({at.chart, at.uv + 1e-3 * (glm::dvec2(0.5) - at.uv)});
        const glm::dvec3 n = glm::cross(here.x, here.y);
        return glm::normalize(glm::length(n) > 1e-9 ? n : glm::cross(inside.x, inside.y));
    }

private:
    static TilePatch patch(std::uint32_t c)
    {
        TilePatch out{};
        for (std::size_t k = 0; k < 16; ++k)
            out.p[k] = glm::dvec3(teapot_points[teapot_patches[c][k]]);
        return out;
    }
    static TilePoint jet(const ChartPlace& at) { return tile_point(patch(at.chart), {at.uv, 0}); }
    static std::vector<ChartNet::Chart> charts()
    {
        static constexpr std::array<std::array<std::size_t, 4>, 4> side{
            {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}}};
        const auto same = [](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::distance(a, b) < 1e-5;
        };
        std::vector<ChartNet::Chart> out(teapot_patches.size());
        std::vector<glm::dvec3> points;
        const auto control = [](std::size_t c, std::size_t e, std::size_t k) {
            return patch(static_cast<std::uint32_t>(c)).p[side[e][k]];
        };
        for (std::size_t c = 0; c < out.size(); ++c)
            for (std::size_t e = 0; e < 4; ++e) {
                const glm::dvec3 p = control(c, e, 0);
                const auto known =
                    std::ranges::find_if(points, [&](const auto& q) { return same(p, q); });
                out[c].points[e] = static_cast<std::uint32_t>(known - points.begin());
                if (known == points.end()) points.push_back(p);
            }
        for (std::size_t c = 0; c < out.size(); ++c)
            for (std::size_t e = 0; e < 4; ++e) {
                if (same(control(c, e, 0), control(c, e, 3))) continue; // a pole
                for (std::size_t d = 0; d < out.size(); ++d)
                    for (std::size_t h = 0; h < 4; ++h) {
                        bool one = std::pair(c, e) != std::pair(d, h);
                        for (std::size_t k = 0; k < 4; ++k)
                            one = one && same(control(c, e, k), control(d, h, 3 - k));
                        if (one)
                            out[c].across[e] = {static_cast<std::uint32_t>(d), static_cast<int>(h)};
                    }
            }
        return out;
    }
    ChartNet net_;
};

TEST(Coverings, OfTheTeapotsPatchesHaveNoGaps)
{
    const TeapotSurface teapot;
    TileCover cover;
    cover.pattern = TilePattern::grid;
    const Covering covering(teapot, cover, {0.25, 0.25});
    const CoveringPose pose = pose_on(covering, teapot, 0.1);
    const WeldedCount truth = of_the_base(covering, teapot.net(), 8);
    const WeldedCount count =
        welded(covered_tiles(tile_of(8, bump_height), glm::dmat4(1), unit_cell, covering, pose));
    EXPECT_EQ(count.open, truth.open);
    EXPECT_EQ(count.crowded, 0u);
    EXPECT_EQ(count.euler, truth.euler);
}

TEST(Coverings, OfRowsThatGoRoundHaveNoGapsWithBricksEither)
{
    const LimitSurface torus = limit_of(torus_cage());
    TileCover cover;
    cover.pattern = TilePattern::brick;
    const Covering covering(torus, cover, {0.2, 0.1});
    EXPECT_EQ(covering.tiles().size(), covering.cell_count());
    const CoveringPose pose = pose_on(covering, torus, 0.05);
    for (const auto height : {level_height, bump_height}) { // the outline is as high half a tile on
        const WeldedCount count =
            welded(covered_tiles(tile_of(8, height), glm::dmat4(1), unit_cell, covering, pose));
        EXPECT_EQ(count.open, 0u);
        EXPECT_EQ(count.crowded, 0u);
        EXPECT_EQ(count.euler, 0);
    }
}

// A hexagon of width 1 and length 4/3 with its middle raised, its sides cut in four.
Mesh hexagon_tile()
{
    const std::array<glm::dvec2, 6> corners{glm::dvec2(0, 1), {0, 1.0 / 3}, {0.5, 0},
                                            {1, 1.0 / 3},     {1, 1},       {0.5, 4.0 / 3}};
    Mesh mesh;
    mesh.positions.emplace_back(0.5f, 2.0f / 3, 0.3f);
    for (std::size_t k = 0; k < 6; ++k)
        for (int s = 0; s < 4; ++s)
            mesh.positions.emplace_back(
                glm::vec2(glm::mix(corners[k], corners[(k + 1) % 6], s / 4.0)), 0.1f);
    for (std::uint32_t k = 0; k < 24; ++k)
        add_face(mesh, std::array<std::uint32_t, 3>{0, 1 + k, 1 + (k + 1) % 24});
    return mesh;
}

TEST(Coverings, OfRowsThatGoRoundHaveNoGapsWithHexagonsEither)
{
    const LimitSurface torus = limit_of(torus_cage());
    TileCover cover;
    cover.pattern = TilePattern::hexagon;
    const Covering covering(torus, cover, {0.2, 0.2 * 4 / 3});
    const CoveringPose pose = pose_on(covering, torus, 0.05);
    const CoverCell cell{{0, 0, 0}, {1, 4.0 / 3, 0.3}};
    const WeldedCount count =
        welded(covered_tiles(hexagon_tile(), glm::dmat4(1), cell, covering, pose));
    EXPECT_EQ(count.open, 0u);
    EXPECT_EQ(count.crowded, 0u);
    EXPECT_EQ(count.euler, 0);
}

TEST(Coverings, LieOnTheirSurfaceAndAsHighAsTheyShould)
{
    const LimitSurface& sphere = limit_sphere();
    TileCover cover;
    cover.pattern = TilePattern::grid;
    const Covering covering(sphere, cover, {0.1, 0.1});
    const CoveringPose pose = pose_on(covering, sphere, 0.2);
    const Mesh tile = tile_of(4, wave_height);
    const Mesh all = covered_tiles(tile, glm::dmat4(1), unit_cell, covering, pose);
    for (std::size_t v = 0; v < all.positions.size(); ++v) {
        const double z = tile.positions[v % tile.positions.size()].z;
        EXPECT_NEAR(glm::length(all.positions[v]), 1 + 0.2 * z, 2e-3);
    }
}

// The normal of a vertex is that of the faces round it, as far as these are small.
TEST(Coverings, HaveTheNormalsOfTheirFaces)
{
    const LimitSurface torus = limit_of(torus_cage());
    for (const TilePattern pattern : {TilePattern::grid, TilePattern::brick}) {
        TileCover cover;
        cover.pattern = pattern;
        const Covering covering(torus, cover, {0.3, 0.2});
        CoveringPose pose = pose_on(covering, torus, 0.2);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> some(0.5, 1);
        if (pattern == TilePattern::grid) // bricks have a kink where heights do, in their middle
            for (double& each : pose.heights) each *= some(random);
        const Mesh all =
            covered_tiles(tile_of(64, bump_height), glm::dmat4(1), unit_cell, covering, pose);
        double most = 0;
        for (std::size_t f = 0; f < all.face_count(); f += 7) {
            const glm::dvec3 n = glm::normalize(area_normal(all, f));
            const std::uint32_t v = all.corners[all.face_begin[f]];
            most = std::max(most, glm::distance(n, glm::dvec3(all.normals[v])));
        }
        EXPECT_LT(most, 0.12);
    }
}

TEST(Coverings, CountTheSameAlongWholeChords)
{
    for (const NamedCage& cage : all_cages()) {
        const LimitSurface surface = limit_of(cage.mesh);
        TileCover cover;
        cover.pattern = TilePattern::brick;
        const Covering covering(surface, cover, {0.3, 0.15});
        const ChartNet& net = surface.net();
        for (std::uint32_t c = 0; c < net.size(); ++c)
            for (int e = 0; e < 4; ++e) {
                const auto along = [&](std::uint32_t chart, int edge) {
                    const glm::ivec2 n = covering.nodes().counts(chart) / 3;
                    return edge % 2 == 0 ? n.x : n.y;
                };
                EXPECT_EQ(along(c, e) % 2, 0);
                const ChartNet::Side& other = net.across(c, e);
                if (other.chart == ChartNet::none) continue;
                EXPECT_EQ(along(c, e), along(other.chart, other.edge));
            }
        // Bricks cover every cell once: two halves are a whole.
        double cells = 0;
        for (const Covering::Laid& tile : covering.tiles())
            cells +=
                tile.extent == Covering::Extent::whole || tile.extent == Covering::Extent::spanning
                    ? 1
                    : 0.5;
        EXPECT_EQ(cells, static_cast<double>(covering.cell_count()));
    }
}

TEST(Coverings, OfMirroredBasesShowTheirOutside)
{
    const Mesh mesh = ready_to_subdivide(cube_cage());
    const LimitSurface cube(cage_of(mesh));
    TileCover cover;
    cover.pattern = TilePattern::grid;
    const Covering covering(cube, cover, {0.3, 0.3});
    CoveringPose pose = pose_on(covering, cube, 0.1);
    for (SurfacePoint& point : pose.points) {
        point.p.x = -point.p.x;
        point.normal.x = -point.normal.x;
    }
    for (char& each : pose.mirrored) each = 1;
    for (std::uint32_t c = 0; c < covering.cell_count(); ++c)
        EXPECT_GT(fold_limit(upright_patch(covering, c, pose)), 0.05);
    const Mesh all =
        covered_tiles(tile_of(4, bump_height), glm::dmat4(1), unit_cell, covering, pose);
    for (std::size_t f = 0; f < all.face_count(); ++f) {
        const glm::dvec3 at(all.positions[all.corners[all.face_begin[f]]]);
        EXPECT_GT(glm::dot(area_normal(all, f), at), 0);
    }
}

TEST(Coverings, OfTooManyTilesAreRefused)
{
    TileCover cover;
    cover.pattern = TilePattern::grid;
    const LimitSurface torus = limit_of(torus_cage());
    EXPECT_THROW(Covering(torus, cover, {1e-9, 1e-9}), Rejected);
    EXPECT_THROW(Covering(torus, cover, {0, 0}), Rejected);
    cover.per_face = 1'000'000;
    EXPECT_THROW(Covering(torus, cover, {1, 1}), Rejected);
}

TEST(Coverings, AreTheSameForAnyNumberOfThreads)
{
    const LimitSurface torus = limit_of(torus_cage());
    TileCover cover;
    cover.pattern = TilePattern::brick;
    const Covering covering(torus, cover, {0.2, 0.1});
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return covered_tiles(tile_of(4, bump_height), glm::dmat4(1), unit_cell, covering,
                             pose_on(covering, torus, 0.1));
    };
    EXPECT_EQ(with(1), with(2));
}

} // namespace
} // namespace trivar::testing
