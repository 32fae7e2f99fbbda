// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/springs.h"
#include "tests/placement/spring_dynamics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A flat square sheet over [-1, 1]^2 whose nodes move along z.
SpringSheet flat_sheet(int rows, int columns)
{
    SpringSheet sheet;
    sheet.rows = rows;
    sheet.columns = columns;
    for (int i = 0; i < rows; ++i) sheet.along.push_back(2.0 * i / (rows - 1) - 1);
    for (int j = 0; j < columns; ++j) sheet.across.push_back(2.0 * j / (columns - 1) - 1);
    for (const double x : sheet.along)
        for (const double y : sheet.across) {
            sheet.p0.emplace_back(x, y, 0);
            sheet.direction.emplace_back(0, 0, 1);
            sheet.lo.push_back(-infinite);
            sheet.hi.push_back(infinite);
        }
    return sheet;
}

std::vector<double> rest(const SpringSheet& sheet, const std::vector<char>& free,
                         std::vector<double> s)
{
    ObstacleProblem problem = spring_problem(sheet);
    problem.free = free;
    return projected_sor(problem, std::move(s), red_black(sheet.rows, sheet.columns),
                         over_relaxation(sheet.rows, sheet.columns), 1e-13, 20000)
        .s;
}

TEST(Springs, LieOnADiscLikeTheMembraneOverAParaboloid)
{
    // A membrane fixed at 0 on the unit circle over psi = 0.3 - 2 r^2 touches it for r < a, where
    // 0.3 - 2 a^2 = -4 a^2 ln a, and is 4 a^2 ln(1/r) outside. The error falls with n.
    double a = 0.1852;
    for (int i = 0; i < 50; ++i)
        a -= (0.3 - 2 * a * a + 4 * a * a * std::log(a)) / (8 * a * std::log(a));
    ASSERT_NEAR(a, 0.1852, 1e-4);
    for (const auto& [n, tolerance] : {std::pair{33, 1.1e-3}, {65, 6.5e-4}, {129, 1.7e-4}}) {
        SpringSheet sheet = flat_sheet(n, n);
        std::vector<char> free(sheet.p0.size(), 0);
        std::vector<double> exact(sheet.p0.size()), s(sheet.p0.size());
        for (std::size_t k = 0; k < s.size(); ++k) {
            const double r = std::hypot(sheet.p0[k].x, sheet.p0[k].y);
            exact[k] = r < a ? 0.3 - 2 * r * r : 4 * a * a * std::log(1 / r);
            sheet.lo[k] = r < 1 ? 0.3 - 2 * r * r : -infinite;
            free[k] = r < 1 && std::abs(sheet.p0[k].x) < 1 && std::abs(sheet.p0[k].y) < 1;
            s[k] = free[k] ? std::max(sheet.lo[k], 0.0) : exact[k];
        }
        s = rest(sheet, free, s);
        double worst = 0;
        for (std::size_t k = 0; k < s.size(); ++k)
            if (free[k]) worst = std::max(worst, std::abs(s[k] - exact[k]));
        EXPECT_LT(worst, tolerance) << n;
    }
}

TEST(Springs, ATautStringIsTheConvexHullOfItsObstacles)
{
    SpringSheet sheet = flat_sheet(41, 2);
    std::vector<double> height(41, 0);
    height[10] = 0.5;
    height[18] = 0.2; // below the chord from 10 to 30
    height[30] = 0.4;
    std::vector<char> free(82, 1);
    for (int i = 0; i < 41; ++i)
        for (int j = 0; j < 2; ++j) {
            sheet.lo[sheet.index(i, j)] = height[static_cast<std::size_t>(i)];
            free[sheet.index(i, j)] = i > 0 && i < 40;
        }
    const std::vector<double> s = rest(sheet, free, sheet.lo);
    for (int i = 0; i < 41; ++i) {
        const double hull = i <= 10   ? 0.05 * i
                            : i <= 30 ? 0.5 - 0.1 * (i - 10) / 20
                                      : 0.4 * (40 - i) / 10;
        EXPECT_NEAR(s[sheet.index(i, 0)], hull, 1e-9) << i;
    }
}

TEST(Springs, WithoutObstacleTheMembraneIsHarmonic)
{
    SpringSheet sheet = flat_sheet(21, 17);
    std::vector<char> free(sheet.p0.size(), 0);
    std::vector<double> s(sheet.p0.size());
    const auto harmonic = [](const glm::dvec3& p) { return p.x * p.x - p.y * p.y + 0.3 * p.x; };
    for (int i = 0; i < 21; ++i)
        for (int j = 0; j < 17; ++j) {
            const std::size_t k = sheet.index(i, j);
            free[k] = i > 0 && j > 0 && i < 20 && j < 16;
            s[k] = free[k] ? 0 : harmonic(sheet.p0[k]);
        }
    s = rest(sheet, free, s);
    // Second differences of a quadratic are exact, whatever the spacing.
    for (std::size_t k = 0; k < s.size(); ++k) EXPECT_NEAR(s[k], harmonic(sheet.p0[k]), 1e-9);
}

TEST(Springs, TurnWithTheScene)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.2, 0.2);
    SpringSheet sheet = flat_sheet(15, 9);
    sheet.bending = 0.5;
    for (std::size_t k = 0; k < sheet.p0.size(); ++k) {
        sheet.p0[k].z = uniform(random);
        sheet.lo[k] = 0;
        sheet.direction[k] = glm::normalize(glm::dvec3(uniform(random), uniform(random), 1));
    }
    const glm::dmat3 turn = glm::dmat3(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
    SpringSheet turned = sheet;
    for (std::size_t k = 0; k < sheet.p0.size(); ++k) {
        turned.p0[k] = turn * sheet.p0[k] + glm::dvec3(3, -2, 1);
        turned.direction[k] = turn * sheet.direction[k];
    }
    const std::vector<double> zero(sheet.p0.size(), 0);
    const RestOptions options{.tolerance = 1e-12, .most_sweeps = 20000};
    const RestShape a = rest_shape(sheet, zero, options), b = rest_shape(turned, zero, options);
    EXPECT_EQ(a.loose, b.loose);
    for (std::size_t k = 0; k < zero.size(); ++k) EXPECT_NEAR(a.s[k], b.s[k], 1e-8);
}

TEST(Springs, LeaveASmoothSheetAloneAndBridgeAGap)
{
    SpringSheet sheet = flat_sheet(33, 9);
    for (std::size_t k = 0; k < sheet.p0.size(); ++k) sheet.lo[k] = 0;
    const std::vector<double> zero(sheet.p0.size(), 0);
    EXPECT_EQ(rest_shape(sheet, zero, {}).s, zero);
    for (int i = 12; i < 20; ++i)
        for (int j = 0; j < 9; ++j) sheet.p0[sheet.index(i, j)].z = -1;
    const RestShape shape = rest_shape(sheet, zero, {.neighborhood = 8, .tolerance = 1e-10});
    for (int i = 0; i < 33; ++i)
        for (int j = 0; j < 9; ++j)
            EXPECT_NEAR(sheet.point(sheet.index(i, j), shape.s).z, 0, 1e-6) << i << " " << j;
}

TEST(SpringDynamics, IsStableJustBelowTheStepItNamesAndNotAbove)
{
    // One node between two fixed ones along x, free along z: lambda is bounded by 4 for a row, and
    // the checkerboard of a long row comes close to it.
    SpringSheet sheet = flat_sheet(64, 64);
    ObstacleProblem problem = spring_problem(sheet);
    const auto grows = [&](const SpringDynamics& dynamics, double dt) {
        std::vector<double> s(problem.size()), v(problem.size(), 0);
        for (std::size_t k = 0; k < s.size(); ++k) s[k] = (k / 64 + k % 64) % 2 ? 1e-3 : -1e-3;
        for (int step = 0; step < 1500; ++step) {
            std::vector<double> force(s.size());
            for (std::size_t k = 0; k < s.size(); ++k) force[k] = problem.force(s, k);
            for (std::size_t k = 0; k < s.size(); ++k) {
                v[k] += dt * (dynamics.stiffness * force[k] + dynamics.damping * v[k]);
                s[k] += dt * v[k];
            }
        }
        double largest = 0;
        for (const double x : s) largest = std::max(largest, std::abs(x));
        return !(largest < 1);
    };
    for (const double rho : {-1.0, -20.0, -100.0}) {
        const SpringDynamics dynamics{100, rho};
        // The formula for k/M = 100 and eigenvalues up to 8.
        EXPECT_NEAR(stable_step(problem, dynamics), (std::sqrt(rho * rho + 3200) + rho) / 800,
                    1e-12);
        EXPECT_FALSE(grows(dynamics, 0.98 * stable_step(problem, dynamics))) << rho;
        EXPECT_TRUE(grows(dynamics, 1.03 * stable_step(problem, dynamics))) << rho;
        EXPECT_NEAR(stable_step_explicit(problem, dynamics), std::min(-rho / 800, -2 / rho), 1e-12);
    }
}

TEST(SpringDynamics, SettlesAtTheRestShapeWhateverTheStiffness)
{
    SpringSheet sheet = flat_sheet(17, 17);
    std::vector<char> free(sheet.p0.size(), 0);
    for (int i = 1; i < 16; ++i)
        for (int j = 1; j < 16; ++j) {
            const std::size_t k = sheet.index(i, j);
            free[k] = 1;
            sheet.lo[k] = 0.3 - 2 * glm::dot(sheet.p0[k], sheet.p0[k]);
        }
    std::vector<double> start(sheet.p0.size(), 0);
    for (std::size_t k = 0; k < start.size(); ++k) start[k] = std::max(0.0, sheet.lo[k]);
    const std::vector<double> still = rest(sheet, free, start);
    ObstacleProblem problem = spring_problem(sheet);
    problem.free = free;
    for (const double stiffness : {1.0, 400.0}) {
        SpringState state{start, std::vector<double>(start.size(), 0)};
        state =
            stepped(problem, state, settling_dynamics(stiffness, 17), 80 / std::sqrt(stiffness));
        for (std::size_t k = 0; k < start.size(); ++k) EXPECT_NEAR(state.s[k], still[k], 1e-6);
    }
}

} // namespace
} // namespace trivar
