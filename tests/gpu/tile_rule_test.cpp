// SPDX-License-Identifier: GPL-3.0-or-later
// Which tiles a camera sees, and how fine they are to be; without drawing.
#include "gpu/tiles/tile_rule.h"
#include "tests/gpu/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace trivar::gpu::testing {
namespace {

bool hidden_by(const TileRule& rule, const DepthPyramid& pyramid, const Box& box)
{
    const TileHull hull = hull_of({box, 1}, glm::dvec3(0));
    return TileChooser{rule, pyramid.depths()}.hidden(hull.lo, hull.hi);
}

TEST(TileRules, SeesWhatProjectsIntoThePicture)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-6, 6);
    for (const bool perspective : {true, false}) {
        Camera camera;
        camera.perspective = perspective;
        const glm::dmat4 to_world = glm::rotate(moved(0.5, 1, 0), 0.4, {1, 2, 3});
        const glm::dvec3 origin(1, 2, 3);
        const TileRule rule = rule_of(camera, to_world, origin, false, {{nullptr, 0}});
        TileChooser chooser{rule};
        int seen = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 p(place(random), place(random), place(random));
            const PicturePoint at = project(camera, glm::dvec3(to_world * glm::dvec4(p, 1)));
            const bool inside = at.depth_world > 0 && at.p_px.x > 0 && at.p_px.y > 0 &&
                                at.p_px.x < camera.size_px.x && at.p_px.y < camera.size_px.y;
            const TileHull box = hull_of({{p - 0.01, p + 0.01}, 1}, origin);
            seen += inside;
            if (inside) {
                EXPECT_TRUE(chooser.in_view(box.lo, box.hi));
                const double pixel = pixel_size_world(camera, at.depth_world);
                EXPECT_LT(chooser.tolerance_for(box.lo, box.hi), 2 * pixel);
                EXPECT_GT(chooser.tolerance_for(box.lo, box.hi), 0.4 * pixel);
            }
            const bool far_out = at.depth_world > 0.1 && (at.p_px.x < -50 || at.p_px.y < -50 ||
                                                          at.p_px.x > camera.size_px.x + 50);
            EXPECT_FALSE(far_out && chooser.in_view(box.lo, box.hi));
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
        const TileRule rule = with_pyramid({}, size, matrix, glm::dmat4(1), glm::dvec3(0));
        const glm::dvec3 lo(share(random), share(random), 0.35 + 0.3 * share(random));
        const glm::dvec3 extent(share(random), share(random), 0.2);
        const Box box{lo, lo + 0.4 * extent};
        const glm::dvec2 there = (glm::dvec2(hole) + 0.5) / glm::dvec2(size);
        const bool open =
            there.x > box.lo.x && there.y > box.lo.y && there.x < box.hi.x && there.y < box.hi.y;
        const bool hides = hidden_by(rule, pyramid, box);
        hidden += hides;
        EXPECT_FALSE(hides && (open || lo.z < 0.4));
    }
    EXPECT_GT(hidden, 50);
    glm::dmat4 behind = matrix;
    behind[3].w = -1;
    const auto rule_with = [](glm::ivec2 size_px, const glm::dmat4& clip) {
        return with_pyramid({}, size_px, clip, glm::dmat4(1), glm::dvec3(0));
    };
    const DepthPyramid nearest({0, 0, 0, 0}, {2, 2});
    const Box box{glm::dvec3(0.2), glm::dvec3(0.6)};
    EXPECT_TRUE(hidden_by(rule_with({2, 2}, matrix), nearest, box));
    EXPECT_FALSE(hidden_by(rule_with({2, 2}, behind), nearest, box));
    EXPECT_FALSE(hidden_by(rule_with({0, 0}, matrix), {}, box));
}

TEST(TileRules, KeepsALevelUntilAnotherIsClearlyBetter)
{
    const TileRule rule = rule_of({}, glm::dmat4(1), glm::dvec3(0), true,
                                  {{nullptr, 0}, {nullptr, 0.001}, {nullptr, 0.01}});
    TileChooser chooser{rule};
    const auto level_for = [&](float tolerance, int before) {
        return chooser.level_for(1, tolerance, before);
    };
    EXPECT_EQ(level_for(0.0105f, chooser.UNSEEN), 2);
    EXPECT_EQ(level_for(0.0105f, 1), 1);
    EXPECT_EQ(level_for(0.014f, 1), 2);
    EXPECT_EQ(level_for(0.0095f, chooser.UNSEEN), 1);
    EXPECT_EQ(level_for(0.0095f, 2), 2);
    EXPECT_EQ(level_for(0.007f, 2), 1);
    EXPECT_EQ(level_for(0.0f, 2), 0);
}

} // namespace
} // namespace trivar::gpu::testing
