// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/foot_lock.h"
#include "core/walking/planting_rates.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr int body = 0, hip = 1, knee = 2, ankle = 3, toe = 4, pad = 5, nodes = 6;

Channel turning(int node, float angle_s)
{
    Channel out;
    out.node = node;
    out.of = Channel::Of::rotation;
    out.components = 4;
    out.times_s = {0, 1};
    out.values = {0, 0, 0, 1, 0, std::sin(angle_s / 2), 0, std::cos(angle_s / 2)};
    return out;
}

Channel growing(int node, Channel::Of of, const std::vector<float>& values)
{
    Channel out;
    out.node = node;
    out.of = of;
    out.components = values.size() / 2;
    out.times_s = {0, 1};
    out.values = values;
    return out;
}

struct Kind {
    float longer = 0;    // by how much the shin grows in a second
    bool swells = false; // a morph target moves the sole
    bool uneven = false; // the body is not scaled alike in all directions
    std::array<std::uint16_t, 2> sole{knee, ankle};
    glm::vec2 shares{0.3f, 0.7f}; // of those
    std::vector<int> turn{body, hip, knee, ankle, toe};
    std::vector<int> leg{hip, knee, ankle};
    double length = 0.5; // of a bone
};

// A body that turns with one leg that does, of a skin; a pad hangs on the thigh.
Model walker(const Kind& kind)
{
    Model model;
    Mesh mesh;
    for (int v = 0; v < 4; ++v) {
        mesh.positions.emplace_back(0.1f * static_cast<float>(v), 0.05f, -1.0f);
        mesh.influences.push_back(
            {{kind.sole[0], kind.sole[1], 0, 0}, {kind.shares.x, kind.shares.y, 0, 0}});
    }
    if (kind.swells) mesh.morph_targets.push_back({{4, {0.1f, 0, 0.3f}}, {}, {}});
    model.meshes.push_back(make_ref<Mesh>(mesh));
    Skin skin;
    const double l = kind.length;
    const glm::dvec3 joints[] = {{0, 0, 0},  {0, 0, 0},   {0.2 * l, 0, -l},
                                 {0, 0, -l}, {0.1, 0, 0}, {0.1, 0.1, 0}};
    const int parents[] = {-1, body, hip, knee, ankle, hip};
    std::vector<glm::dvec3> at(nodes, glm::dvec3(0));
    for (int n = 0; n < nodes; ++n) {
        Node node;
        node.parent = parents[n];
        node.rest.translation = joints[n];
        node.to_parent[3] = glm::dvec4(joints[n], 1);
        model.nodes.push_back(node);
        const auto i = static_cast<std::size_t>(n);
        at[i] = joints[n] + (n > 0 ? at[static_cast<std::size_t>(parents[n])] : glm::dvec3(0));
        skin.joints.push_back(n);
        glm::dmat4 back(1);
        back[3] = glm::dvec4(-at[i], 1);
        skin.mesh_to_joint.push_back(back);
    }
    if (kind.uneven) model.nodes[body].rest.scale = {1, 1, 1.5};
    model.nodes[body].mesh = 0;
    model.nodes[body].skin = 0;
    model.skins.push_back(skin);
    Clip clip;
    clip.end_s = 1;
    for (const int n : kind.turn) clip.channels.push_back(turning(n, 0.9f));
    const auto long_ago = static_cast<float>(-l);
    if (kind.longer != 0)
        clip.channels.push_back(growing(ankle, Channel::Of::translation,
                                        {0, 0, long_ago, 0, 0, long_ago - kind.longer}));
    if (kind.swells) {
        model.nodes[body].morph_weights = {0};
        clip.channels.push_back(growing(body, Channel::Of::morph_weights, {0, 1}));
    }
    model.clips.push_back(clip);
    return model;
}

Gait gait_of(const Model& model, const Kind& kind)
{
    Gait gait;
    gait.period_s = 1;
    gait.stride = 0.5;
    Foot foot;
    for (std::uint32_t v = 0; v < model.meshes[0]->vertex_count(); ++v) foot.sole.push_back({0, v});
    foot.node = ankle;
    foot.leg = kind.leg;
    foot.shift = {{0, 0, 0}, {0.1, 0.02, 0}, {0.05, 0, 0.04}, {-0.1, 0, 0}};
    gait.feet.push_back(foot);
    return gait;
}

std::optional<PlantingRates> rates_of(const Kind& kind, double from_s, double to_s)
{
    const Model model = walker(kind);
    const Clip& clip = model.clips.front();
    const auto local = local_rates(model, clip, from_s, to_s);
    return PlantingRates::of(model, clip, gait_of(model, kind), 0, *local, from_s, to_s);
}

// How much of the bounds the derivatives of what planting adds take, at most.
struct Used {
    double first = 0, second = 0;
};
Used used(const Kind& kind, double from_s = 0.3, double to_s = 0.4)
{
    constexpr double h = 1e-3;
    const Model model = walker(kind);
    const Clip& clip = model.clips.front();
    const Gait gait = gait_of(model, kind);
    const auto rates = rates_of(kind, from_s, to_s);
    EXPECT_TRUE(rates);
    Used out;
    for (double t = from_s + 2 * h; rates && t < to_s - h; t += (to_s - from_s) / 50)
        for (int n = 0; n < nodes; ++n)
            for (const glm::dvec4& p : {glm::dvec4(0, 0, 0, 1), glm::dvec4(0.1, -0.2, 0.1, 1)}) {
                const auto added = [&](double time) {
                    const auto i = static_cast<std::size_t>(n);
                    return glm::dvec3(planted(model, clip, gait, time).to_model[i] * p -
                                      stance_at(model, &clip, time).to_model[i] * p);
                };
                const glm::dvec3 before = added(t - h), now = added(t), after = added(t + h);
                const Rates bound = rates->at(n, {glm::length(glm::dvec3(p)), 0, 0});
                const double first = glm::length(after - before) / (2 * h),
                             second = glm::length(after - 2.0 * now + before) / (h * h);
                EXPECT_LE(glm::length(now), bound.most + 1e-12) << n << " " << t;
                EXPECT_LE(first, bound.first + 1e-9) << n << " " << t;
                EXPECT_LE(second, bound.second + 1e-6) << n << " " << t;
                if (bound.first > 0) out.first = std::max(out.first, first / bound.first);
                if (bound.second > 0) out.second = std::max(out.second, second / bound.second);
            }
    return out;
}

TEST(PlantingRates, BoundWhatIsAddedToALegThatGrows)
{
    for (const float longer : {0.2f, -0.2f}) {
        const Used most = used({.longer = longer});
        EXPECT_GT(most.first, 0.3); // no idle bounds
        EXPECT_GT(most.second, 0.01);
    }
    EXPECT_GT(used({.longer = 0.2f, .uneven = true}).first, 0.05);
    EXPECT_GT(used({.longer = 0.6f}, 0.26, 0.49).first, 0.05);
}

TEST(PlantingRates, BoundWhatIsAddedToALegWithASoleThatSwells)
{
    EXPECT_GT(used({.swells = true}).second, 0.01);
    EXPECT_GT(rates_of({.swells = true}, 0.3, 0.4)->at(ankle, {}).second, 0);
}

TEST(PlantingRates, BoundWhatIsAddedWhereTheSoleIsHardlyOfItsLeg)
{
    const Kind kind{.sole = {body, ankle}, .shares = {0.8f, 0.2f}};
    EXPECT_GT(used(kind).first, 0.3);
    EXPECT_GT(rates_of(kind, 0.3, 0.4)->at(ankle, {}).first, 0);
    EXPECT_FALSE(rates_of({.sole = {body, ankle}, .shares = {0.5f, 0.5f}}, 0.3, 0.4));
}

TEST(PlantingRates, BoundWhatIsAddedToWhatTurnsBesideTheLeg)
{
    EXPECT_GT(used({.turn = {body, hip, pad}}).first, 0.05);
    EXPECT_GT(rates_of({.turn = {pad}}, 0.3, 0.4)->at(pad, {0.5, 0, 0}).second, 0);
    EXPECT_GT(used({.uneven = true}).first, 0.05); // so that the thigh's length changes
    EXPECT_GT(rates_of({.uneven = true}, 0.3, 0.4)->at(knee, {0.5, 0, 0}).second, 0);
}

TEST(PlantingRates, AreEvenWhereALegOnlyTurns)
{
    EXPECT_GT(used({}).first, 0.3);
    for (const int n : {hip, knee, ankle, toe})
        EXPECT_EQ(rates_of({}, 0.3, 0.4)->at(n, {0.5, 0, 0}).second, 0) << n;
}

TEST(PlantingRates, BoundWhatIsAddedToALegWithoutALength)
{
    EXPECT_GT(used({.leg = {ankle}}).first, 0.3);
    EXPECT_GT(used({.length = 0}).first, 0.3);
    EXPECT_EQ(rates_of({.length = 0}, 0.3, 0.4)->at(hip, {0.5, 0, 0}).second, 0);
}

TEST(PlantingRates, SayNothingOfALegThatMayHaveNoLength)
{
    EXPECT_TRUE(rates_of({.longer = -0.4f}, 0.5, 0.6));
    EXPECT_FALSE(rates_of({.longer = -20}, 0.0, 0.2));
    EXPECT_FALSE(rates_of({.longer = 0.2f, .length = 1e-8}, 0.3, 0.4)); // the thigh by the shin
}

} // namespace
} // namespace trivar
