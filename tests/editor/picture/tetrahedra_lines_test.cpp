// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/tetrahedra_picture.h"

#include "core/tetrahedra/tetrahedra_shaper.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TetrahedraEffects volume_of(const TetrahedraShape& shape)
{
    return {make_ref(TetrahedraShaper()(shape)), glm::dmat4(1)};
}

TEST(TetrahedraLines, AreThoseOfTheBorderAndWhileSelectedThoseInside)
{
    // A cube of 6 tetrahedra has 12 edges and 6 diagonals, and the one inside.
    const TetrahedraEffects cube = volume_of({.boxes = glm::ivec3(1)});
    TetrahedraLines lines;
    EXPECT_EQ(lines(cube, {}, 1, false).size(), 18U);
    EXPECT_EQ(lines(cube, {}, 1, true).size(), 19U);
    EXPECT_TRUE(lines({}, {}, 1, true).empty());
}

TEST(TetrahedraLines, AreKeptForTheNextPictureAndMadeForAnotherVolume)
{
    TetrahedraShape shape;
    const TetrahedraEffects rest = volume_of(shape);
    shape.edits = {{.pull = TetrahedraPull{.radius = 3, .by = {0.1, 0, 0}}}};
    TetrahedraEffects pulled = volume_of(shape);
    TetrahedraLines lines;
    const std::vector<glm::vec3>* at_rest = &lines(rest, {}, 1, true).front().points;
    const std::vector<glm::vec3> before = *at_rest;
    EXPECT_EQ(&lines(rest, {}, 1, true).front().points, at_rest);
    EXPECT_NE(lines(pulled, {}, 1, true).front().points, before);
    pulled.tetrahedra_to_world[3].x = 1;
    EXPECT_NE(lines(pulled, {}, 1, true).front().points,
              TetrahedraLines()({pulled.tetrahedra, glm::dmat4(1)}, {}, 1, true).front().points);
    ui::Palette other{};
    other.lattice = 0xFF123456;
    EXPECT_NE(lines(rest, other, 1, true).front().color, lines(rest, {}, 1, true).front().color);
    EXPECT_EQ(lines(rest, {}, 2, true).front().width_px,
              2 * TetrahedraLines()(rest, {}, 1, true).front().width_px);
}

} // namespace
} // namespace trivar
