// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/silhouette/dash_table.h"
#include "tests/silhouette/scenes.h"
#include "tests/silhouette/true_silhouette.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

TEST(DashTable, HasADashWhereverThereIsASilhouette)
{
    for (const char* function : {"sphere", "gauss"}) {
        const Sampled scene(function, 22);
        const ScalarField<double> exact(std::span<const double>(scene.from.samples),
                                        scene.from.size);
        const FieldHulls hulls(scene.field);
        const DashTable table(scene.field, hulls, static_cast<float>(scene.from.level));
        for (const glm::dvec3& sight : {glm::dvec3(0.3, 0.5, 0.81), glm::dvec3(-1, 0.2, 0.1)}) {
            const ViewPoint view{{sight, 0}};
            const Silhouettes dashes = table(scene.field, view);
            EXPECT_GT(dashes.count(), 25u);
            EXPECT_LE(table.candidates(view), table.cells());
            EXPECT_GE(share_near(true_silhouette(exact, scene.from.level, view), dashes, 1), 0.97)
                << function;
        }
    }
}

TEST(DashTable, WithMoreRowsLooksAtFewerCells)
{
    const Sampled scene("gauss", 32);
    const FieldHulls hulls(scene.field);
    const auto level = static_cast<float>(scene.from.level);
    const ViewPoint view{{0.3, 0.5, 0.81, 0}};
    const DashTable coarse(scene.field, hulls, level, 64), fine(scene.field, hulls, level, 1024);
    EXPECT_LT(fine.candidates(view), coarse.candidates(view));
    EXPECT_GT(fine.bytes(), coarse.bytes());
    EXPECT_EQ(fine(scene.field, view).count(), coarse(scene.field, view).count());
}

TEST(DashTable, IsOfCubicSplinesSeenInParallel)
{
    const Sampled scene("sphere", 12);
    const FieldHulls hulls(scene.field);
    const DashTable table(scene.field, hulls, static_cast<float>(scene.from.level));
    EXPECT_THROW(table(scene.field, {{0, 0, -50, 1}}), Rejected);
    EXPECT_THROW(table(scene.field, {{0, 0, 0, 0}}), Rejected);
    const ScalarField<float> linear(std::span<const float>(scene.samples), scene.from.size,
                                    FieldSpline::interpolating, FieldOrder::linear);
    EXPECT_THROW(DashTable(linear, FieldHulls(linear), 0.5f), Rejected);
}

} // namespace
} // namespace trivar::testing
