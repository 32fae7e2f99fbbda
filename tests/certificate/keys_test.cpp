// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of exported animations, read as the rules of glTF say.
#include "core/certificate/film.h"
#include "core/certificate/kept_clip.h"
#include "core/certificate/keys.h"

#include "core/base/rejected.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

using ::testing::ElementsAre;

TEST(ChosenKeys, AreTheFirstTheLastAndNoMoreThanAreNeededBetween)
{
    for (const std::size_t count : {1u, 2u, 3u, 10u, 100u, 1000u})
        for (const std::size_t reach : {1u, 2u, 7u, 64u, 5000u}) {
            std::size_t asked = 0;
            const std::vector<std::size_t> keys =
                chosen_keys(count, [&](std::size_t from, std::size_t to) {
                    ++asked;
                    return to - from <= reach;
                });
            EXPECT_EQ(keys.front(), 0u);
            EXPECT_EQ(keys.back(), count - 1);
            for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
                EXPECT_LE(keys[k + 1] - keys[k], reach);
                if (k + 2 < keys.size()) { // as far as can be
                    EXPECT_EQ(keys[k + 1] - keys[k], reach);
                }
            }
            EXPECT_LE(asked, 30 * keys.size());
        }
}

TEST(ChosenKeys, AreAllWhereNoneCanBeLeftOut)
{
    EXPECT_THAT(chosen_keys(4, [](std::size_t, std::size_t) { return false; }),
                ElementsAre(0, 1, 2, 3));
}

TEST(TimesOfKeys, AreOnTheirSideAndTheNearestThere)
{
    std::mt19937 dice(3);
    std::uniform_real_distribution<double> times(-1e4, 1e4);
    constexpr float endless = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 1000; ++i) {
        const double t = times(dice);
        const float before = not_after(t), after = not_before(t);
        EXPECT_LE(double{before}, t);
        EXPECT_GE(double{after}, t);
        EXPECT_GT(double{std::nextafter(before, endless)}, t);
        EXPECT_LT(double{std::nextafter(after, -endless)}, t);
    }
    EXPECT_EQ(not_after(0.5), 0.5f);
    EXPECT_EQ(not_before(0.5), 0.5f);
}

// The place of a node at a time, by its channels.
glm::dmat4 shown_at(const NodeMotion& motion, double time_s)
{
    NodeTransform at = motion.first;
    for (const Channel& channel : motion.channels) {
        const std::vector<double> v = value_at(channel, time_s);
        if (channel.of == Channel::Of::translation) at.translation = {v[0], v[1], v[2]};
        if (channel.of == Channel::Of::rotation) at.rotation = {v[3], v[0], v[1], v[2]};
        if (channel.of == Channel::Of::scale) at.scale = {v[0], v[1], v[2]};
    }
    return at.matrix();
}

TEST(MotionOfANode, KeepsTheCornersOfItsBoxWithinTheToleranceAtAllTimes)
{
    Box box;
    box.add({-1, -0.5, 0});
    box.add({2, 1, 0.25});
    std::vector<glm::dmat4> matrices;
    std::vector<float> times_s;
    for (int i = 0; i <= 96; ++i) {
        const double t = i / 24.0;
        glm::dmat4 m = glm::translate(glm::dmat4(1), {std::sin(t), 0.3 * t * t, -t});
        m = glm::rotate(m, 2.5 * t, glm::normalize(glm::dvec3(1, 2, 0.5 + t)));
        matrices.push_back(glm::scale(m, glm::dvec3(1 + 0.2 * std::cos(t))));
        times_s.push_back(static_cast<float>(t));
    }
    std::size_t last = 1000;
    for (const double tolerance : {1e-4, 1e-2, 0.1}) {
        const auto motion = node_motion(0, matrices, times_s, box, tolerance);
        ASSERT_TRUE(motion);
        EXPECT_LE(motion->off, tolerance);
        EXPECT_LT(motion->keys, last) << "a coarser one needs fewer";
        last = motion->keys;
        for (std::size_t i = 0; i < matrices.size(); ++i)
            for (const glm::dvec3& corner : box.corners()) {
                const glm::dvec4 p(corner, 1);
                constexpr double rounding = 1e-5; // of single precision
                EXPECT_LE(glm::distance(shown_at(*motion, double{times_s[i]}) * p, matrices[i] * p),
                          tolerance + rounding);
            }
    }
}

TEST(MotionOfANode, IsNoneWhereItRestsAndUnknownWhereItShears)
{
    Box box;
    box.add({0, 0, 0});
    box.add({1, 1, 1});
    const std::vector<float> times_s{0, 1, 2};
    const auto rests = node_motion(0, std::vector(3, glm::dmat4(1)), times_s, box, 1e-3);
    ASSERT_TRUE(rests);
    EXPECT_TRUE(rests->channels.empty());
    glm::dmat4 sheared(1);
    sheared[1][0] = 0.5;
    EXPECT_FALSE(node_motion(0, {glm::dmat4(1), sheared, sheared}, times_s, box, 1e-3));
}

// A film that plays a clip at a speed of its own, then back, then rests.
TEST(PlayedChannel, IsTheSameFunctionOfTimeAsTheClipThatIsPlayed)
{
    std::mt19937 dice(11);
    std::uniform_real_distribution<float> number(-1, 1);
    using Interpolation = Channel::Interpolation;
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
        Channel channel;
        channel.of = Channel::Of::translation;
        channel.components = 3;
        channel.interpolation = interpolation;
        for (int k = 0; k <= 6; ++k) {
            channel.times_s.push_back(0.25f * static_cast<float>(k));
            const std::size_t values = interpolation == Interpolation::cubic ? 9 : 3;
            for (std::size_t i = 0; i < values; ++i) channel.values.push_back(number(dice));
        }
        PlayedTime time;
        time.pieces = {{0, 1, 0.1, 1.4}, {1, 1.75, 1.4, 0.3}, {1.75, 2, 0.3, 0.3}};
        const Channel made = played(channel, time);
        for (int i = 0; i <= 200; ++i) {
            const double t = i / 100.0;
            const auto& piece = time.pieces[t < 1 ? 0 : t < 1.75 ? 1 : 2];
            const double share = (t - piece.from_s) / (piece.to_s - piece.from_s);
            const std::vector<double> wanted = value_at(
                channel, piece.clip_from_s + share * (piece.clip_to_s - piece.clip_from_s));
            const std::vector<double> found = value_at(made, t);
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 2e-5) << t;
        }
    }
}

TEST(FramesToExport, AreThoseThatAreNamedWithinTheScene)
{
    const Time time{.first_frame = 3, .last_frame = 40, .frames_per_second = 24};
    EXPECT_EQ(frame_range("", time), (FrameRange{3, 40}));
    EXPECT_EQ(frame_range("5", time), (FrameRange{5, 5}));
    EXPECT_EQ(frame_range("5:9", time), (FrameRange{5, 9}));
    for (const char* text : {"9:5", "1:9", "5:41", "a", "5:", ":", "5:6:7", "5.5"})
        EXPECT_THROW(frame_range(text, time), Rejected) << text;
}

} // namespace
} // namespace trivar
