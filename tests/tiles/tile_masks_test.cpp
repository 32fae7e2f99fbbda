// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_masks.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

// The middles of its two by two pixels are at 1/4 and 3/4.
Ref<GreyImage> four_pixels()
{
    return make_ref(GreyImage{{2, 2}, {0.0f, 1.0f, 0.5f, 0.25f}});
}

ReadyMask image_mask(MaskLies lies)
{
    ReadyMask mask;
    mask.mask.from = MaskFrom::image;
    mask.mask.lies = lies;
    mask.image = four_pixels();
    return mask;
}

const Box unit_box{{0, 0, 0}, {1, 1, 1}};

TEST(TileMask, ReadsAnImageBetweenThePixelsAndRepeatsIt)
{
    ReadyMask mask = image_mask(MaskLies::uv);
    const auto at = [&](double u, double v) {
        return mask_value(mask, unit_box, {.uv = glm::dvec2(u, v)}).value();
    };
    EXPECT_EQ(at(0.25, 0.75), 0); // the first row is the upper one
    EXPECT_EQ(at(0.75, 0.75), 1);
    EXPECT_EQ(at(0.25, 0.25), 0.5);
    EXPECT_EQ(at(0.5, 0.75), 0.5);
    EXPECT_EQ(at(0, 0.3), at(1, 0.3)); // both between the last column and the first one
    EXPECT_EQ(at(-0.75, 2.75), at(0.25, 0.75));
    mask.mask.repeat_u = 2;
    mask.mask.shift_v = 0.5;
    EXPECT_EQ(at(0.125, 0.25), 0);
    mask.mask.inverted = true;
    EXPECT_EQ(at(0.125, 0.25), 1);
    EXPECT_FALSE(mask_value(mask, unit_box, {})); // without texture coordinates it does nothing
}

TEST(TileMask, IsRightSideUpSeenFromEachSide)
{
    const auto at = [](MaskLies lies, glm::dvec3 p, glm::dvec3 n) {
        return mask_value(image_mask(lies), unit_box, {p, n, {}}).value();
    };
    // The white pixel is the upper one at the right hand of who looks.
    EXPECT_EQ(at(MaskLies::along_z, {0.75, 0.75, 0}, {0, 0, -1}), 1);
    EXPECT_EQ(at(MaskLies::along_y, {0.75, 0, 0.75}, {0, 0, 1}), 1);
    EXPECT_EQ(at(MaskLies::along_x, {0, 0.75, 0.75}, {0, 0, 1}), 1);
    const MaskLies six = MaskLies::from_six_sides;
    EXPECT_EQ(at(six, {0.75, 0.75, 1}, {0, 0.1, 1}), 1);
    EXPECT_EQ(at(six, {0.75, 0, 0.75}, {0, -1, 0.2}), 1);
    EXPECT_EQ(at(six, {0.25, 1, 0.75}, {0, 1, 0.2}), 1);
    EXPECT_EQ(at(six, {1, 0.75, 0.75}, {1, 0, 0}), 1);
    EXPECT_EQ(at(six, {0, 0.25, 0.75}, {-1, 0, 0}), 1);
}

TEST(TileMask, GoesAlongALineAndRoundAPoint)
{
    ReadyMask line{{.from = MaskFrom::line, .begin = {1, 0, 0}, .end = {3, 0, 0}}};
    const auto along = [&](double x) {
        return mask_value(line, unit_box, {.p = {x, 7, -2}}).value();
    };
    EXPECT_EQ(along(0), 0);
    EXPECT_EQ(along(1.5), 0.25);
    EXPECT_EQ(along(9), 1);
    line.mask.easing = MaskEasing::smooth;
    EXPECT_EQ(along(1.5), 0.25 * 0.25 * 2.5);
    const ReadyMask round{{.from = MaskFrom::point, .begin = {1, 1, 0}, .start = 0.5, .stop = 1.5}};
    const auto near = [&](double x) {
        return mask_value(round, unit_box, {.p = {x, 1, 0}}).value();
    };
    EXPECT_EQ(near(1.5), 1);
    EXPECT_EQ(near(0.25), 0.75);
    EXPECT_EQ(near(4), 0);
    const ReadyMask nowhere{{.from = MaskFrom::line, .begin = {1, 0, 0}, .end = {1, 0, 0}}};
    EXPECT_EQ(mask_value(nowhere, unit_box, {}), 0);
}

TEST(LineDistance, IsThatToTheNearestPiece)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto point = [&] { return glm::dvec3(any(random), any(random), any(random)); };
    std::vector<glm::dvec3> one, other;
    for (int i = 0; i < 50; ++i) one.push_back(point());
    for (int i = 0; i < 9; ++i) other.push_back(point() + glm::dvec3(2, 0, 0));
    LineDistance lines;
    lines.add(one);
    lines.add(other);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = 3.0 * point();
        double least = 1e300; // of many points of each piece
        for (const auto* line : {&one, &other})
            for (std::size_t k = 0; k + 1 < line->size(); ++k)
                for (int s = 0; s <= 400; ++s)
                    least = std::min(
                        least, glm::distance(p, glm::mix((*line)[k], (*line)[k + 1], s / 400.0)));
        EXPECT_LE(lines.to(p), least + 1e-12);
        EXPECT_GT(lines.to(p), least - 0.01);
    }
    EXPECT_GT(LineDistance().to({0, 0, 0}), 1e300);
}

TEST(TileMasks, MultiplyWhatTheyDrive)
{
    TileMasks masks{{{{.drives = MaskDrives::height, .low = 2, .high = 4}},
                     {{.drives = MaskDrives::height, .low = 0.5, .high = 0.5}},
                     {{.drives = MaskDrives::scale, .high = 3}},
                     {{.drives = MaskDrives::density, .hidden = true}}},
                    unit_box};
    EXPECT_EQ(masks.at({.p = {0, 0, 0.5}}), (MaskFactors{1, 1.5, 1.5}));
    EXPECT_TRUE(masks.drive(MaskDrives::scale));
    EXPECT_FALSE(masks.drive(MaskDrives::density));
}

TEST(TileMasks, LetTilesComeOneByOneAndStay)
{
    int before = 0;
    for (const double density : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        int there = 0;
        for (std::uint32_t seed = 0; seed < 1000; ++seed) {
            there += is_there(seed, density);
            EXPECT_TRUE(is_there(seed, density) || !is_there(seed, density / 2));
        }
        EXPECT_NEAR(there, 1000 * density, 40);
        EXPECT_GE(there, before);
        before = there;
    }
    EXPECT_EQ(before, 1000);
}

} // namespace
} // namespace trivar
