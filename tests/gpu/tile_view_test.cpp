// SPDX-License-Identifier: GPL-3.0-or-later
// Which tiles a camera sees, and how fine they are to be; without drawing.
#include "gpu/tiles/depth_pyramid.h"
#include "gpu/tiles/tile_view.h"
#include "tests/gpu/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace trivar::gpu::testing {
namespace {

TEST(TileView, SeesWhatProjectsIntoThePicture)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-6, 6);
    for (const bool perspective : {true, false}) {
        Camera camera;
        camera.perspective = perspective;
        const glm::dmat4 to_world = glm::rotate(moved(0.5, 1, 0), 0.4, {1, 2, 3});
        const TileView view(camera, to_world, false);
        int seen = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 p(place(random), place(random), place(random));
            const PicturePoint at = project(camera, glm::dvec3(to_world * glm::dvec4(p, 1)));
            const bool inside = at.depth_world > 0 && at.p_px.x > 0 && at.p_px.y > 0 &&
                                at.p_px.x < camera.size_px.x && at.p_px.y < camera.size_px.y;
            const Box box{p - 0.01, p + 0.01};
            seen += inside;
            if (inside) {
                EXPECT_TRUE(view.sees(box));
                const double pixel = pixel_size_world(camera, at.depth_world);
                EXPECT_LT(view.tolerance(box), 0.5 * pixel);
                EXPECT_GT(view.tolerance(box), 0.1 * pixel);
            }
            const bool far_out = at.depth_world > 0.1 && (at.p_px.x < -50 || at.p_px.y < -50 ||
                                                          at.p_px.x > camera.size_px.x + 50);
            EXPECT_FALSE(far_out && view.sees(box));
        }
        EXPECT_GT(seen, 100);
    }
}

TEST(DepthPyramid, HidesNoBoxOfWhichSomethingIsNearer)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    constexpr glm::ivec2 size(37, 21);
    const auto to_clip = [](const glm::dvec3& p) { return 2.0 * p - 1.0; }; // 0..1 is the picture
    const glm::dmat4 matrix =
        glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(-1)), glm::dvec3(2));
    ASSERT_EQ(glm::dvec3(matrix * glm::dvec4(0.3, 0.4, 0.5, 1)), to_clip({0.3, 0.4, 0.5}));
    int hidden = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<float> depths;
        for (int k = 0; k < size.x * size.y; ++k)
            depths.push_back(static_cast<float>(0.4 + 0.1 * share(random)));
        const glm::ivec2 hole(static_cast<int>(share(random) * size.x),
                              static_cast<int>(share(random) * size.y));
        depths[static_cast<std::size_t>(hole.y * size.x + hole.x)] = 1;
        const DepthPyramid pyramid(depths, size);
        const glm::dvec3 lo(share(random), share(random), 0.35 + 0.3 * share(random));
        const glm::dvec3 extent(share(random), share(random), 0.2);
        const Box box{lo, lo + 0.4 * extent};
        const glm::dvec2 there = (glm::dvec2(hole) + 0.5) / glm::dvec2(size);
        const bool open =
            there.x > box.lo.x && there.y > box.lo.y && there.x < box.hi.x && there.y < box.hi.y;
        const bool hides = pyramid.hides(box, matrix);
        hidden += hides;
        EXPECT_FALSE(hides && (open || lo.z < 0.4));
    }
    EXPECT_GT(hidden, 50);
    glm::dmat4 behind = matrix;
    behind[3].w = -1;
    EXPECT_FALSE(
        DepthPyramid({0, 0, 0, 0}, {2, 2}).hides({glm::dvec3(0.2), glm::dvec3(0.6)}, behind));
    EXPECT_FALSE(DepthPyramid().hides({glm::dvec3(0.2), glm::dvec3(0.6)}, matrix));
}

TEST(TileView, KeepsALevelUntilAnotherIsClearlyBetter)
{
    const std::vector<TileLevel> levels{{nullptr, 0}, {nullptr, 0.001}, {nullptr, 0.01}};
    EXPECT_EQ(level_for(levels, 1, 0.0105), 2u);
    EXPECT_EQ(level_for(levels, 1, 0.0105, 1), 1u);
    EXPECT_EQ(level_for(levels, 1, 0.014, 1), 2u);
    EXPECT_EQ(level_for(levels, 1, 0.0095), 1u);
    EXPECT_EQ(level_for(levels, 1, 0.0095, 2), 2u);
    EXPECT_EQ(level_for(levels, 1, 0.007, 2), 1u);
    EXPECT_EQ(level_for(levels, 1, 0, 2), 0u);
}

} // namespace
} // namespace trivar::gpu::testing
