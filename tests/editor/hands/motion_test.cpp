// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/motion.h"

#include "editor/hands/hand_motion.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double most = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) most = std::max(most, std::abs(a[i][j] - b[i][j]));
    return most;
}

class Any {
public:
    double number(double lo, double hi)
    {
        return std::uniform_real_distribution<double>(lo, hi)(random_);
    }
    glm::dvec3 vector(double reach)
    {
        return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
    }
    glm::dmat3 axes()
    {
        return glm::dmat3(Transform{.translation = {}, .rotation_deg = vector(180)}.matrix());
    }
    // In a group that is turned, moved and evenly scaled, as nearly all are.
    Stand stand()
    {
        const Transform group{vector(5), vector(180), glm::dvec3(number(0.2, 4))};
        const Transform own{vector(5), vector(80), {number(0.2, 4), number(0.2, 4), -1.5}};
        return {1, own, group.matrix()};
    }
    Camera camera(bool perspective)
    {
        Camera c;
        c.eye = glm::normalize(vector(1)) * number(4, 20);
        c.target = vector(1);
        c.perspective = perspective;
        return c;
    }

private:
    std::mt19937 random_{2026};
};

glm::dmat4 world(const Stand& stand, const Transform& t)
{
    return stand.parent_to_world * t.matrix();
}
glm::dmat4 about(const MotionFrame& frame, const glm::dmat4& inside)
{
    const glm::dmat4 to = glm::translate(glm::dmat4(1), frame.pivot) * glm::dmat4(frame.axes);
    return to * inside * glm::inverse(to);
}

TEST(Motion, DoesInTheWorldWhatItSaysWhateverGroupsTheObjectIsIn)
{
    Any any;
    for (int i = 0; i < 200; ++i) {
        const Stand stand = any.stand();
        const MotionFrame frame{any.vector(3), any.axes()};
        const Motion move{.kind = MotionKind::move, .offset = any.vector(4)};
        EXPECT_LT(difference(world(stand, moved(stand, move, frame)),
                             about(frame, glm::translate(glm::dmat4(1), move.offset)) *
                                 world(stand, stand.transform)),
                  1e-8);
        const Motion turn{.kind = MotionKind::rotate,
                          .angle_deg = any.number(-170, 170),
                          .turn_axis = glm::normalize(any.vector(1))};
        EXPECT_LT(difference(world(stand, moved(stand, turn, frame)),
                             about(frame, glm::rotate(glm::dmat4(1), glm::radians(turn.angle_deg),
                                                      turn.turn_axis)) *
                                 world(stand, stand.transform)),
                  1e-7);
        const double f = any.number(-3, 3);
        const Motion grow{.kind = MotionKind::scale, .factors = glm::dvec3(f)};
        EXPECT_LT(difference(world(stand, moved(stand, grow, frame)),
                             about(frame, glm::scale(glm::dmat4(1), glm::dvec3(f))) *
                                 world(stand, stand.transform)),
                  1e-8);
    }
}

TEST(Motion, LeavesWhatItDoesNotChangeToTheBit)
{
    Any any;
    const Stand stand = any.stand();
    const MotionFrame frame{{1, 2, 3}, any.axes()};
    const Transform a = moved(stand, {.kind = MotionKind::move, .offset = {1, 2, 3}}, frame);
    EXPECT_EQ(a.rotation_deg, stand.transform.rotation_deg);
    EXPECT_EQ(a.scale, stand.transform.scale);
    const Transform b = moved(stand, {.kind = MotionKind::rotate, .angle_deg = 33}, frame);
    EXPECT_EQ(b.scale, stand.transform.scale);
    const Transform c = moved(stand, {.kind = MotionKind::scale, .factors = {2, 1, 3}}, frame);
    EXPECT_EQ(c.rotation_deg, stand.transform.rotation_deg);
    const MotionFrame own{stand.origin_world(), glm::dmat3(1)};
    EXPECT_EQ(moved(stand, {.kind = MotionKind::rotate, .angle_deg = 33}, own).translation,
              stand.transform.translation);
    for (const MotionKind kind : {MotionKind::move, MotionKind::rotate, MotionKind::scale})
        EXPECT_EQ(moved(stand, {.kind = kind}, frame), stand.transform);
}

TEST(Motion, GivesTheNumbersThatAPersonWouldType)
{
    const Stand stand{1, {.translation = {1, 0, 0}}, glm::dmat4(1)};
    const Transform turned =
        moved(stand, {.kind = MotionKind::rotate, .angle_deg = 90}, MotionFrame{});
    EXPECT_EQ(turned.rotation_deg, glm::dvec3(0, 0, 90));
    EXPECT_EQ(turned.translation, glm::dvec3(0, 1, 0));
    const Transform grown =
        moved(stand, {.kind = MotionKind::scale, .factors = {2, 1, 1}}, MotionFrame{});
    EXPECT_EQ(grown.scale, glm::dvec3(2, 1, 1));
    EXPECT_EQ(grown.translation, glm::dvec3(2, 0, 0));
    const Transform along =
        moved(stand, {.kind = MotionKind::move, .offset = {0.1, 0.2, 0}}, MotionFrame{});
    EXPECT_EQ(along.translation, glm::dvec3(1.1, 0.2, 0));
}

TEST(Motion, ScalesATurnedObjectAlongItsOwnAxesAndNeverShearsIt)
{
    const Stand stand{1, {.translation = {}, .rotation_deg = {0, 0, 90}}, glm::dmat4(1)};
    const Transform t =
        moved(stand, {.kind = MotionKind::scale, .factors = {3, 1, 1}}, MotionFrame{});
    EXPECT_EQ(t.scale, glm::dvec3(1, 3, 1)) << "its own Y lies along the world's X";
}

TEST(HandMotion, KeepsWhatIsDraggedUnderTheMouse)
{
    Any any;
    for (int i = 0; i < 200; ++i) {
        const Camera camera = any.camera(i % 2 == 0);
        const glm::dvec3 pivot = any.vector(1), d = glm::normalize(any.vector(1));
        const glm::dvec2 from = project(camera, pivot).p_px;
        const double along = any.number(-0.5, 0.5);
        const glm::dvec2 to = project(camera, pivot + d * along).p_px;
        if (std::abs(glm::dot(d, toward_eye(camera, pivot))) < 0.9) {
            EXPECT_NEAR(dragged_along(camera, pivot, d, from, to), along, 1e-6);
        }
        const glm::dvec2 anywhere = from + glm::dvec2(any.number(-90, 90), any.number(-90, 90));
        const glm::dvec3 across = dragged_across(camera, pivot, from, anywhere);
        EXPECT_LT(glm::distance(project(camera, pivot + across).p_px, anywhere), 1e-6);
        if (std::abs(glm::dot(d, toward_eye(camera, pivot))) < 0.4) continue;
        const glm::dvec3 in = dragged_in_plane(camera, pivot, d, from, anywhere);
        EXPECT_NEAR(glm::dot(in, d), 0, 1e-6);
        if (project(camera, pivot + in).depth_world > 0.1) {
            EXPECT_LT(glm::distance(project(camera, pivot + in).p_px, anywhere), 1e-3);
        }
    }
}

TEST(HandMotion, TurnsAsTheMouseGoesRoundFromWhicheverSideItIsSeen)
{
    for (const double side : {-1.0, 1.0}) {
        Camera camera;
        camera.eye = {0, 0, 10 * side};
        camera.target = {0, 0, 0};
        const glm::dvec2 from = project(camera, {1, 0, 0}).p_px;
        const glm::dvec2 to = project(camera, {0, 1, 0}).p_px;
        EXPECT_NEAR(swept_deg(camera, {0, 0, 0}, {0, 0, 1}, from, to), 90, 1e-9);
        EXPECT_NEAR(swept_deg(camera, {0, 0, 0}, {0, 0, 1}, to, from), -90, 1e-9);
    }
    Camera slanted;
    const glm::dvec3 pivot{0.2, 0.1, 0};
    const auto at = [&](double deg) {
        const double a = glm::radians(deg);
        return project(slanted, pivot + glm::dvec3(std::cos(a), std::sin(a), 0)).p_px;
    };
    for (const double deg : {-170.0, -33.0, 5.0, 90.0})
        EXPECT_NEAR(followed_deg(slanted, pivot, {0, 0, 1}, at(20), at(20 + deg)), deg, 1e-9);
    Camera front; // the ring about Z is seen from its edge; its near side moves to the right
    front.eye = {0, -10, 0};
    front.target = {0, 0, 0};
    EXPECT_NEAR(rolled_deg(front, {0, 0, 1}, 100, {0, 0}, {100, 7}), 57.29577951308232, 1e-9);
}

TEST(HandMotion, GrowsByTheDistanceFromThePivotAndNeverFails)
{
    Camera camera;
    const glm::dvec2 center = project(camera, {0, 0, 0}).p_px;
    const auto grown = [&](glm::dvec2 from, glm::dvec2 to) {
        return grown_by(camera, {0, 0, 0}, 100, center + from, center + to);
    };
    EXPECT_NEAR(grown({100, 0}, {200, 55}), 2, 1e-12);
    EXPECT_NEAR(grown({100, 0}, {-50, 0}), -0.5, 1e-12);
    EXPECT_NEAR(grown({0, 0}, {100, 0}), 2, 1e-12);
    EXPECT_NEAR(grown({0, 0}, {0, -100}), 2, 1e-12);
    // A line that points at the eye follows the drag upward.
    const glm::dvec3 at_eye = toward_eye(camera, {0, 0, 0});
    EXPECT_GT(dragged_along(camera, {0, 0, 0}, at_eye, center, center - glm::dvec2(0, 50)), 0);
}

} // namespace
} // namespace trivar
