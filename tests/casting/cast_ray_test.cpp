// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/casting/cast_ray.h"
#include "tests/casting/volumes.h"

#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

constexpr glm::ivec3 cast_size{21, 18, 24};
constexpr glm::dvec3 cast_middle{10.3, 8.1, 12.4};

Casting shells_cast(FieldOrder order)
{
    const auto value = [](const glm::dvec3& p) { return shells(p, cast_middle); };
    return casting_of(field_of(grid_of(cast_size, value), order), red_and_blue(), 0, 200);
}

// Rays through the grid, from side to side.
std::vector<CastRay> rays_through(std::size_t count)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> share(0.1f, 0.9f);
    std::vector<CastRay> out;
    const glm::vec3 end(cast_size - 1);
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 a(share(random), share(random), share(random)),
            b(share(random), share(random), share(random));
        a[static_cast<int>(i % 3)] = 0;
        b[static_cast<int>(i % 3)] = 1;
        const glm::vec3 along = glm::normalize((b - a) * end);
        out.push_back({a * end, along, glm::length((b - a) * end)});
    }
    return out;
}

// The same integral in double precision: many even steps through the function itself.
glm::dvec4 by_many_steps(const Casting& casting, const CastRay& ray)
{
    constexpr int steps = 8000;
    const VoxelField& data = *casting.field;
    const double step = double{ray.end} / steps;
    glm::dvec4 out(0);
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 p = ray.from + ray.along * static_cast<float>((i + 0.5) * step);
        const glm::vec4 look = transfer_at(red_and_blue(), data.field().at<0>(p).value);
        const double share =
            (1 - out.w) * -std::expm1(step * ray.thickness * std::log1p(-double{look.w}));
        out += glm::dvec4(glm::convertSRGBToLinear(glm::dvec3(look)) * share, share);
    }
    return out;
}

TEST(CastRays, GatherWhatManySmallStepsThroughTheFunctionGather)
{
    for (const FieldOrder order : {FieldOrder::linear, FieldOrder::quadratic, FieldOrder::cubic}) {
        const Casting casting = shells_cast(order);
        for (const CastRay& ray : rays_through(40)) {
            const CastLight light = cast_ray(casting, ray, order);
            const glm::dvec4 truth = by_many_steps(casting, ray);
            EXPECT_NEAR(light.opacity, truth.w, 0.02);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(light.color[k], truth[k], 0.02);
        }
    }
}

TEST(CastRays, GatherTheSameByAnyStepAndFromAnyFirstOne)
{
    const Casting casting = shells_cast(FieldOrder::cubic);
    for (CastRay ray : rays_through(40)) {
        const CastLight fine = cast_ray(casting, ray, FieldOrder::cubic);
        ray.pace = 1;
        for (const float jitter : {0.1f, 0.5f, 1.0f}) {
            ray.jitter = jitter;
            EXPECT_NEAR(cast_ray(casting, ray, FieldOrder::cubic).opacity, fine.opacity, 0.03);
        }
    }
}

TEST(CastRays, FindValuesAndSlopesOfTheSplineByLinearFetches)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> share(0, 1);
    for (const FieldOrder order : {FieldOrder::quadratic, FieldOrder::cubic}) {
        const Casting casting = shells_cast(order);
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 p =
                glm::vec3(share(random), share(random), share(random)) * glm::vec3(cast_size - 1);
            const CastValue found = cast_value(casting, p, order);
            const ScalarJet<float> truth = casting.field->field().at<1>(p);
            EXPECT_NEAR(found.value, truth.value / 200, 1e-5);
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(found.slope[k], truth.gradient[static_cast<std::size_t>(k)] / 200,
                            2e-5);
        }
    }
}

TEST(CastRays, LeaveOutEmptyBricksWithoutLosingAnything)
{
    Casting casting = shells_cast(FieldOrder::cubic);
    casting =
        casting_of(casting.field,
                   std::vector<TransferPoint>{{170, {1, 1, 1}, 0}, {190, {1, 1, 1}, 0.4}}, 0, 200);
    const auto empty = std::ranges::count_if(casting.empty.reach, [](int n) { return n > 0; });
    EXPECT_GT(empty, static_cast<std::ptrdiff_t>(casting.empty.reach.size() / 3));
    Casting all = casting;
    std::ranges::fill(all.empty.reach, std::uint8_t{0});
    for (const CastRay& ray : rays_through(60))
        EXPECT_NEAR(cast_ray(casting, ray, FieldOrder::cubic).opacity,
                    cast_ray(all, ray, FieldOrder::cubic).opacity, 2e-3);
}

TEST(CastRays, HitWhereHalfOfTheLightIsHeldBack)
{
    const auto steps = [](const glm::dvec3& p) { return p.x < 10 ? 0.0 : 200.0; };
    const Casting casting =
        casting_of(field_of(grid_of({20, 8, 8}, steps), FieldOrder::linear),
                   std::vector<TransferPoint>{{100, {1, 1, 1}, 0}, {100, {1, 1, 1}, 0.99}}, 0, 200);
    const CastRay ray{.from = {0, 4, 4}, .along = {1, 0, 0}, .end = 19, .pace = 0.25f};
    const CastLight light = cast_ray(casting, ray, FieldOrder::linear);
    EXPECT_FLOAT_EQ(light.opacity, 1);
    EXPECT_NEAR(light.hit, 9.5 + std::log(2.0) / -std::log1p(-0.99), 0.25);
    EXPECT_EQ(
        cast_ray(casting, {.from = {0, 4, 4}, .along = {1, 0, 0}, .end = 9}, FieldOrder::linear)
            .opacity,
        0);
}

TEST(EmptySpace, ReachesAsFarAsTheNearestBrickThatShowsSomething)
{
    const auto dot = [](const glm::dvec3& p) { return p == glm::dvec3(22, 2, 2) ? 200.0 : 0.0; };
    const Casting casting =
        casting_of(field_of(grid_of({41, 9, 9}, dot), FieldOrder::linear),
                   std::vector<TransferPoint>{{50, {1, 1, 1}, 0}, {60, {1, 1, 1}, 1}}, 0, 200);
    ASSERT_EQ(casting.empty.count, glm::ivec3(10, 2, 2));
    for (int x = 0; x < 10; ++x)
        EXPECT_EQ(casting.empty.reach[static_cast<std::size_t>(x)], std::abs(x - 5)) << x;
}

} // namespace
} // namespace trivar::testing
