// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/bezier_cell.h"

#include "tests/support/bezier_values.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::Noise;
using testing::random_volume;

TEST(BezierCells, HoldTheirPieceInTheirBoxAndAgreeWithTheMap)
{
    const auto f =
        random_volume({testing::uneven_knots(3), Knots::periodic(4, 5), Knots::uniform(6, 7)});
    Noise noise;
    for (const BezierCell& cell : bezier_cells(f)) {
        const Box box = bounds(cell);
        const BezierCell part = part_of(cell, {0.2, 0.5, 0}, {0.7, 1, 0.3});
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 x = noise.vec3() * 0.5 + 0.5;
            const glm::dvec3 uvw = glm::mix(cell.lo, cell.hi, x);
            const testing::CellValue c = testing::cell_value(cell, x);
            const auto jet = evaluate(f, uvw, 1);
            EXPECT_LT(glm::distance(c.value, jet.value), 1e-13);
            EXPECT_LT(box.distance(c.value), 1e-14);
            for (int a = 0; a < 3; ++a)
                EXPECT_LT(glm::distance(c.jacobian[a] / (cell.hi - cell.lo)[a],
                                        jet.first[static_cast<std::size_t>(a)]),
                          1e-11);
            EXPECT_LT(glm::distance(testing::cell_value(part, x).value,
                                    evaluate(f, glm::mix(part.lo, part.hi, x)).value),
                      1e-13);
        }
    }
}

} // namespace
} // namespace trivar
