// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_drawing.h"
#include "core/lines/stroke_ends.h"
#include "core/lines/strokes.h"
#include "core/silhouette/visibility.h"
#include "tests/silhouette/scenes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace trivar::testing {
namespace {

struct Drawn {
    Drawn(const std::string& function, LevelSide side, const glm::dvec3& sight,
          const StrokeOptions& options)
        : scene(function, 48),
          hulls(scene.field),
          silhouettes(SilhouetteFinder()(scene.field, scene.level(), {glm::dvec4(sight, 0)})),
          hidden(hidden_points(silhouettes, {glm::dvec4(sight, 0)},
                               {scene.field, hulls, static_cast<float>(scene.from.level), side})),
          lines(strokes(silhouettes, hidden, image_of(sight), options))
    {
    }
    double length(bool hidden_ones) const
    {
        double out = 0;
        for (const Stroke& line : lines)
            if (line.hidden == hidden_ones) out += line.length();
        return out;
    }
    Sampled scene;
    FieldHulls hulls;
    Silhouettes silhouettes;
    std::vector<char> hidden;
    std::vector<Stroke> lines;
};

constexpr StrokeOptions all_of_them{.join = 1e-3f, .shortest = 0};
const glm::dvec3 oblique(0.5, 0.6, -0.35);

TEST(Strokes, OfABallAreOneLoop)
{
    const Drawn drawn("sphere", LevelSide::below, oblique, {});
    ASSERT_EQ(drawn.lines.size(), 1u);
    EXPECT_TRUE(drawn.lines[0].is_loop());
    EXPECT_FALSE(drawn.lines[0].hidden || drawn.lines[0].tapers_first);
    const double radius = 4 * 0.7 / drawn.scene.from.spacing;
    EXPECT_NEAR(drawn.lines[0].length(), 2 * std::numbers::pi * radius, 0.1);
    for (const StrokePoint& p : drawn.lines[0].points)
        EXPECT_NEAR(glm::distance(glm::dvec2(p.at),
                                  glm::dvec2(500) + 23.5 * glm::dvec2(image_of(oblique) *
                                                                      glm::dvec4(1, 1, 1, 0))),
                    radius, 0.05);
}

// The eye is in the middle of the volume, so that half of it lies behind.
TEST(Strokes, BehindTheEyeAreNone)
{
    const Sampled scene("waves", 48);
    const Box box{glm::dvec3(0), glm::dvec3(47)};
    Camera camera;
    camera.eye = glm::dvec3(23.5);
    camera.target = camera.eye + oblique;
    camera.perspective = true;
    camera.size_px = {800, 600};
    const DrawingView view = drawing_view(camera, glm::dmat4(1), box);
    const Silhouettes all = SilhouetteFinder()(scene.field, scene.level(), view.from);
    const std::vector<char> hidden(all.points.size(), 0);
    const auto depth = [&](const glm::vec3& p) {
        return glm::dot(glm::dvec3(p) - camera.eye, glm::normalize(oblique));
    };
    const auto behind = std::ranges::count_if(
        all.points, [&](const SilhouettePoint& point) { return depth(point.p) < 0; });
    ASSERT_GT(behind, 100) << all.points.size();
    ASSERT_LT(behind, static_cast<std::ptrdiff_t>(all.points.size()) - 100);
    std::size_t points = 0;
    for (const Stroke& line : strokes(all, hidden, view.to_image, all_of_them)) {
        points += line.points.size();
        for (const StrokePoint& point : line.points) {
            EXPECT_GT(depth(point.p), -0.5);
            EXPECT_LT(glm::length(point.at), 100'000);
        }
    }
    EXPECT_GT(points, 100u);
    EXPECT_LT(points, 1'000'000u);
}

TEST(Strokes, AreAllOfTheCurvesSeenOrHidden)
{
    for (const auto& [function, side] :
         {std::pair{"torus", LevelSide::below}, std::pair{"gauss", LevelSide::above}}) {
        const Drawn drawn(function, side, oblique, all_of_them);
        double length = 0;
        const glm::dmat4 to_image = image_of(oblique);
        for (std::size_t c = 0; c < drawn.silhouettes.count(); ++c)
            for (std::uint32_t i = drawn.silhouettes.first[c]; i < drawn.silhouettes.first[c + 1];
                 ++i) {
                const bool last = i + 1 == drawn.silhouettes.first[c + 1];
                if (last && !drawn.silhouettes.closed[c]) continue;
                const std::uint32_t j = last ? drawn.silhouettes.first[c] : i + 1;
                length += glm::length(
                    glm::dvec2(to_image * glm::dvec4(glm::dvec3(drawn.silhouettes.points[i].p) -
                                                         glm::dvec3(drawn.silhouettes.points[j].p),
                                                     0)));
            }
        EXPECT_NEAR(drawn.length(false) + drawn.length(true), length, 0.01 * length) << function;
        EXPECT_GT(drawn.length(true), 0.02 * length) << function;
    }
}

// A torus that is seen from above at an angle shows its outer line, the near part of the inner one
// and, through the hole, some of the far part.
TEST(Strokes, OfARingEndWhereItHidesThem)
{
    const Drawn drawn("torus", LevelSide::below, {0, 1, -0.5}, {});
    std::size_t seen = 0, loops = 0;
    for (const Stroke& line : drawn.lines) {
        seen += !line.hidden;
        loops += !line.hidden && line.is_loop();
    }
    EXPECT_EQ(loops, 1u);
    EXPECT_EQ(seen, 3u);
}

Stroke line(std::vector<glm::vec2> points)
{
    Stroke out;
    for (const glm::vec2& p : points) out.points.push_back({.at = p});
    return out;
}

TEST(Strokes, ThatFaceEachOtherAreJoined)
{
    const std::vector<Stroke> one =
        joined({line({{0, 0}, {10, 0}, {20, 0}}), line({{40, 1}, {30, 1}, {23, 0}})}, 6);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].points.size(), 6u);
    EXPECT_TRUE(one[0].tapers_first && one[0].tapers_last);
    const std::vector<Stroke> side_by_side =
        joined({line({{0, 0}, {10, 0}, {20, 0}}), line({{0, 3}, {10, 3}, {20, 3}})}, 6);
    EXPECT_EQ(side_by_side.size(), 2u);
    Stroke behind = line({{23, 0}, {30, 1}, {40, 1}});
    behind.hidden = true;
    EXPECT_EQ(joined({line({{0, 0}, {10, 0}, {20, 0}}), behind}, 6).size(), 2u);
    const std::vector<Stroke> loop =
        joined({line({{0, 10}, {0, 5}, {0, 0}, {20, 0}, {20, 5}, {20, 10}}),
                line({{20, 12}, {20, 16}, {20, 20}, {0, 20}, {0, 16}, {0, 12}})},
               6);
    ASSERT_EQ(loop.size(), 1u);
    EXPECT_TRUE(loop[0].is_loop());
    EXPECT_FALSE(loop[0].tapers_first || loop[0].tapers_last);
}

TEST(Strokes, DoNotTaperWhereTheyMeetOthers)
{
    Stroke wall = line({{0, 0}, {0, 201}, {0, 202.5f}, {0, 400}}),
           corner = line({{1, 0.5}, {50, 0}}), onto = line({{100, 203}, {1.5f, 203}}),
           free = line({{10, 100}, {60, 100}}), behind = line({{60, 101}, {90, 101}});
    behind.hidden = true;
    const std::vector<Stroke*> all{&wall, &corner, &onto, &free, &behind};
    hold_ends(all, 2);
    EXPECT_FALSE(wall.tapers_first);
    EXPECT_TRUE(wall.tapers_last);
    EXPECT_FALSE(corner.tapers_first);
    EXPECT_TRUE(corner.tapers_last);
    EXPECT_TRUE(onto.tapers_first);
    EXPECT_FALSE(onto.tapers_last);
    EXPECT_TRUE(free.tapers_first && free.tapers_last) << "what is hidden holds nothing seen";
    EXPECT_FALSE(behind.tapers_first);
    EXPECT_TRUE(behind.tapers_last);
}

} // namespace
} // namespace trivar::testing
