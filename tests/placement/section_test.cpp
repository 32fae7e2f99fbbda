// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/section.h"

#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/placement/round.h"
#include "tests/placement/scenes.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

const glm::dmat4 somewhere = glm::rotate(glm::translate(glm::dmat4(1), {3, -2, 1}), 0.7,
                                         glm::normalize(glm::dvec3(1, 2, 3)));

SectionPlane plane_at(double level, const glm::dmat4& to_world = somewhere)
{
    return {glm::dvec3(to_world * glm::dvec4(0, 0, level, 1)), glm::dvec3(to_world[2]),
            glm::dvec3(to_world[0])};
}

TEST(Section, OfASphereIsItsCircleOfLatitudeAndItsMeridians)
{
    const Mesh sphere = sphere_mesh(1, 96, 48);
    Section section({{&sphere, somewhere}}, plane_at(0.3));
    const double r = std::sqrt(1 - 0.3 * 0.3);
    EXPECT_NEAR(section.length(), glm::two_pi<double>() * r, 0.02);
    section.widen(0.4);
    for (int i = 0; i < 16; ++i) {
        const double angle = glm::two_pi<double>() * i / 16;
        const Section::Column column = section.column(i / 16.0);
        for (const double across : {-0.3, 0.0, 0.35}) {
            const double latitude = std::asin(0.3) + across;
            const glm::dvec3 own(std::cos(latitude) * std::cos(angle),
                                 std::cos(latitude) * std::sin(angle), std::sin(latitude));
            EXPECT_LT(
                glm::distance(place_at(column, across), glm::dvec3(somewhere * glm::dvec4(own, 1))),
                0.02);
        }
        EXPECT_THROW(place_at(column, 1.2), Rejected);
    }
}

TEST(Section, IsRefusedWhereThePlaneCutsNothing)
{
    const Mesh sphere = sphere_mesh(1, 24, 12);
    EXPECT_THROW(Section({{&sphere, somewhere}}, plane_at(1.5)), Rejected);
    EXPECT_THROW(Section({}, plane_at(0)), Rejected);
}

TEST(Section, BridgesWhatIsHollow)
{
    // Two posts stand apart: a band round both goes straight from one to the other.
    const Mesh post = box_mesh({0.2, 0.2, 2}, {1, 1, 1});
    const glm::dmat4 left = glm::translate(somewhere, {-1, 0, 0}),
                     right = glm::translate(somewhere, {1, 0, 0});
    const Section section({{&post, left}, {&post, right}}, plane_at(0.1));
    EXPECT_NEAR(section.length(), 2 * (2.2 + 0.2), 0.01);
}

TEST(Section, APlacementRoundACylinderIsThatRoundItsBand)
{
    const Mesh cylinder = cylinder_mesh(1, 3, 128, 4);
    PlacementParameters p;
    p.fill = 1.0 / 6;
    p.grid = {48, 6, 4};
    const Placement exact =
        place_round(Band{.radius = 1, .level = 0.2, .to_world = somewhere}, p, snake_box());
    const Placement cut =
        place_round(Section({{&cylinder, somewhere}}, plane_at(0.2)), p, snake_box());
    EXPECT_NEAR(cut.report.length_world, exact.report.length_world, 0.01);
    EXPECT_GT(cut.report.smallest_jacobian, 0);
    EXPECT_LE(cut.report.penetration, p.lift_tolerance);
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j <= 4; ++j)
            for (const double w : {0.0, 0.5, 1.0}) {
                const glm::dvec3 uvw(i / 40.0, j / 4.0, w);
                EXPECT_LT(glm::distance(evaluate(cut.volume, uvw).value,
                                        evaluate(exact.volume, uvw).value),
                          0.01);
            }
    p.width = 4;
    EXPECT_THROW(place_round(Section({{&cylinder, somewhere}}, plane_at(0.2)), p, snake_box()),
                 Rejected)
        << "the cylinder is three high";
}

TEST(Section, SaysWhereAWideModelStandsOffTheBody)
{
    const Mesh ball = sphere_mesh(1, 96, 48);
    const auto laid = [&](double width) {
        return place_round(Section({{&ball, somewhere}}, plane_at(0)),
                           {.width = width, .height = 0.1, .grid = {33, 4, 4}}, snake_box());
    };
    EXPECT_EQ(laid(0.2).report.contact_share, 1);
    const Placement wide = laid(2);
    const glm::dmat4 to_own = glm::inverse(somewhere);
    double furthest = 0;
    for (int i = 0; i < 33; ++i)
        for (int j = 0; j <= 20; ++j) {
            const glm::dvec3 p = evaluate(wide.contact, {i / 33.0, j / 20.0}).value;
            furthest = std::max(furthest, glm::length(glm::dvec3(to_own * glm::dvec4(p, 1))) - 1);
        }
    EXPECT_GT(furthest, 0.02) << "the test means something";
    EXPECT_NEAR(wide.report.largest_gap, furthest, 0.2 * furthest);
    const auto off = std::ranges::count(wide.nodes, Contact::bridges, &StripNode::contact);
    EXPECT_GT(off, 0);
    EXPECT_NEAR(wide.report.contact_share,
                1 - static_cast<double>(off) / static_cast<double>(wide.nodes.size()), 1e-9);
}

TEST(Section, NothingOfABodyWithEdgesStandsOutOfTheContactSurface)
{
    const Mesh box = box_mesh({1, 2, 3}, {1, 1, 1});
    const Placement out = place_round(Section({{&box, somewhere}}, plane_at(0)),
                                      {.grid = {33, 9, 4}, .fill = 0.3}, snake_box());
    EXPECT_LE(out.report.penetration, 0.01);
    const glm::dmat4 to_own = glm::inverse(somewhere);
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 own(to_own * glm::dvec4(evaluate(out.contact, {i / 400.0, 0.5}).value, 1));
        EXPECT_GT(std::max(std::abs(own.x) / 0.5, std::abs(own.y)), 1 - 0.01);
    }
}

} // namespace
} // namespace trivar
