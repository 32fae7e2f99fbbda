// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/pose_rates.h"
#include "tests/support/rigged.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// A chain of three nodes that turn, move and grow.
Model chain(Channel::Interpolation turns = Channel::Interpolation::linear)
{
    Model model;
    for (int n = 0; n < 3; ++n) {
        Node node;
        node.parent = n - 1;
        node.rest.translation = {0.5 * n, 0, 0.1};
        model.nodes.push_back(node);
    }
    Clip clip;
    clip.end_s = 1;
    for (int n = 0; n < 3; ++n) {
        Channel turn;
        turn.node = n;
        turn.of = Channel::Of::rotation;
        turn.components = 4;
        turn.times_s = {0, 0.5f, 1};
        turn.interpolation = turns;
        turn.values = {0, 0, 0, 1, 0, 0.6f, 0, 0.8f, 0.48f, 0.36f, 0, 0.8f};
        if (turns == Channel::Interpolation::cubic) {
            const std::vector<float> at = turn.values, slope{0.5f, 0.2f, -0.3f, 0};
            turn.values.clear();
            for (std::ptrdiff_t key = 0; key < 3; ++key) {
                turn.values.insert(turn.values.end(), slope.begin(), slope.end());
                turn.values.insert(turn.values.end(), at.begin() + 4 * key,
                                   at.begin() + 4 * key + 4);
                turn.values.insert(turn.values.end(), slope.begin(), slope.end());
            }
        }
        clip.channels.push_back(turn);
    }
    Channel way;
    way.node = 1;
    way.times_s = {0, 1};
    way.values = {0.5f, 0, 0.1f, 1.5f, 1, 0.1f};
    clip.channels.push_back(way);
    Channel size;
    size.node = 0;
    size.of = Channel::Of::scale;
    size.times_s = {0, 1};
    size.values = {1, 1, 1, 2, 3, -1};
    clip.channels.push_back(size);
    model.clips.push_back(clip);
    return model;
}

void expect_bounds(const Model& model, double from_s, double to_s)
{
    const Clip& clip = model.clips.front();
    const auto local = local_rates(model, clip, from_s, to_s);
    ASSERT_TRUE(local);
    const std::vector<NodeRates> rates = node_rates(model, *local);
    const double h = 1e-4;
    double closest = 0;
    for (double t = from_s + 2 * h; t < to_s - h; t += (to_s - from_s) / 24)
        for (std::size_t n = 0; n < model.nodes.size(); ++n)
            for (const glm::dvec4& p : {glm::dvec4(0, 0, 0, 1), glm::dvec4(0.3, -0.4, 0.2, 1)}) {
                const auto at = [&](double time) {
                    return glm::dvec3(stance_at(model, &clip, time).to_model[n] * p);
                };
                const glm::dvec3 before = at(t - h), now = at(t), after = at(t + h);
                const double far = glm::length(glm::dvec3(p));
                const NodeRates& r = rates[n];
                const double first = glm::length(after - before) / (2 * h),
                             second = glm::length(after - 2.0 * now + before) / (h * h);
                EXPECT_LE(first, r.turn * far + r.shift + 1e-6) << n << " " << t;
                EXPECT_LE(second, r.bend * far + r.swing + 1e-4) << n << " " << t;
                if (r.turn * far + r.shift > 0)
                    closest = std::max(closest, first / (r.turn * far + r.shift));
            }
    EXPECT_GT(closest, 0.2); // no idle bound
}

TEST(PoseRates, BoundTheDerivativesOfEveryPoint)
{
    expect_bounds(chain(), 0.5, 1);
}

TEST(PoseRates, BoundTheDerivativesOfCubicRotations)
{
    const Model model = chain(Channel::Interpolation::cubic);
    for (const double from : {0.1, 0.6, 0.9}) expect_bounds(model, from, from + 0.05);
}

TEST(PoseRates, BoundTheDerivativesOfWeights)
{
    Model model = testing::rigged_model();
    Channel& weights = model.clips[1].channels.front();
    weights.interpolation = Channel::Interpolation::cubic;
    weights.values = {0, 0.2f, 3, -2, 0.9f, 0}; // tangent in, value, tangent out
    const Clip& clip = model.clips[1];
    const std::vector<Rates> rates = weight_rates(model, clip, 0, 0.25, 0.75);
    ASSERT_EQ(rates.size(), 1u);
    const double h = 1e-4;
    for (double t = 0.26; t < 0.75; t += 0.01) {
        const auto at = [&](double time) { return value_at(weights, time).front(); };
        EXPECT_LE(std::abs(at(t)), rates[0].most);
        EXPECT_LE(std::abs(at(t + h) - at(t - h)) / (2 * h), rates[0].first);
        EXPECT_LE(std::abs(at(t + h) - 2 * at(t) + at(t - h)) / (h * h), rates[0].second + 1e-4);
    }
    weights.interpolation = Channel::Interpolation::linear;
    weights.values = {0, 1};
    const Rates even = weight_rates(model, clip, 0, 0.25, 0.75).front();
    EXPECT_DOUBLE_EQ(even.most, 0.75);
    EXPECT_DOUBLE_EQ(even.first, 1);
    EXPECT_EQ(even.second, 0);
}

TEST(PoseRates, SayNothingOfARotationThatMayBeNone)
{
    Model model = chain(Channel::Interpolation::cubic);
    Channel& turn = model.clips.front().channels.front();
    EXPECT_TRUE(local_rates(model, model.clips.front(), 0.7, 0.8));
    for (std::size_t i = 0; i < 4; ++i) turn.values[28 + i] *= -1; // the last key's
    EXPECT_FALSE(local_rates(model, model.clips.front(), 0.7, 0.8));
}

TEST(PoseRates, BreaksAreWhereAnyChannelHasAKey)
{
    const Model model = chain();
    EXPECT_EQ(breaks_of(model.clips.front(), nullptr), (std::vector<double>{0, 0.5, 1}));
}

} // namespace
} // namespace trivar
