// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/primitives.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/layout.h"
#include "core/tiles/strand_chart.h"
#include "core/tiles/strand_tile.h"
#include "tests/tiles/bases.h"

#include <cstring>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <map>

namespace trivar {
namespace {

using namespace testing;

// A rope of three strands in its unit cell, which turns by a third of a turn: its ends match but
// for rounding.
Mesh rope()
{
    constexpr int around = 24, along = 6;
    Mesh mesh;
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j < around; ++j) {
            const double x = static_cast<double>(i) / along,
                         a = glm::two_pi<double>() * j / around + x * glm::two_pi<double>() / 3,
                         r = 0.12 + 0.03 * std::cos(3 * glm::two_pi<double>() * j / around);
            mesh.positions.emplace_back(x, 0.5 + r * std::cos(a), 0.16 + r * std::sin(a));
        }
    const auto at = [](int i, int j) {
        return static_cast<std::uint32_t>(around * i + j % around);
    };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j)
            add_face(mesh, std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

std::size_t open_edges(const Mesh& mesh)
{
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;
    std::vector<std::uint32_t> corners;
    for (const glm::uvec3& t : triangles(mesh))
        for (int k = 0; k < 3; ++k) {
            std::array<std::uint32_t, 3> bits{};
            std::memcpy(bits.data(), &mesh.positions[t[k]], sizeof bits);
            corners.push_back(
                known.try_emplace(bits, static_cast<std::uint32_t>(known.size())).first->second);
        }
    const Adjacency adjacency(std::move(corners), known.size());
    std::size_t open = 0;
    for (std::size_t e = 0; e < adjacency.edge_count(); ++e) {
        EXPECT_LE(adjacency.sides(e).size(), 2u);
        open += adjacency.sides(e).size() == 1;
    }
    return open;
}

std::vector<PlacedTile> tiles_of(const TileBase& base, const StrandLayout& layout,
                                 const BasePose& pose)
{
    std::vector<StrandNodes> nodes;
    std::vector<double> heights;
    for (const StrandStation& station : layout.stations) {
        const StationChart chart = station_chart(base, nullptr, station, station.width);
        StrandNodes& there = nodes.emplace_back();
        for (std::size_t j = 0; j < 4; ++j)
            there[j] = posed(base, pose, chart.flat[j], chart.beyond[j]);
        heights.push_back(station.width * station.height);
    }
    std::vector<PlacedTile> out;
    for (std::size_t c = 0; c < layout.cells.size(); ++c)
        if (!layout.cells[c].gone) out.push_back({strand_patch(layout, c, nodes, heights, false)});
    return out;
}

// A base with a path on it that is all round it or not.
struct StrandCase {
    const char* name;
    Mesh mesh;
    std::vector<glm::dvec3> path; // about on it
};

Mesh saddle_mesh()
{
    Mesh mesh = plane_mesh({2, 2}, glm::ivec2(30));
    for (glm::vec3& p : mesh.positions) p.z = 0.5f * (p.x * p.x - p.y * p.y);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

std::vector<StrandCase> strand_cases()
{
    std::vector<StrandCase> all{{"ball", sphere_mesh(1, 96, 48), {}},
                                {"torus", torus_mesh(1, 0.4, {120, 48}), {}},
                                {"saddle", saddle_mesh(), {}}};
    for (int i = 0; i < 40; ++i) {
        const double t = i / 39.0, a = 5.5 * t;
        const glm::dvec3 p(std::cos(a), std::sin(a), 0.8 * std::sin(3 * t));
        all[0].path.push_back(glm::normalize(p));
        all[1].path.emplace_back((1 + 0.4 * std::cos(4 * t)) * std::cos(a),
                                 (1 + 0.4 * std::cos(4 * t)) * std::sin(a), 0.4 * std::sin(4 * t));
        const double x = 1.4 * (t - 0.5), y = 0.5 * std::sin(6 * t);
        all[2].path.emplace_back(x, y, 0.5 * (x * x - y * y));
    }
    return all;
}

TileStroke strand_over(const TileBase& base, const std::vector<glm::dvec3>& path)
{
    TileStroke stroke;
    stroke.brush = TileBrush::strand;
    stroke.size = 0.2;
    for (const glm::dvec3& p : path) { // the normal of the nearest point
        double least = 1e300;
        SurfacePoint nearest;
        for (std::uint32_t t = 0; t < base.triangle_count(); ++t) {
            const SurfacePlace middle{t, glm::dvec3(1.0 / 3)};
            const double away = glm::distance(base.position(middle), p);
            if (away < least) least = away, nearest = {p, base.normal(middle)};
        }
        stroke.samples.push_back({nearest, 0.1 * static_cast<double>(stroke.samples.size()), 1});
    }
    return stroke;
}

TileLayout laid(const TileBase& base, std::vector<TileStroke> strokes)
{
    std::vector<Ref<TileStroke>> all;
    for (TileStroke& each : strokes) all.push_back(make_ref(std::move(each)));
    return layout_of(base, all);
}

constexpr std::size_t ends = 2 * 24; // edges of the two ends of the rope

TEST(Strands, WeldToOneBodyWithOpenEndsAlone)
{
    const StrandTile tile = strand_tile(rope());
    EXPECT_EQ(tile.unmatched, 0);
    for (const StrandCase& each : strand_cases()) {
        SCOPED_TRACE(each.name);
        const TileBase base = base_of(each.mesh);
        const TileLayout layout = laid(base, {strand_over(base, each.path)});
        EXPECT_GT(layout.strands.cells.size(), 6u);
        EXPECT_EQ(layout.lost, 0);
        BasePose pose = at_rest(base);
        EXPECT_EQ(open_edges(strand_mesh(tile.mesh, tiles_of(base, layout.strands, pose))), ends);
        for (glm::dvec3& p : pose.points) // bent and turned
            p = {p.x * std::cos(p.z) - p.y * std::sin(p.z), p.x * std::sin(p.z) + p.y, 2 * p.z};
        EXPECT_EQ(open_edges(strand_mesh(tile.mesh, tiles_of(base, layout.strands, pose))), ends);
    }
}

TEST(Strands, CloseWhereTheyEndNearTheirBeginning)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {120, 48}));
    std::vector<glm::dvec3> round;
    for (int i = 0; i < 50; ++i)
        round.emplace_back(1.4 * std::cos(0.127 * i), 1.4 * std::sin(0.127 * i), 0);
    const TileLayout layout = laid(base, {strand_over(base, round)});
    EXPECT_EQ(layout.strands.cells.size() % 2, 0u);
    const Mesh mesh =
        strand_mesh(strand_tile(rope()).mesh, tiles_of(base, layout.strands, at_rest(base)));
    EXPECT_EQ(open_edges(mesh), 0u);
    TileStroke apart = strand_over(base, round);
    apart.apart = true;
    EXPECT_EQ(open_edges(strand_mesh(strand_tile(rope()).mesh,
                                     tiles_of(base, laid(base, {apart}).strands, at_rest(base)))),
              ends);
}

TEST(Strands, GoOnFromTheEndsOfOthers)
{
    const TileBase base = base_of(sphere_mesh(1, 96, 48));
    const auto arc = [&](double from, double to, double z) {
        std::vector<glm::dvec3> path;
        for (int i = 0; i <= 20; ++i) {
            const double a = glm::mix(from, to, i / 20.0);
            path.push_back(glm::normalize(glm::dvec3(std::cos(a), std::sin(a), z * i / 20.0)));
        }
        return strand_over(base, path);
    };
    const Mesh unit = strand_tile(rope()).mesh;
    const auto open = [&](const std::vector<TileStroke>& strokes) {
        return open_edges(
            strand_mesh(unit, tiles_of(base, laid(base, strokes).strands, at_rest(base))));
    };
    EXPECT_EQ(open({arc(0, 1.2, 0), arc(1.27, 2.4, 0.5)}), ends);              // from its end
    EXPECT_EQ(open({arc(0, 1.2, 0), arc(2.4, 1.27, 0)}), ends);                // turned round
    EXPECT_EQ(open({arc(0, 1.2, 0), arc(2, 3, 0), arc(1.27, 1.93, 0)}), ends); // between two
    EXPECT_EQ(open({arc(0, 1.2, 0), arc(1.4, 2.4, 0)}), 2 * ends);             // too far away
    const StrandLayout both = laid(base, {arc(0, 1.2, 0), arc(1.27, 2.4, 0.5)}).strands;
    std::size_t joined = 0;
    for (std::size_t c = 0; c < both.cells.size(); ++c) {
        const StrandCell& cell = both.cells[c];
        if (cell.behind < 0) continue;
        const StrandCell& next = both.cells[static_cast<std::size_t>(cell.behind)];
        EXPECT_EQ(next.before, static_cast<int>(c));
        EXPECT_EQ(next.number, cell.number + 1);
        EXPECT_EQ(cell.stations[3], next.stations[0]);
        joined += cell.stroke != next.stroke;
    }
    EXPECT_EQ(joined, 1u);
}

TEST(Strands, HaveCellsOfEqualLengthNearTheirSize)
{
    const TileBase base = base_of(sphere_mesh(1, 96, 48));
    const StrandCase ball = strand_cases()[0];
    const StrandLayout strands = laid(base, {strand_over(base, ball.path)}).strands;
    for (const StrandCell& cell : strands.cells) {
        EXPECT_NEAR(cell.length, 0.2, 0.02);
        double along = 0;
        for (std::size_t k = 1; k < 4; ++k)
            along += glm::distance(base.position(strands.stations[cell.stations[k]].at),
                                   base.position(strands.stations[cell.stations[k - 1]].at));
        EXPECT_NEAR(along, cell.length, 0.005 * cell.length);
    }
}

TEST(Strands, GoOnInTheSameDirectionWhereTilesMeet)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {120, 48}));
    const StrandLayout strands = laid(base, {strand_over(base, strand_cases()[1].path)}).strands;
    const std::vector<PlacedTile> tiles = tiles_of(base, strands, at_rest(base));
    for (std::size_t k = 1; k < tiles.size(); ++k)
        for (const double y : {0.0, 0.3, 1.0}) {
            const TilePoint a = tile_point(tiles[k - 1].patch, {1, y, 0.1}),
                            b = tile_point(tiles[k].patch, {0, y, 0.1});
            EXPECT_EQ(a.p, b.p);
            EXPECT_LT(glm::distance(a.x, b.x), 1e-12);
        }
}

TEST(Strands, ChangeNearAnEditedSampleAlone)
{
    const TileBase base = base_of(plane_mesh({4, 4}, {8, 8}));
    TileStroke stroke;
    stroke.brush = TileBrush::strand;
    stroke.size = 0.1;
    for (int i = 0; i <= 20; ++i)
        stroke.samples.push_back({{{-1.5 + 0.15 * i, 0, 0}, {0, 0, 1}}, 0.1 * i, 1});
    TileStroke edited = stroke;
    edited.samples[15].at.p.y = 0.05;
    const StrandLayout before = laid(base, {stroke}).strands, after = laid(base, {edited}).strands;
    ASSERT_EQ(before.cells.size(), after.cells.size());
    double most = 0;
    for (std::size_t s = 0; s < before.stations.size(); ++s) {
        const glm::dvec3 p = base.position(before.stations[s].at),
                         q = base.position(after.stations[s].at);
        // Elsewhere cells only share the length that came to it.
        if (std::abs(p.x - 0.75) > 0.5) {
            EXPECT_LT(glm::distance(p, q), 0.02);
            EXPECT_LT(std::abs(p.y - q.y), 1e-9);
        }
        most = std::max(most, std::abs(q.y));
    }
    EXPECT_GT(most, 0.03);
}

TEST(Strands, AreTheSameForAnyNumberOfThreads)
{
    const TileBase base = base_of(sphere_mesh(1, 96, 48));
    const TileStroke stroke = strand_over(base, strand_cases()[0].path);
    const Mesh unit = strand_tile(rope()).mesh;
    const auto made = [&] {
        return strand_mesh(unit, tiles_of(base, laid(base, {stroke}).strands, at_rest(base)))
            .positions;
    };
    std::vector<glm::vec3> one;
    {
        const ThreadLimit limit(1);
        one = made();
    }
    const ThreadLimit limit(2);
    EXPECT_EQ(one, made());
}

TEST(Strands, TooShortOnesAreCounted)
{
    const TileBase base = base_of(sphere_mesh(1, 96, 48));
    TileStroke stroke = strand_over(base, {{1, 0, 0}});
    EXPECT_EQ(laid(base, {stroke}).strands.too_short, 1);
    stroke.samples.push_back(stroke.samples.front()); // of no length
    EXPECT_EQ(laid(base, {stroke}).strands.too_short, 1);
    for (TileSample& each : stroke.samples) each.at.p *= 10; // off the surface
    const TileLayout off = laid(base, {stroke});
    EXPECT_EQ(off.lost, 2);
    EXPECT_TRUE(off.strands.cells.empty());
}

TEST(Strands, AreErasedAndChangedByBrushes)
{
    const TileBase base = base_of(sphere_mesh(1, 96, 48));
    const TileStroke stroke = strand_over(base, strand_cases()[0].path);
    TileStroke change = stroke;
    change.samples = {stroke.samples[20]};
    change.radius = 0.3;
    change.brush = TileBrush::erase;
    const Mesh unit = strand_tile(rope()).mesh;
    EXPECT_EQ(open_edges(strand_mesh(
                  unit, tiles_of(base, laid(base, {stroke, change}).strands, at_rest(base)))),
              2 * ends);
    change.brush = TileBrush::resize;
    const auto wider = laid(base, {stroke, change});
    EXPECT_EQ(open_edges(strand_mesh(unit, tiles_of(base, wider.strands, at_rest(base)))), ends);
    double least = 1e300, most = 0;
    for (const StrandStation& each : wider.strands.stations)
        least = std::min(least, each.width), most = std::max(most, each.width);
    EXPECT_GT(most, 1.3 * least);
}

TEST(Strands, GrowAlongTheirPath)
{
    StrandCell cell;
    cell.begin_s = 2;
    cell.end_s = 4;
    EXPECT_FALSE(grown(cell, 0.1, 10).has_value());
    EXPECT_EQ(*grown(cell, 0.3, 10), glm::dvec2(0, 0.5));
    EXPECT_EQ(*grown(cell, 0.5, 10), glm::dvec2(0, 1));
    std::swap(cell.begin_s, cell.end_s); // of a stroke that was turned round
    EXPECT_EQ(*grown(cell, 0.3, 10), glm::dvec2(0.5, 1));
}

TEST(Strands, TellWhereTheEndsOfATileDoNotMatch)
{
    Mesh mesh = rope();
    for (std::size_t v = 0; v < 24; ++v) mesh.positions[v].z += 0.05f; // the first end
    EXPECT_GT(strand_tile(std::move(mesh)).unmatched, 40);
    EXPECT_EQ(strand_tile(sphere_mesh(0.5, 12, 6)).unmatched, 0); // a closed body has no ends
}

} // namespace
} // namespace trivar
