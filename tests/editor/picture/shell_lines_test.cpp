// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/lattice.h"
#include "editor/picture/volume_picture.h"

#include "editor/session/session_facts.h"
#include "tests/editor/rig.h"

#include <algorithm>

namespace trivar {
namespace {

Lattice box_of_points(const glm::ivec3& n)
{
    return lattice_at_rest({Knots::uniform(2, n.x), Knots::uniform(2, n.y), Knots::uniform(2, n.z)},
                           glm::dmat4(1));
}

TEST(ShellLines, RunAlongTheTwelveEdgesAndOnTheSidesButNeverWithin)
{
    const std::vector<gpu::Line> lines = shell_lines(box_of_points({4, 3, 5}), 0xFFFFFFFF, 1);
    EXPECT_EQ(lines.size(), 12u + 2 * (1 + 2 + 3) + 2 * (1 + 2 + 3));
    for (const gpu::Line& line : lines)
        for (const glm::vec3& p : line.points)
            EXPECT_TRUE(std::min({p.x, p.y, p.z}) == 0 || std::max({p.x, p.y, p.z}) == 1);
}

TEST(ShellLines, AreTheEdgesAloneWhereTheSidesAreLeftOut)
{
    EXPECT_EQ(shell_lines(box_of_points({9, 9, 9}), 0xFFFFFFFF, 1, {.sides = 0}).size(), 12u);
}

TEST(ShellLines, OfALatticeAreInTheViewThatFramesIt)
{
    testing::Rig rig;
    rig.two_objects();
    ASSERT_TRUE(rig.editor.session.run(AddLattice{
        .objects = {2}, .shape = {.size = {2, 3, 4}}, .transform = {.translation = {0, 0, 1}}}));
    rig.wait();
    Box framed;
    for (const glm::dvec3& p : points_of(rig.editor.session, {3})) framed.add(p);
    EXPECT_NEAR(framed.size().y, 3, 1e-9);
    EXPECT_NEAR(framed.size().z, 4, 1e-9);
}

TEST(VolumesInPictures, AreNotThoseOfWhatWasDeletedSinceItWasEvaluated)
{
    testing::Rig rig;
    rig.two_objects();
    ASSERT_TRUE(rig.editor.session.run(AddLattice{.objects = {2}}));
    rig.wait();
    TetrahedraLines none;
    const auto lines = [&](const Document& document) {
        gpu::Picture picture;
        add_volumes(picture, rig.editor.session.evaluated(), document, none,
                    rig.screen.theme().color, 1);
        return picture.lines.size();
    };
    EXPECT_GT(lines(rig.editor.session.document()), 0u);
    EXPECT_EQ(lines({}), 0u);
}

} // namespace
} // namespace trivar
