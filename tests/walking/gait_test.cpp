// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/gait.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"
#include "core/walking/foot_lock.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr double duty = 0.6, stride = 0.5, period = 2, touching = 2e-3;

// How a cycle made by hand is off: `uneven`: how much a foot hurries at first in its stance and
// lags then; `sink`: how far it is below the ground; `lift`: how high it swings; `roll`: by how
// much its heel is turned up, in the second half of the stance.
struct Hand {
    double uneven = 0, sink = 0, lift = 0.2, roll = 0;
};

// Where a foot is, `share` of a period after it came down, from where it is in the middle of its
// stance.
glm::dvec3 step(double share, const Hand& hand)
{
    share -= std::floor(share);
    const double way = stride * duty;
    if (share < duty) {
        const double t = share / duty;
        return {way * (0.5 - t) - hand.uneven * way * std::sin(2 * 3.14159265358979 * t), 0,
                -hand.sink};
    }
    const double t = (share - duty) / (1 - duty);
    return {way * (t - 0.5), 0, hand.lift * std::sin(3.14159265358979 * t) - hand.sink};
}

double turned_up(double share, const Hand& hand)
{
    share -= std::floor(share);
    const double t = share < duty ? 2 * share / duty - 1 : (1 - share) / (1 - duty);
    return hand.roll * std::max(0.0, t);
}

// A trunk on two legs of two boxes each, a thigh and a foot. The feet go back under it in turn.
Model walker(const Hand& hand = {})
{
    Model model;
    model.meshes = {make_ref(box_mesh({0.6, 0.5, 0.3}, {1, 1, 1})),
                    make_ref(box_mesh({0.1, 0.1, 0.3}, {1, 1, 2})),
                    make_ref(box_mesh({0.2, 0.1, 0.1}, {2, 2, 1}))};
    model.materials.resize(1);
    const auto node = [&](const char* name, int parent, const glm::dvec3& at, int mesh) {
        Node out{.name = name, .parent = parent, .mesh = mesh};
        out.rest.translation = at;
        out.to_parent = out.rest.matrix();
        model.nodes.push_back(out);
        return static_cast<int>(model.nodes.size()) - 1;
    };
    Clip clip;
    clip.name = "walk";
    clip.end_s = period;
    const int trunk = node("trunk", -1, {0, 0, 1}, 0);
    for (const double side : {1.0, -1.0}) {
        const int hip = node("hip", trunk, {0, 0.2 * side, -0.4}, 1);
        const glm::dvec3 rest(0, 0, -0.55);
        const int foot = node("foot", hip, rest, 2);
        Channel channel{foot, Channel::Of::translation, Channel::Interpolation::linear, {}, {}, 3};
        constexpr int keys = 200;
        for (int k = 0; k <= keys; ++k) {
            const double share = static_cast<double>(k) / keys;
            const glm::dvec3 p = rest + step(share + (side > 0 ? 0 : 0.5), hand);
            channel.times_s.push_back(static_cast<float>(share * period));
            for (int axis = 0; axis < 3; ++axis)
                channel.values.push_back(static_cast<float>(p[axis]));
        }
        clip.channels.push_back(channel);
        Channel turn{foot, Channel::Of::rotation, Channel::Interpolation::linear, {}, {}, 4};
        turn.times_s = channel.times_s;
        for (int k = 0; k <= keys; ++k) {
            const double share = static_cast<double>(k) / keys;
            const double angle = turned_up(share + (side > 0 ? 0 : 0.5), hand);
            for (const double part : {0.0, std::sin(angle / 2), 0.0, std::cos(angle / 2)})
                turn.values.push_back(static_cast<float>(part));
        }
        clip.channels.push_back(turn);
    }
    model.clips = {clip};
    return model;
}

TEST(Gait, FindsTheFeetTheirStancesAndTheStride)
{
    const Model model = walker();
    const Gait gait = gait_of(model, model.clips[0]);
    EXPECT_EQ(gait.trouble, "");
    EXPECT_EQ(gait.period_s, period);
    EXPECT_NEAR(gait.stride, stride, 1e-3 * stride);
    EXPECT_LT(glm::distance(gait.forward, {1, 0, 0}), 1e-3);
    ASSERT_EQ(gait.feet.size(), 2u);
    for (const Foot& foot : gait.feet) {
        EXPECT_EQ(model.nodes[static_cast<std::size_t>(foot.node)].name, "foot");
        EXPECT_EQ(foot.leg.size(), 2u);
        EXPECT_NEAR(foot.end - foot.begin, duty, 0.06);
        const double begin =
            model.nodes[static_cast<std::size_t>(foot.leg[0])].rest.translation.y > 0 ? 0 : 0.5;
        EXPECT_NEAR((foot.begin + foot.end) / 2 - begin - duty / 2,
                    std::round((foot.begin + foot.end) / 2 - begin - duty / 2), 0.02);
        for (const ModelVertex& each : foot.sole) EXPECT_EQ(each.node, foot.node);
    }
}

TEST(Gait, TurnsAndGrowsWithTheModel)
{
    Model model = walker();
    const glm::dmat4 matrix = glm::scale(
        glm::rotate(glm::dmat4(1), glm::radians(30.0), glm::dvec3(0, 0, 1)), glm::dvec3(3));
    for (Node& node : model.nodes)
        if (node.parent < 0) node.to_parent = matrix * node.to_parent;
    const Gait gait = gait_of(model, model.clips[0]);
    EXPECT_NEAR(gait.stride, 3 * stride, 3e-3 * stride);
    EXPECT_LT(glm::distance(gait.forward, {std::sqrt(0.75), 0.5, 0}), 1e-3);
    const glm::dvec3 up = glm::normalize(glm::dvec3(matrix[2]));
    EXPECT_EQ(gait_of(model, model.clips[0], up).feet.size(), 2u);
}

TEST(Gait, IsTheSameOnAnyNumberOfThreads)
{
    const Model model = walker({.uneven = 0.05});
    const Gait many = gait_of(model, model.clips[0]);
    const ThreadLimit one(1);
    const Gait alone = gait_of(model, model.clips[0]);
    EXPECT_EQ(many.stride, alone.stride);
    EXPECT_EQ(many.forward, alone.forward);
    ASSERT_EQ(many.feet.size(), alone.feet.size());
    EXPECT_EQ(many.feet[0].shift, alone.feet[0].shift);
}

TEST(Gait, SaysWhereNothingWalks)
{
    Model model = walker();
    Clip still = model.clips[0];
    for (Channel& channel : still.channels)
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            channel.values[i] = channel.values[i % static_cast<std::size_t>(channel.components)];
    EXPECT_EQ(gait_of(model, still).trouble, "moves no foot along the ground");
    still.end_s = still.begin_s;
    EXPECT_EQ(gait_of(model, still).trouble, "lasts no time");
    still.channels.clear();
    still.end_s = period;
    EXPECT_EQ(gait_of(Model{}, still).trouble, "moves no foot along the ground");
}

// How far the ground slips under what touches it, as a share of the stride.
double slip(const Model& model, const Gait& gait, const auto& stance_at_time)
{
    constexpr int times = 1000;
    std::vector<std::vector<glm::dvec3>> contacts;
    double most = 0;
    for (int i = 0; i <= times; ++i) {
        const Stance stance = stance_at_time(gait.begin_s + gait.period_s * i / times);
        std::size_t v = 0;
        for (std::size_t n = 0; n < model.nodes.size(); ++n) {
            const Mesh& mesh = *model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)];
            for (const glm::vec3& p : mesh.positions) {
                const glm::dvec3 at(stance.to_model[n] * glm::dvec4(p, 1));
                contacts.resize(std::max(contacts.size(), ++v));
                std::vector<glm::dvec3>& contact = contacts[v - 1];
                if (at.z > touching) {
                    contact.clear();
                    continue;
                }
                const glm::dvec3 over = at + gait.stride * i / times * gait.forward;
                for (const glm::dvec3& before : contact)
                    most = std::max(most, glm::distance(glm::dvec2(before), glm::dvec2(over)));
                contact.push_back(over);
            }
        }
    }
    return most / gait.stride;
}

TEST(FootLock, PlantsFeetThatOneSpeedCannotServe)
{
    const Model model = walker({.uneven = 0.05});
    const Clip& clip = model.clips[0];
    const Gait gait = gait_of(model, clip);
    EXPECT_GT(slip(model, gait, [&](double t) { return stance_at(model, &clip, t); }), 0.02);
    EXPECT_LT(slip(model, gait, [&](double t) { return planted(model, clip, gait, t); }), 0.005);
    EXPECT_LT(largest_correction(gait), 0.1);
}

TEST(FootLock, LetsASoleRollOnWhatTouches)
{
    const Model model = walker({.uneven = 0.02, .roll = 0.5});
    const Clip& clip = model.clips[0];
    const Gait gait = gait_of(model, clip, {0, 0, 1}, 0);
    EXPECT_GT(slip(model, gait, [&](double t) { return stance_at(model, &clip, t); }), 0.02);
    EXPECT_LT(slip(model, gait, [&](double t) { return planted(model, clip, gait, t); }), 0.005);
    for (const Foot& foot : gait.feet) EXPECT_GT(foot.end - foot.begin, duty - 0.06);
}

TEST(FootLock, LiftsFeetOffTheGroundThatTheClipDragsThroughIt)
{
    const Model model = walker({.sink = 0.02, .lift = 0.01});
    const Clip& clip = model.clips[0];
    const Gait gait = gait_of(model, clip, {0, 0, 1}, 0);
    ASSERT_EQ(gait.feet.size(), 2u);
    const auto locked = [&](double t) { return planted(model, clip, gait, t); };
    EXPECT_LT(slip(model, gait, locked), 0.005);
    for (const Foot& foot : gait.feet) {
        const auto height = [&](double phase) {
            double least = 1;
            for (const glm::dvec3& p :
                 positions_of(model, foot.sole, locked(std::fmod(phase, 1.0) * period)))
                least = std::min(least, p.z);
            return least;
        };
        EXPECT_NEAR(height((foot.begin + foot.end) / 2), 0, 1e-6);
        EXPECT_GT(height((foot.begin + foot.end + 1) / 2), 5 * touching);
    }
}

TEST(FootLock, KeepsTheHipAndTheOtherNodesAndGoesSmoothlyThroughTheAir)
{
    const Model model = walker({.uneven = 0.05});
    const Clip& clip = model.clips[0];
    const Gait gait = gait_of(model, clip);
    glm::dmat4 before(0);
    for (int i = 0; i <= 400; ++i) {
        const double t = period * i / 400.0;
        const Stance given = stance_at(model, &clip, t), out = planted(model, clip, gait, t);
        EXPECT_EQ(out.to_model[0], given.to_model[0]);
        EXPECT_LT(glm::distance(glm::dvec3(out.to_model[1][3]), glm::dvec3(given.to_model[1][3])),
                  1e-9);
        const glm::dmat4 moved = out.to_model[2] - given.to_model[2];
        EXPECT_TRUE(i == 0 || glm::length(moved[3] - before[3]) < 0.004);
        before = moved;
    }
}

TEST(FootLock, LeavesAGaitWithoutAStrideAlone)
{
    const Model model = walker();
    Gait none;
    none.trouble = "no";
    EXPECT_EQ(planted(model, model.clips[0], none, 0.3).to_model,
              stance_at(model, &model.clips[0], 0.3).to_model);
}

} // namespace
} // namespace trivar
