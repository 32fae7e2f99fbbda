// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "core/split/sever.h"
#include "tests/split/bodies.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>
#include <set>

// Cuts along faces, edges and corners of what they cut.

namespace trivar::testing {
namespace {

double skin_area(const Mesh& mesh)
{
    double twice = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) twice += glm::length(area_normal(mesh, f));
    return twice / 2;
}

Mesh carried(Mesh mesh, const glm::dmat4& matrix)
{
    return transformed(mesh, matrix);
}

// A body of unit cubes, by their places in a grid.
struct Cubes {
    std::set<std::array<int, 3>> cells;

    // Its outer faces, of all cubes or of those on one side of x = level.
    Mesh skin() const
    {
        Mesh out;
        for (const auto& cell : cells)
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (const int way : {-1, 1}) {
                    std::array<int, 3> beside = cell;
                    beside[axis] += way;
                    if (cells.contains(beside)) continue;
                    std::array<std::uint32_t, 4> face;
                    for (std::uint32_t k = 0; k < 4; ++k) {
                        std::array<int, 3> at = cell;
                        at[axis] += way > 0;
                        const std::uint32_t turn = way > 0 ? k : 3 - k;
                        at[(axis + 1) % 3] += turn == 1 || turn == 2;
                        at[(axis + 2) % 3] += turn >= 2;
                        face[k] = static_cast<std::uint32_t>(out.vertex_count());
                        out.positions.emplace_back(at[0], at[1], at[2]);
                    }
                    add_face(out, face);
                }
        return welded(out);
    }
    Cubes on_side(int level, bool above) const
    {
        Cubes out;
        for (const auto& cell : cells)
            if ((cell[0] >= level) == above) out.cells.insert(cell);
        return out;
    }
};

Cubes random_cubes(std::mt19937& random, int size, double share)
{
    std::bernoulli_distribution has(share);
    Cubes out;
    for (int x = 0; x < size; ++x)
        for (int y = 0; y < size; ++y)
            for (int z = 0; z < size; ++z)
                if (has(random)) out.cells.insert({x, y, z});
    return out;
}

std::optional<Severed> halves_of(const Mesh& mesh, const PlainCut& cut, Unsevered* where = nullptr,
                                 const glm::dmat4& to_own = glm::dmat4(1))
{
    Unsevered unsevered;
    const std::optional<Severed> out = sever(mesh, CutSheet(cut, to_own), {}, unsevered);
    if (where) *where = unsevered;
    return out;
}

// Expects as many faces to run along every edge one way as the other.
void expect_even(const Mesh& mesh)
{
    EXPECT_EQ(closedness(mesh).unequal, 0u);
}

TEST(FacesOnCut, GiveTheHalvesOfAnyBodyOfCubesTheirOwnFacesAndOneCap)
{
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
        const Cubes body = random_cubes(random, 4, round % 2 == 0 ? 0.85 : 0.5);
        const Mesh mesh = body.skin();
        for (int level = 0; level <= 4; ++level) {
            const Cubes below = body.on_side(level, false), above = body.on_side(level, true);
            Unsevered where;
            const auto made =
                halves_of(mesh, {.point = {level, 0, 0}, .normal = {1, 0, 0}}, &where);
            ASSERT_EQ(made.has_value(), !below.cells.empty() && !above.cells.empty());
            if (!made) {
                EXPECT_EQ(where.above, below.cells.empty());
                continue;
            }
            EXPECT_EQ(made->fans + made->open + made->gaps, 0u);
            for (const bool up : {false, true}) {
                const Mesh& half = made->halves[up ? 1 : 0];
                const Cubes& right = up ? above : below;
                expect_even(half);
                EXPECT_NEAR(volume(half), static_cast<double>(right.cells.size()), 1e-9);
                EXPECT_NEAR(skin_area(half), skin_area(right.skin()), 1e-5);
            }
        }
    }
}

TEST(FacesOnCut, HoldForAnySizeTurnAndPlaceUpToRounding)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const double size : {1e-6, 1e-3, 1.0, 1e2, 1e4, 1e7})
        for (int round = 0; round < 12; ++round) {
            const Cubes body = random_cubes(random, 3, 0.7);
            const glm::dquat turn = glm::normalize(
                glm::dquat(uniform(random), uniform(random), uniform(random), uniform(random)));
            const glm::dvec3 at = 30 * size * glm::dvec3(uniform(random), uniform(random), 0);
            const glm::dmat4 matrix = glm::translate(glm::dmat4(1), at) * glm::mat4_cast(turn) *
                                      glm::scale(glm::dmat4(1), glm::dvec3(size));
            const Mesh mesh = carried(body.skin(), matrix);
            for (int level = 0; level <= 3; ++level) {
                const auto made = halves_of(mesh, {.point = matrix * glm::dvec4(level, 0.3, 0.7, 1),
                                                   .normal = turn * glm::dvec3(1, 0, 0)});
                const Cubes below = body.on_side(level, false), above = body.on_side(level, true);
                ASSERT_EQ(made.has_value(), !below.cells.empty() && !above.cells.empty());
                if (!made) continue;
                for (const bool up : {false, true}) {
                    const Mesh& half = made->halves[up ? 1 : 0];
                    const Cubes& right = up ? above : below;
                    expect_even(half);
                    const auto cells = static_cast<double>(right.cells.size());
                    EXPECT_NEAR(volume(half) / std::pow(size, 3), cells, 1e-3 * cells);
                    EXPECT_NEAR(skin_area(half) / size / size, skin_area(right.skin()), 0.02);
                }
            }
        }
}

TEST(FacesOnCut, LeaveWholeWhatTheCutOnlyTouches)
{
    const Mesh box = welded(box_mesh({1, 1, 1}, {2, 3, 1}));
    const Mesh tip = bar([](double s) { return glm::dvec3(0, 0, s); }, 0.2);
    struct Touch {
        Mesh mesh;
        PlainCut cut;
        bool above;
    };
    const std::vector<Touch> touches{
        {box, {.point = {0, 0, 0.5}, .normal = {0, 0, 1}}, false},
        {box, {.point = {0, 0, -0.5}, .normal = {0, 0, 1}}, true},
        {box, {.point = {0.5, 0, 0.5}, .normal = {1, 0, 1}}, false},     // an edge
        {box, {.point = {-0.5, 0.5, 0.5}, .normal = {1, -1, -1}}, true}, // a corner
        {welded(cylinder_mesh(0.5, 2, 48, 3)), {.point = {0, 0, 1}}, false},
        {ball({0, 0, 0}, 1, 24), {.point = {0, 0, -1}}, true},
        {tip, {.point = {0, 0, 1}}, false},
    };
    for (const Touch& touch : touches) {
        Unsevered where;
        EXPECT_FALSE(halves_of(touch.mesh, touch.cut, &where));
        EXPECT_EQ(where.above, touch.above);
        EXPECT_TRUE(where.touched);
    }
}

TEST(FacesOnCut, ACutThatIsMadeTwiceCutsOnce)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 30; ++round) {
        const PlainCut cut{.point = 0.2 * glm::dvec3(uniform(random), uniform(random), 0),
                           .normal = {uniform(random), uniform(random), uniform(random)}};
        for (const Mesh& body : {ball({0, 0, 0}, 1, 24), welded(box_mesh({1, 2, 1}, {2, 2, 2})),
                                 welded(torus_mesh(1, 0.4, {40, 20}))}) {
            const std::optional<Severed> made = halves_of(body, cut);
            ASSERT_TRUE(made);
            for (const bool up : {false, true}) {
                Unsevered where;
                EXPECT_FALSE(halves_of(made->halves[up ? 1 : 0], cut, &where));
                EXPECT_EQ(where.above, up);
            }
        }
    }
}

TEST(FacesOnCut, CornersAFewUnitsInTheLastPlaceApartAreOne)
{
    std::mt19937 random(6);
    const Mesh box = welded(box_mesh({1, 1, 1}, {3, 3, 3}));
    for (int round = 0; round < 20; ++round) {
        Mesh soup; // each face has corners of its own
        for (std::size_t f = 0; f < box.face_count(); ++f) {
            std::vector<std::uint32_t> corners;
            for (std::uint32_t c = box.face_begin[f]; c < box.face_begin[f + 1]; ++c) {
                corners.push_back(static_cast<std::uint32_t>(soup.vertex_count()));
                glm::vec3 p = box.positions[box.corners[c]];
                for (int i = 0; i < 3; ++i)
                    if (random() % 4 == 0) p[i] = std::nextafter(p[i], random() % 2 ? 9.0f : -9.0f);
                soup.positions.push_back(p);
            }
            add_face(soup, corners);
        }
        const auto made = halves_of(soup, {.point = {0, 0, 0.1}, .normal = {0.3, 0.2, 1}});
        ASSERT_TRUE(made);
        EXPECT_EQ(made->fans + made->open + made->gaps, 0u);
        double sum = 0;
        for (const Mesh& half : made->halves) {
            EXPECT_TRUE(is_closed_body(half));
            Mesh by_position = half; // as a file has it
            by_position.points = points_by_position(half.positions);
            expect_even(by_position);
            sum += volume(half);
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

TEST(FacesOnCut, ASlabIsAsThickAsItWasDrawn)
{
    for (const double size : {1e-3, 1.0, 1e4})
        for (const double share : {1e-5, 1e-4, 1e-3}) {
            const Mesh box = welded(box_mesh(glm::dvec3(size), {1, 1, 1}));
            const auto made = halves_of(box, {.point = {0, 0, size * (0.5 - share)}});
            ASSERT_TRUE(made);
            EXPECT_NEAR(volume(made->halves[1]) / std::pow(size, 3), share, 2e-7);
            for (const Mesh& half : made->halves) expect_even(half);
        }
}

TEST(FacesOnCut, LeaveClosedWhatIsClosedHoweverItIsDamaged)
{
    std::mt19937 random(12);
    for (int round = 0; round < 120; ++round) {
        Mesh mesh = random_cubes(random, 3, 0.7).skin();
        if (mesh.corners.empty()) continue;
        for (int damage = 0; damage < round % 6; ++damage) {
            const std::size_t at = random() % mesh.vertex_count();
            const glm::vec3 to = mesh.positions[random() % mesh.vertex_count()];
            for (std::size_t v = 0; v < mesh.vertex_count(); ++v) // the point goes as a whole
                if (mesh.points[v] == mesh.points[at]) mesh.positions[v] = to;
        }
        const glm::dvec3 normal(random() % 3, random() % 3, 1 + random() % 2);
        const auto made = halves_of(mesh, {.point = {1, 1, 1 + random() % 2}, .normal = normal});
        if (!made) continue;
        for (const Mesh& half : made->halves) expect_even(half);
    }
}

TEST(FacesOnCut, PlanesThroughCornersAndNearThemLeaveClosedHalves)
{
    std::mt19937 random(21);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const std::vector<Mesh> bodies{welded(torus_mesh(1, 0.4, {40, 20})), ball({0, 0, 0}, 1, 24),
                                   welded(box_mesh({1, 1.4, 0.8}, {3, 2, 1})),
                                   welded(cylinder_mesh(0.6, 1.5, 24, 3))};
    for (const Mesh& body : bodies)
        for (const double beside : {0.0, 1e-7, 3e-6, 1e-5, 1e-4})
            for (int round = 0; round < 25; ++round) {
                const auto corner = [&] {
                    return glm::dvec3(body.positions[random() % body.vertex_count()]);
                };
                const glm::dvec3 a = corner(), b = corner(), c = corner();
                const glm::dvec3 normal = glm::cross(b - a, c - a);
                if (glm::length(normal) < 1e-3) continue;
                const auto made = halves_of(
                    body, {.point = a + beside * glm::normalize(normal), .normal = normal});
                if (!made) continue;
                double sum = 0;
                for (const Mesh& half : made->halves) {
                    expect_even(half);
                    EXPECT_GT(volume(half), 0);
                    sum += volume(half);
                }
                EXPECT_NEAR(sum, volume(body), 1e-5);
                EXPECT_EQ(made->fans + made->open + made->gaps, 0u);
            }
}

} // namespace
} // namespace trivar::testing
