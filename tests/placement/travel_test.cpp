// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/journey.h"
#include "core/placement/placement_input.h"

#include "tests/placement/scenes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// Over hills that the camera sees from the side, so that equal steps of u are no equal lengths.
Placement over_hills(const PlacementParameters& parameters)
{
    const Camera camera = from_the_side();
    const Mesh hills = height_field(
        6, 90, [](double x, double y) { return 0.25 * std::sin(3 * x) * std::cos(2 * y); });
    Timings timings;
    return place(stroke_over(camera, {{-1.5, -0.5, 0}, {0, 0.2, 0}, {1.5, 0.4, 0}}), parameters,
                 snake_box(), scene_of(hills), timings);
}

PlacementParameters short_model()
{
    PlacementParameters p;
    p.start = 0.1;
    p.fill = 0.2;
    return p;
}

constexpr double middle_at_rest = 0.2; // the middle of that model

// The way of the model's middle in the world, in steps small enough to be straight.
std::vector<double> speeds(const Journey& journey, const Surface<glm::dvec3>& contact, double from,
                           double to)
{
    std::vector<double> out;
    constexpr double step = 1e-3;
    const auto p = [&](double t) {
        return evaluate(contact, {middle_at_rest + journey.at(t).shift_u, 0.5}).value;
    };
    for (int i = 0; i <= 200; ++i) {
        const double t = from + (to - step - from) * i / 200;
        out.push_back(glm::distance(p(t), p(t + step)) / step);
    }
    return out;
}

TEST(Journey, GoesAtOneSpeedOverHills)
{
    const Placement on = over_hills(short_model());
    const Journey journey({.speed = 0.5}, short_model(), on.contact);
    for (const double speed : speeds(journey, on.contact, 0, journey.seconds()))
        EXPECT_NEAR(speed, 0.5, 0.01); // 2 %
}

TEST(Journey, StaysWhereItsFrontReachesTheEnd)
{
    const Placement on = over_hills(short_model());
    const Journey ahead({.speed = 0.5, .ease_in = 0.4, .ease_out = 1}, short_model(), on.contact);
    EXPECT_NEAR(ahead.at(ahead.seconds()).shift_u, 0.7, 1e-9);
    EXPECT_EQ(ahead.at(1e6), ahead.at(ahead.seconds()));
    const Journey back({.speed = -0.5}, short_model(), on.contact);
    EXPECT_NEAR(back.at(1e6).shift_u, -0.1, 1e-9);
    const Journey ahead_without_easing({.speed = 0.5}, short_model(), on.contact);
    PlacementParameters turned = short_model();
    turned.reverse = true; // it looks toward the start, and goes there
    EXPECT_EQ(Journey({.speed = 0.5}, turned, on.contact).at(1e6), back.at(1e6));
    PlacementParameters of_gltf = short_model();
    of_gltf.along = LengthAxis::y; // whose front, at -y, is toward the start too
    EXPECT_EQ(Journey({.speed = 0.5}, of_gltf, on.contact).at(1e6), back.at(1e6));
    of_gltf.reverse = true;
    EXPECT_EQ(Journey({.speed = 0.5}, of_gltf, on.contact).at(1e6), ahead_without_easing.at(1e6));
}

TEST(Journey, RestsTillItSetsOutAndWithoutSpeed)
{
    const Placement on = over_hills(short_model());
    EXPECT_EQ(Journey({.speed = 0.5}, short_model(), on.contact).at(0), Journey::Place{});
    EXPECT_EQ(Journey({.speed = 0}, short_model(), on.contact).at(7), Journey::Place{});
    EXPECT_EQ(Journey({.speed = 0}, short_model(), on.contact).seconds(), 0);
}

TEST(Journey, HasNoRoomOnAStrokeThatItFills)
{
    const Placement on = over_hills({});
    for (const Ends ends : {Ends::stay, Ends::hide, Ends::loop, Ends::back_and_forth}) {
        const Journey journey({.speed = 1, .ends = ends}, {}, on.contact);
        EXPECT_FALSE(journey.has_room());
        EXPECT_EQ(journey.at(3), Journey::Place{});
    }
    EXPECT_TRUE(Journey({.speed = 1, .ends = Ends::run_on}, {}, on.contact).has_room());
}

TEST(Journey, KeepsToItsEnds)
{
    const Placement on = over_hills(short_model());
    const auto going = [&](Ends ends) {
        return Journey({.speed = 0.5, .ends = ends}, short_model(), on.contact);
    };
    const double arrives = going(Ends::stay).seconds();
    EXPECT_FALSE(going(Ends::hide).at(arrives * 0.99).hidden);
    EXPECT_TRUE(going(Ends::hide).at(arrives).hidden);
    EXPECT_GT(going(Ends::run_on).at(3 * arrives).shift_u, 1.5);
    for (const Ends ends : {Ends::loop, Ends::back_and_forth}) {
        const Journey journey = going(ends);
        EXPECT_EQ(journey.seconds(), std::numeric_limits<double>::infinity());
        double least = 1, most = -1;
        for (int i = 0; i < 400; ++i) {
            const double shift = journey.at(arrives * i / 100).shift_u;
            least = std::min(least, shift);
            most = std::max(most, shift);
        }
        EXPECT_NEAR(least, -0.1, 0.01);
        EXPECT_NEAR(most, 0.7, 0.01);
        EXPECT_GE(least, -0.1 - 1e-9);
        EXPECT_LE(most, 0.7 + 1e-9);
    }
}

TEST(Journey, EasesWithoutAJolt)
{
    const Placement on = over_hills(short_model());
    const Journey journey(
        {.speed = 0.5, .ends = Ends::back_and_forth, .ease_in = 0.6, .ease_out = 0.9},
        short_model(), on.contact);
    const std::vector<double> all = speeds(journey, on.contact, 0, 12);
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_LT(std::abs(all[i] - all[i - 1]), 0.06) << i; // 0.06 s of 0.5 / 0.6 m/s^2
    EXPECT_LT(all.front(), 0.01);
}

TEST(Journey, StopsAfterItsDuration)
{
    const Placement on = over_hills(short_model());
    for (const Ends ends : {Ends::stay, Ends::run_on, Ends::loop, Ends::back_and_forth}) {
        const Travel travel{
            .speed = 0.5, .ends = ends, .ease_in = 0.1, .ease_out = 0.1, .duration = 1.5};
        const Journey journey(travel, short_model(), on.contact);
        EXPECT_DOUBLE_EQ(journey.seconds(), 1.5);
        EXPECT_NE(journey.at(1.4), journey.at(1.5));
        EXPECT_EQ(journey.at(1.5), journey.at(90));
    }
}

TEST(Journey, KnowsTheSpeedForATime)
{
    const Placement on = over_hills(short_model());
    Travel travel{.speed = 0.5, .ease_in = 0.5, .ease_out = 0.5};
    travel.speed = Journey(travel, short_model(), on.contact).speed_for(4);
    EXPECT_NEAR(Journey(travel, short_model(), on.contact).seconds(), 4, 1e-9);
}

TEST(Journey, GoesRoundARingWithoutAJump)
{
    std::vector<glm::dvec2> ring;
    for (int i = 0; i <= 72; ++i)
        ring.emplace_back(750 + 300 * std::cos(0.0872665 * i), 500 + 300 * std::sin(0.0872665 * i));
    PlacementParameters p = short_model();
    p.width = 0.2;
    Timings timings;
    const Placement on =
        place(stroke(from_above(), ring), p, snake_box(),
              scene_of(height_field(4, 20, [](double, double) { return 0; })), timings);
    const Journey journey({.speed = 0.5, .ends = Ends::loop}, p, on.contact);
    ASSERT_TRUE(journey.rounds());
    glm::dvec3 before = evaluate(on.contact, {middle_at_rest, 0.5}).value;
    for (int i = 1; i < 300; ++i) {
        const double u = middle_at_rest + journey.at(0.1 * i).shift_u;
        EXPECT_GE(u, p.fill / 2 - 1e-12);
        const glm::dvec3 now = evaluate(on.contact, {u > 1 ? u - 1 : u, 0.5}).value;
        EXPECT_NEAR(glm::distance(before, now), 0.05, 0.001) << i;
        before = now;
    }
}

double length_on(const Journey& journey, const MiddleLine& line, double seconds, int follower)
{
    return line.length_at(middle_at_rest + journey.at(seconds, follower).shift_u);
}

TEST(Journey, LeadsAProcessionAtEqualGaps)
{
    const Placement on = over_hills(short_model());
    const MiddleLine line(on.contact);
    PlacementParameters p = short_model();
    p.fill = 0.05; // the same middle
    p.start = middle_at_rest - p.fill / 2;
    const Journey alone({.speed = 0.5}, p, on.contact);
    const Journey journey({.speed = 0.5, .followers = 3, .gap = 0.3}, p, on.contact);
    EXPECT_EQ(journey.seconds(), alone.seconds());
    for (const double t : {0.0, 0.7, 2.9, 100.0}) {
        EXPECT_EQ(journey.at(t), alone.at(t));
        for (int k = 1; k <= 3; ++k) {
            EXPECT_NEAR(length_on(journey, line, t, k), length_on(alone, line, t, 0) - 0.3 * k,
                        1e-9);
            // Followers that are not on the stroke yet are hidden.
            EXPECT_EQ(journey.at(t, k).hidden,
                      length_on(journey, line, t, k) < line.length_at(p.fill / 2) - 1e-6);
        }
    }
    EXPECT_TRUE(journey.at(0, 3).hidden);
    EXPECT_FALSE(journey.at(100, 3).hidden);
}

TEST(Journey, HidesEachWhereItIsGoneAndKeepsAllOnTheStrokeWhereItTurns)
{
    const Placement on = over_hills(short_model());
    const MiddleLine line(on.contact);
    const Travel procession{.speed = 0.5, .followers = 2, .gap = 0.5};
    const auto going = [&](Ends ends) {
        Travel travel = procession;
        travel.ends = ends;
        return Journey(travel, short_model(), on.contact);
    };
    const Journey hide = going(Ends::hide);
    const double first_gone = hide.seconds() - 2 * 0.5 / 0.5;
    EXPECT_TRUE(hide.at(first_gone + 1e-6).hidden);
    EXPECT_FALSE(hide.at(first_gone + 1e-6, 2).hidden);
    EXPECT_TRUE(hide.at(hide.seconds() + 1e-6, 2).hidden);
    const Journey turning = going(Ends::back_and_forth);
    for (double t = 4; t < 40; t += 0.37)
        for (int k = 0; k <= 2; ++k) {
            EXPECT_FALSE(turning.at(t, k).hidden);
            const double length = length_on(turning, line, t, k);
            EXPECT_GE(length, line.length_at(0.1) - 1e-9);
            EXPECT_LE(length, line.length_at(0.9) + 1e-9);
        }
    const Journey on_and_on = going(Ends::run_on);
    EXPECT_FALSE(on_and_on.at(0, 2).hidden);
    EXPECT_LT(on_and_on.at(0, 2).shift_u, -middle_at_rest); // before the stroke
}

TEST(Journey, SpreadsAProcessionEvenlyAlongALoop)
{
    const Placement on = over_hills(short_model());
    const MiddleLine line(on.contact);
    const Journey journey({.speed = 0.5, .ends = Ends::loop, .followers = 3}, short_model(),
                          on.contact);
    const double lap = line.length_at(0.9) - line.length_at(0.1);
    for (const double t : {0.0, 1.0, 33.0})
        for (int k = 1; k <= 3; ++k) {
            const double behind =
                length_on(journey, line, t, k - 1) - length_on(journey, line, t, k);
            EXPECT_NEAR(behind - lap * std::floor(behind / lap), lap / 4, 1e-9);
            EXPECT_FALSE(journey.at(t, k).hidden);
        }
}

TEST(Journey, CountsEveryRoundAndReturnOfTheWay)
{
    const Placement on = over_hills(short_model());
    for (const Ends ends : {Ends::stay, Ends::loop, Ends::back_and_forth, Ends::run_on}) {
        const Journey journey({.speed = 0.5, .ends = ends, .followers = 1}, short_model(),
                              on.contact);
        for (int k = 0; k < 2; ++k) {
            EXPECT_EQ(journey.at(0, k).gone_u, 0);
            double before = 0;
            for (double t = 0.01; t < 40; t += 0.01) { // never a jump
                const double gone = journey.at(t, k).gone_u;
                EXPECT_LT(std::abs(gone - before), 0.02) << t;
                before = gone;
            }
        }
    }
}

TEST(Journey, IsNoFurtherFromGoingEvenlyThanItSays)
{
    const Placement on = over_hills(short_model());
    for (const Ends ends : {Ends::stay, Ends::hide, Ends::run_on, Ends::loop, Ends::back_and_forth})
        for (const double speed : {0.7, -0.4})
            for (const double ease : {0.0, 0.5}) {
                const Journey journey({.speed = speed,
                                       .ends = ends,
                                       .ease_in = ease,
                                       .ease_out = ease,
                                       .duration = ends == Ends::loop ? 5.0 : 0,
                                       .followers = 1},
                                      short_model(), on.contact);
                for (double from = -0.3; from < 12; from += 0.37)
                    for (const double h : {0.04, 0.3}) {
                        const double a = journey.at(from, 1).gone_u,
                                     b = journey.at(from + h, 1).gone_u,
                                     most = journey.unevenness_u(from, from + h, 1);
                        for (const double x : {0.1, 0.35, 0.5, 0.8})
                            EXPECT_LE(
                                std::abs(journey.at(from + x * h, 1).gone_u - (a + x * (b - a))),
                                most + 1e-12)
                                << static_cast<int>(ends) << " " << speed << " " << from;
                    }
            }
}

} // namespace
} // namespace trivar
