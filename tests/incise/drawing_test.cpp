// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/fill.h"
#include "core/incise/trace.h"
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// A tetrahedron: large triangles.
SlitSkin tetrahedron()
{
    Mesh mesh;
    mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (const std::array<std::uint32_t, 3>& f :
         {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
        add_face(mesh, f);
    return skin_of(mesh);
}

SlitDrawing drawing_of(const SlitSkin& skin, const std::vector<std::vector<SkinPlace>>& strokes)
{
    SlitDrawing drawing(skin);
    for (const std::vector<SkinPlace>& places : strokes) {
        Traced traced = trace(drawing, std::vector{StrokePart{places}});
        EXPECT_EQ(traced.refusal, "");
        drawing.add(traced.chains.at(0));
    }
    drawing.arrange();
    return drawing;
}

const std::vector<SkinPlace> rising{{0, {0.8, 0.1, 0.1}}, {0, {0.1, 0.45, 0.45}}};
const std::vector<SkinPlace> level{{0, {0.2, 0.7, 0.1}}, {0, {0.25, 0.1, 0.65}}};

TEST(CutDrawings, LinesThatCrossGetOnePointInCommon)
{
    const SlitSkin skin = tetrahedron();
    const SlitDrawing drawing = drawing_of(skin, {rising, level});
    std::map<std::uint32_t, int> ends;
    for (const SlitDrawing::Segment& g : drawing.segments()) {
        ++ends[g.a];
        ++ends[g.b];
    }
    int crossings = 0;
    for (const auto& [point, count] : ends) crossings += count == 4;
    EXPECT_EQ(crossings, 1);
}

TEST(CutDrawings, ALineThatIsDrawnAgainIsOneLine)
{
    const SlitSkin skin = tetrahedron();
    const SlitDrawing once = drawing_of(skin, {rising});
    const SlitDrawing twice = drawing_of(skin, {rising, {rising.rbegin(), rising.rend()}});
    EXPECT_EQ(once.point_count(), twice.point_count());
    EXPECT_EQ(2 * once.segments().size(), twice.segments().size());
}

TEST(CutDrawings, PiecesFillTheirTriangleAndHaveAllSegmentsAsEdges)
{
    const SlitSkin skin = tetrahedron();
    const SlitDrawing drawing = drawing_of(skin, {rising, level});
    double area = 0;
    KeyNumbers edges;
    for (const SkinTriangle& piece : filled(drawing, 0)) {
        const auto p = [&](std::size_t i) { return drawing.position(piece.points[i]); };
        const glm::dvec3 twice = glm::cross(p(1) - p(0), p(2) - p(0));
        EXPECT_GT(glm::dot(twice, skin.area_normal(0)), 0);
        area += glm::length(twice);
        for (std::size_t i = 0; i < 3; ++i)
            edges.number(pair_key(piece.points[i], piece.points[(i + 1) % 3]));
    }
    EXPECT_NEAR(area, glm::length(skin.area_normal(0)), 1e-12);
    for (const SlitDrawing::Segment& g : drawing.segments()) {
        EXPECT_TRUE(edges.contains(pair_key(g.a, g.b)));
        EXPECT_TRUE(edges.contains(pair_key(g.b, g.a)));
    }
}

TEST(CutDrawings, AStrokeGoesRoundACorner)
{
    const SlitSkin skin = tetrahedron();
    const SlitDrawing drawing =
        drawing_of(skin, {{{0, {0.3, 0.3, 0.4}}, {1, {0.3, 0.3, 0.4}}, {2, {0.3, 0.3, 0.4}}}});
    EXPECT_GE(drawing.segments().size(), 4u);
    EXPECT_EQ(drawing.touched().size(), 3u);
}

TEST(LatticePoints, AreTheSameFromEveryTriangleRoundThem)
{
    const SlitSkin skin = tetrahedron();
    for (std::uint32_t t = 0; t < 4; ++t)
        for (const glm::ivec2 w : {glm::ivec2(0, 0),
                                   {lattice_steps, 0},
                                   {0, lattice_steps},
                                   {300, 0},
                                   {0, 200},
                                   {400, lattice_steps - 400},
                                   {100, 200}}) {
            const LatticePoint p = lattice_point(skin, t, w);
            for (const std::uint32_t other : triangles_round(skin, p)) {
                const auto again = weights_in(skin, p, other);
                ASSERT_TRUE(again);
                EXPECT_EQ(lattice_point(skin, other, *again), p);
            }
        }
}

TEST(KeyMaps, KeepTheFirstNumberOfAKey)
{
    KeyNumbers map;
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_TRUE(map.number(std::uint64_t{i} << 32).second);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(map.find(std::uint64_t{i} << 32), i);
    EXPECT_EQ(map.insert(0, 5), std::pair(0u, false));
    EXPECT_FALSE(map.contains(1));
}

} // namespace
} // namespace trivar::testing
