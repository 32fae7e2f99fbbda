// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/split/cap.h"
#include "core/split/loop_layers.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>

// Loops that cross, as where the sheets of a model run through each other.
namespace trivar::testing {
namespace {

double area_in(const LoopLayers& layers, int layer)
{
    double twice = 0;
    for (const auto& steps : layers.edges)
        for (const LoopLayers::Step& step : steps) {
            if (step.layer != layer) continue;
            const glm::dvec2 a(layers.points[step.from]), b(layers.points[step.to]);
            twice += a.x * b.y - a.y * b.x;
        }
    return twice / 2;
}

// Every step borders one layer, so each layer is a number of loops.
void expect_loops_in_every_layer(const LoopLayers& layers)
{
    std::map<std::pair<std::uint32_t, int>, int> balance;
    for (const auto& steps : layers.edges)
        for (const LoopLayers::Step& step : steps) {
            ++balance[{step.from, step.layer}];
            --balance[{step.to, step.layer}];
        }
    for (const auto& [at, count] : balance) EXPECT_EQ(count, 0);
}

TEST(LoopLayers, CoverWhatTwoSquaresRunRound)
{
    const std::vector<glm::ivec2> a{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    std::vector<glm::ivec2> b = a;
    for (glm::ivec2& p : b) p += glm::ivec2(50, 40);
    const std::optional<LoopLayers> layers = layers_of({a, b});
    ASSERT_TRUE(layers);
    expect_loops_in_every_layer(*layers);
    EXPECT_EQ(area_in(*layers, 1), 2 * 10000 - 50 * 60);
    EXPECT_EQ(area_in(*layers, 2), 50 * 60);
    EXPECT_EQ(area_in(*layers, -1), 0);
}

TEST(LoopLayers, TellTheTurnsOfAFigureEightApart)
{
    const std::optional<LoopLayers> layers = layers_of({{{0, 0}, {100, 100}, {100, 0}, {0, 100}}});
    ASSERT_TRUE(layers);
    expect_loops_in_every_layer(*layers);
    EXPECT_EQ(area_in(*layers, 1), 2500);
    EXPECT_EQ(area_in(*layers, -1), -2500); // it lies to the right of its steps
}

TEST(LoopLayers, TakeBackWhatIsGoneTwice)
{
    const std::optional<LoopLayers> layers =
        layers_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{100, 0}, {0, 0}, {50, -50}}});
    ASSERT_TRUE(layers);
    expect_loops_in_every_layer(*layers);
}

TEST(LoopLayers, AreLoopsForRandomStars)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<int> any(-1000, 1000), few(-6, 6);
    for (int k = 0; k < 300; ++k) {
        std::vector<std::vector<glm::ivec2>> loops(1 + static_cast<std::size_t>(k) % 3);
        for (std::vector<glm::ivec2>& loop : loops)
            for (int i = 0; i < 9; ++i)
                loop.push_back(k % 2 ? glm::ivec2(any(random), any(random))
                                     : glm::ivec2(few(random), few(random)));
        const std::optional<LoopLayers> layers = layers_of(loops);
        ASSERT_TRUE(layers);
        expect_loops_in_every_layer(*layers);
    }
}

// A tube round a curve that crosses itself in the plane z = 0.
Mesh knot_of_tubes()
{
    constexpr int along = 120, round = 24;
    Mesh mesh;
    for (int i = 0; i < along; ++i) {
        const double s = 2 * std::numbers::pi * i / along;
        const glm::dvec3 at(std::sin(s), std::sin(2 * s) * 0.6, 0.05 * std::cos(s));
        const glm::dvec3 t =
            glm::normalize(glm::dvec3(std::cos(s), 1.2 * std::cos(2 * s), -0.05 * std::sin(s)));
        const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), t));
        const glm::dvec3 y = glm::cross(t, x);
        for (int j = 0; j < round; ++j) {
            const double a = 2 * std::numbers::pi * j / round;
            mesh.positions.emplace_back(at + 0.2 * (std::cos(a) * x + std::sin(a) * y));
        }
    }
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t j = 0; j < round; ++j) {
            const std::uint32_t next = (i + 1) % along;
            const std::uint32_t a = i * round + j, b = i * round + (j + 1) % round;
            const std::uint32_t c = next * round + j, d = next * round + (j + 1) % round;
            add_face(mesh, std::array{a, b, c});
            add_face(mesh, std::array{b, d, c});
        }
    return welded(std::move(mesh));
}

TEST(Cap, ClosesRimsThatCrossThemselvesInLayers)
{
    const Mesh tube = knot_of_tubes();
    for (const double height : {-0.03, 0.0, 0.02, 0.04}) {
        SCOPED_TRACE(height);
        std::vector<double> heights;
        for (const glm::vec3& p : tube.positions) heights.push_back(double{p.z} - height);
        CutMesh halves = cut(tube, heights);
        CapOptions options;
        for (const glm::vec3& p : halves.places) options.places.emplace_back(p.x, p.y);
        options.point = [=](const glm::dvec2& at) { return glm::dvec3(at, height); };
        options.normal = [](const glm::dvec2&) { return glm::dvec3(0, 0, 1); };
        options.coarseness = [](const std::array<glm::dvec2, 3>& t) {
            TriangleCoarseness out{};
            for (std::size_t i = 0; i < 3; ++i)
                out.edges[i] = glm::distance(t[i], t[(i + 1) % 3]) / 0.1;
            out.whole = std::ranges::max(out.edges);
            return out;
        };
        const Caps caps = cap(halves, options);
        EXPECT_EQ(caps.fans, 0u);
        double sum = 0;
        for (const bool above : {false, true}) {
            const Mesh half = half_of(halves.mesh, halves.above, above);
            const Closedness closed = closedness(half);
            EXPECT_EQ(closed.open, 0u);
            EXPECT_EQ(closed.twice, 0u);
            sum += volume(half);
        }
        EXPECT_NEAR(sum, volume(tube), 1e-6);
    }
}

} // namespace
} // namespace trivar::testing
