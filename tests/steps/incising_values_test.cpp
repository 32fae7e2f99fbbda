// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/incising.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(NamedIncisions, AreReversedAndMirroredWithAllThatRunsAlongThem)
{
    NamedIncision one;
    one.cut.stroke = {
        {{-0.5, 0, 1}, {0, 0, 1}}, {{0.1, 0.2, 1}, {0, 0, 1}}, {{0.5, 0, 1}, {0, 0, 1}}};
    one.cut.opening_profile = {IncisionProfile::Shape::custom, {{0, 0.2}, {0.3, 1}, {1, 0.4}}};
    one.opening = {0.7, 0.1, 0.6};
    const NamedIncision other = reversed(one);
    for (const double x : {0.1, 0.3, 0.55, 0.9}) {
        EXPECT_NEAR(value_at(other.cut.opening_profile, 1 - x),
                    value_at(one.cut.opening_profile, x), 1e-12);
        EXPECT_NEAR(share_at(other.opening, 1 - x), share_at(one.opening, x), 1e-12);
    }
    EXPECT_EQ(other.cut.stroke.front(), one.cut.stroke.back());
    EXPECT_EQ(mirrored(mirrored(one)), one);
    EXPECT_EQ(mirrored(one).cut.stroke[1].p, glm::dvec3(-0.1, 0.2, 1));
}

} // namespace
} // namespace trivar
