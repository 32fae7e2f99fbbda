// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/journey.h"
#include "core/placement/round.h"

#include "core/base/rejected.h"
#include "core/placement/placement_input.h"
#include "core/placement/shaper.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

PlacementParameters a_sixth()
{
    PlacementParameters p;
    p.fill = 1.0 / 6;
    p.grid = {48, 6, 4};
    p.orders = {4, 4, 3};
    return p;
}

std::vector<Band> all_bands()
{
    const glm::dmat4 somewhere = glm::dmat4(0, 0.5, 0, 0, -0.5, 0, 0, 0, 0, 0, 0.5, 0, 3, 2, 1, 1);
    return {{.radius = 2},
            {.of = Band::Of::sphere, .radius = 2, .level = 0.5},
            {.of = Band::Of::torus, .radius = 2, .tube = 0.8, .level = 0.4, .to_world = somewhere},
            {.of = Band::Of::moebius, .radius = 2, .to_world = somewhere}};
}

TEST(Round, TheContactLiesOnTheSurfaceAndTheVolumeStandsOnIt)
{
    for (const Band& band : all_bands()) {
        const Placement out = place_round(band, a_sixth(), snake_box());
        const double size = out.report.length_world;
        for (int i = 0; i < 40; ++i)
            for (int j = 0; j <= 4; ++j) {
                const glm::dvec2 uv(i / 40.0, j / 4.0);
                const double angle = 6.283185307179586 * uv.x;
                const double across = (uv.y - 0.5) * out.report.width_world;
                const double scale = std::cbrt(glm::determinant(glm::dmat3(band.to_world)));
                const glm::dvec3 p = band.at(angle, across / scale);
                const glm::dvec3 s = evaluate(out.contact, uv).value;
                EXPECT_LT(glm::distance(s, p), 1e-3 * size);
                EXPECT_LT(glm::distance(evaluate(out.volume, {uv.x, uv.y, out.ground}).value, s),
                          1e-4 * size);
                const glm::dvec3 roof = evaluate(out.volume, {uv.x, uv.y, 1}).value;
                EXPECT_NEAR(glm::dot(roof - s, band.normal(angle, across / scale)),
                            out.report.height_world, 1e-3 * size);
            }
        EXPECT_GT(out.report.smallest_jacobian, 0);
    }
}

TEST(Round, ClosesSmoothlyAndTheTwistedOneUpsideDown)
{
    for (const Band& band : all_bands()) {
        const Placement out = place_round(band, a_sixth(), snake_box());
        for (const glm::dvec3 uvw : {glm::dvec3(0.1, 0.2, 0.7), glm::dvec3(0.93, 0.9, 0.5)}) {
            const glm::dvec3 again =
                band.twisted() ? glm::dvec3(0, 1, 1) - uvw * glm::dvec3(-1, 1, 1) : uvw;
            const Jet<glm::dvec3> a = evaluate(out.volume, uvw, 1),
                                  b = evaluate(out.volume, again + glm::dvec3(1, 0, 0), 1);
            EXPECT_LT(glm::distance(a.value, b.value), 1e-12);
            EXPECT_LT(glm::distance(a.first[0], b.first[0]), 1e-10);
        }
    }
}

TEST(Round, AModelKeepsItsProportions)
{
    const Placement out = place_round({.radius = 2}, a_sixth(), snake_box()); // ten by two by one
    const double along = out.report.length_world / 6;
    EXPECT_NEAR(out.report.width_world, along / 5, 1e-9);
    EXPECT_NEAR(out.report.height_world, along / 10, 1e-9);
}

TEST(Round, TravelsAtOneSpeedAndIsBackAfterOneRoundOrTwo)
{
    for (const Band& band : all_bands()) {
        const PlacementParameters p = a_sixth();
        const Placement on = place_round(band, p, snake_box());
        const Journey journey({.speed = 0.5, .ends = Ends::loop}, p, on.contact);
        EXPECT_TRUE(journey.rounds());
        const auto at = [&](double t) {
            return evaluate(on.contact, {p.fill / 2 + journey.at(t).shift_u, 0.5}).value;
        };
        for (int i = 0; i < 85; ++i)
            EXPECT_NEAR(glm::distance(at(0.7 * i), at(0.7 * i + 0.01)) / 0.01, 0.5, 0.01);
        const double round = MiddleLine(on.contact).length() / 0.5;
        const auto roof = [&](double t) {
            return evaluate(on.volume, {p.fill / 2 + journey.at(t).shift_u, 0.3, 0.9}).value;
        };
        const double once = glm::distance(roof(1), roof(1 + round));
        if (band.twisted())
            EXPECT_GT(once, 0.1);
        else
            EXPECT_LT(once, 1e-6);
        EXPECT_LT(glm::distance(roof(1), roof(1 + 2 * round)), 1e-6);
    }
}

TEST(Round, GoesOnGoingRoundAfterItsVolumeWasPressed)
{
    for (const Band& band : all_bands()) {
        const auto laid = make_ref(place_round(band, a_sixth(), snake_box()));
        const double height = laid->report.height_world;
        Shaper shaper;
        // Where the ends of u meet.
        VolumeEdit edit{.press =
                            Press{.radius = 3 * height, .samples = {{0, 0.5, 1, 0.1 * height}}}};
        const Ref<ShapedVolume> after = shaper(laid, {make_ref(edit)});
        EXPECT_GT(after->steps[0].done, 0);
        const Placement& out = *after->placement;
        for (int a = 0; a < 2; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            EXPECT_EQ(out.contact.axes[axis].closure(), laid->contact.axes[axis].closure());
        }
        for (double u = -0.1; u < 1.1; u += 0.05)
            for (const double v : {0.1, 0.5, 0.9})
                EXPECT_LT(glm::distance(evaluate(out.contact, {u, v}).value,
                                        evaluate(out.volume, {u, v, out.ground}).value),
                          1e-9 * out.report.length_world);
    }
}

TEST(Round, SaysWhyItCannotBe)
{
    PlacementParameters wide = a_sixth();
    wide.width = 20;
    EXPECT_THROW(place_round({.of = Band::Of::sphere, .radius = 1}, wide, snake_box()), Rejected);
    const Band mirrored{.to_world = glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)};
    EXPECT_THROW(place_round(mirrored, a_sixth(), snake_box()), Rejected);
    const Placement high = [&] {
        PlacementParameters p = a_sixth();
        p.reverse = true;
        p.height = 5;
        return place_round({.of = Band::Of::moebius, .radius = 1}, p, snake_box());
    }();
    EXPECT_FALSE(high.report.folds.empty()); // it reaches through the axis
}

TEST(Round, AProcessionSharesTheWholeWayAndClosesUp)
{
    for (const Band& band : all_bands()) {
        const PlacementParameters p = a_sixth();
        const Placement out = place_round(band, p, snake_box());
        const Travel travel{.speed = 0.5, .ends = Ends::loop, .followers = 6};
        const Journey journey(travel, p, out.contact);
        const MiddleLine line(out.contact);
        const double way = line.length() * line.rounds_to_start();
        for (const double t : {0.0, 3.0, 50.0})
            for (int k = 1; k <= 6; ++k) {
                const auto at = [&](int each) {
                    const double u = p.start + p.fill / 2 + journey.at(t, each).shift_u;
                    return std::floor(u) * line.length() + line.length_at(u - std::floor(u));
                };
                const double behind = at(k - 1) - at(k);
                EXPECT_NEAR(behind - way * std::floor(behind / way), way / 7, 1e-9 * way);
            }
        // After its time for the whole way each is where it was.
        const double turn = way / 0.5;
        for (int k = 0; k <= 6; ++k)
            EXPECT_NEAR(std::remainder(journey.at(7 + turn, k).shift_u - journey.at(7, k).shift_u,
                                       line.rounds_to_start()),
                        0, 1e-9);
    }
}

} // namespace
} // namespace trivar
