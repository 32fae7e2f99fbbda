// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/track.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

Track track_of(std::vector<Key> keys, Repeat repeat = Repeat::once)
{
    return {"x", std::move(keys), repeat};
}

TEST(Track, IsExactAtItsKeysAndStaysBeyondThem)
{
    for (const Tween tween : {Tween::step, Tween::linear, Tween::cubic}) {
        const Track track =
            track_of({{1, 0.1, tween}, {7, 3.3, tween}, {10.5, -2, tween}, {24, 0.7, tween}});
        for (const Key& key : track.keys) EXPECT_EQ(value_at(track, key.frame), key.value);
        EXPECT_EQ(value_at(track, -100), 0.1);
        EXPECT_EQ(value_at(track, 1e6), 0.7);
    }
    EXPECT_EQ(value_at(track_of({{5, 2}}), 3), 2);
}

TEST(Track, StaysOrGoesStraightWhereTheKeySaysSo)
{
    EXPECT_EQ(value_at(track_of({{0, 1, Tween::step}, {10, 5}}), 9.99), 1);
    EXPECT_DOUBLE_EQ(value_at(track_of({{0, 1, Tween::linear}, {10, 5}}), 2.5), 2);
}

TEST(Track, WithoutHandlesGoesBeyondNoKeyAndIsLevelAtTurns)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1, 1), gap(0.2, 9);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<Key> keys;
        double frame = 0;
        for (int i = 0; i < 8; ++i) keys.push_back({frame += gap(random), value(random)});
        const Track track = track_of(keys);
        for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
            const double a = keys[k].value, b = keys[k + 1].value;
            double last = a;
            for (int i = 1; i <= 100; ++i) {
                const double t = i / 100.0;
                const double v = value_at(track, (1 - t) * keys[k].frame + t * keys[k + 1].frame);
                EXPECT_GE(b >= a ? v - last : last - v, -1e-12) << "no way back";
                last = v;
            }
            EXPECT_NEAR(last, b, 1e-12);
        }
    }
    const Track turn = track_of({{0, 0}, {10, 1}, {20, 0}});
    EXPECT_NEAR(value_at(turn, 10.001), 1, 1e-7);
    EXPECT_NEAR(value_at(turn, 5), 0.5, 1e-12) << "eases in and out";
}

TEST(Track, IsSmoothAcrossKeysWithoutHandles)
{
    const Track track = track_of({{0, 0}, {4, 1}, {10, 7}, {11, 8}, {30, 9}});
    for (const double frame : {4.0, 10.0, 11.0}) {
        const double h = 1e-5, at = value_at(track, frame);
        EXPECT_NEAR((value_at(track, frame + h) - at) / h, (at - value_at(track, frame - h)) / h,
                    1e-3);
    }
}

TEST(Track, FollowsHandlesAndMeetsNoFrameTwice)
{
    // A cubic Bezier whose frames are even is the polynomial itself.
    const Track even = track_of({{0, 0, Tween::cubic, {}, {4, 8}}, {12, 0, Tween::cubic, {-4, 8}}});
    EXPECT_NEAR(value_at(even, 6), 6, 1e-9);
    EXPECT_NEAR(value_at(even, 3), 3 * 0.75 * 0.75 * 0.25 * 8 + 3 * 0.75 * 0.0625 * 8, 1e-9);
    const Track far =
        track_of({{0, 0, Tween::cubic, {}, {500, 50}}, {10, 10, Tween::cubic, {-1000, -100}}});
    const TweenCurve curve = curve_between(far, 0);
    EXPECT_EQ(curve.p1, glm::dvec2(10, 1));
    EXPECT_EQ(curve.p2, glm::dvec2(0, 9));
    const Track away =
        track_of({{0, 0, Tween::cubic, {}, {-5, 3}}, {10, 10, Tween::cubic, {5, 3}}});
    EXPECT_EQ(curve_between(away, 0).p1.x, 0);
    EXPECT_EQ(curve_between(away, 0).p2.x, 10);
    for (double frame = 0.1; frame < 10; frame += 0.1) {
        EXPECT_TRUE(std::isfinite(value_at(far, frame)));
        EXPECT_TRUE(std::isfinite(value_at(away, frame)));
    }
}

TEST(Track, SettlesInSwingsThatGetSmaller)
{
    const Track track = track_of({{0, 2, Tween::settle}, {30, 12}});
    EXPECT_EQ(value_at(track, 0), 2);
    EXPECT_EQ(value_at(track, 30), 12);
    const double past = value_at(track, 10) - 12, back = value_at(track, 20) - 12;
    EXPECT_NEAR(past, 1.6, 1e-9);
    EXPECT_NEAR(back / past, past / -10, 1e-9);
    for (double frame = 0.25; frame < 30; frame += 0.25) { // without a jump or a kink
        const double h = 1e-4, at = value_at(track, frame);
        EXPECT_NEAR(value_at(track, frame + h), at, 2 * h);
        EXPECT_NEAR((value_at(track, frame + h) - at) / h, (at - value_at(track, frame - h)) / h,
                    1e-3);
    }
}

TEST(Track, IsItsCubicPiecesWhateverItsTweens)
{
    const Track track = track_of(
        {{0, 0, Tween::step}, {4, 1, Tween::linear}, {10, 7}, {11, 8, Tween::settle}, {30, 9}});
    for (std::size_t k = 0; k + 1 < track.keys.size(); ++k) {
        double frame = track.keys[k].frame;
        for (const TweenCurve& curve : curves_between(track, k)) {
            EXPECT_EQ(curve.p0.x, frame);
            if (curve.p3.x > frame) {
                EXPECT_NEAR(value_at(track, frame), curve.p0.y, 1e-9);
            }
            frame = curve.p3.x;
        }
        EXPECT_EQ(frame, track.keys[k + 1].frame);
    }
}

TEST(Track, IsRepeated)
{
    const std::vector<Key> keys{{2, 0, Tween::linear}, {6, 4}};
    const Track loop = track_of(keys, Repeat::loop), forth = track_of(keys, Repeat::back_and_forth);
    EXPECT_DOUBLE_EQ(value_at(loop, 7), 1);
    EXPECT_DOUBLE_EQ(value_at(loop, 4001), value_at(loop, 5));
    EXPECT_DOUBLE_EQ(value_at(forth, 7), 3);
    EXPECT_DOUBLE_EQ(value_at(forth, 11), 1);
    EXPECT_EQ(value_at(loop, 1), 0);
    EXPECT_EQ(value_at(track_of({{2, 1}}, Repeat::loop), 50), 1);
}

TEST(Track, TakesKeysInOrderAndOneAFrame)
{
    Track track = track_of({{1, 0, Tween::step}, {9, 1}});
    track = with_key(track, 5, 0.5);
    ASSERT_EQ(track.keys.size(), 3u);
    EXPECT_EQ(track.keys[1], (Key{5, 0.5, Tween::step}));
    track = with_key(track, 5, 0.25);
    ASSERT_EQ(track.keys.size(), 3u);
    EXPECT_EQ(track.keys[1].value, 0.25);
    EXPECT_EQ(with_key({"y", {}}, 3, 2).keys, (std::vector<Key>{{3, 2}}));
}

} // namespace
} // namespace trivar
