// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/foot_lock.h"
#include "core/mesh/planting_rates.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr int hip = 1, knee = 2, ankle = 3, toe = 4;

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

// A body that turns with one leg that does, of a skin: its sole hangs on the ankle and on the knee.
// `longer`: by how much the shin grows in a second; `swells`: a target moves the sole.
Model leg(float longer, bool swells = false)
{
    Model model;
    Mesh mesh;
    for (int v = 0; v < 4; ++v) {
        mesh.positions.emplace_back(0.1f * static_cast<float>(v), 0.05f, -1.0f);
        mesh.influences.push_back({{1, 2, 0, 0}, {0.3f, 0.7f, 0, 0}});
    }
    if (swells) mesh.morph_targets.push_back({{4, {0.1f, 0, 0.3f}}, {}, {}});
    model.meshes.push_back(make_ref<Mesh>(mesh));
    Skin skin;
    const glm::dvec3 joints[] = {{0, 0, 0}, {0, 0, 0}, {0.1, 0, -0.5}, {0, 0, -0.5}, {0.1, 0, 0}};
    glm::dvec3 at(0);
    for (int n = 0; n <= toe; ++n) {
        Node node;
        node.parent = n - 1;
        node.rest.translation = joints[n];
        node.to_parent[3] = glm::dvec4(joints[n], 1);
        model.nodes.push_back(node);
        at += joints[n];
        if (n == 0) continue;
        skin.joints.push_back(n);
        glm::dmat4 back(1);
        back[3] = glm::dvec4(-at, 1);
        skin.mesh_to_joint.push_back(back);
    }
    model.nodes[0].mesh = 0;
    model.nodes[0].skin = 0;
    model.skins.push_back(skin);
    Clip clip;
    clip.end_s = 1;
    for (const int n : {0, hip, knee, ankle, toe}) clip.channels.push_back(turning(n, 0.9f));
    if (longer != 0) {
        Channel grow;
        grow.node = ankle;
        grow.times_s = {0, 1};
        grow.values = {0, 0, -0.5f, 0, 0, -0.5f - longer};
        clip.channels.push_back(grow);
    }
    if (swells) {
        model.nodes[0].morph_weights = {0};
        Channel swell;
        swell.node = 0;
        swell.of = Channel::Of::morph_weights;
        swell.components = 1;
        swell.times_s = {0, 1};
        swell.values = {0, 1};
        clip.channels.push_back(swell);
    }
    model.clips.push_back(clip);
    return model;
}

Gait gait_on(const Model& model)
{
    Gait gait;
    gait.period_s = 1;
    gait.stride = 0.5;
    Foot foot;
    for (std::uint32_t v = 0; v < model.meshes[0]->vertex_count(); ++v) foot.sole.push_back({0, v});
    foot.node = ankle;
    foot.leg = {hip, knee, ankle};
    foot.shift = {{0, 0, 0}, {0.1, 0.02, 0}, {0.05, 0, 0.04}, {-0.1, 0, 0}};
    gait.feet.push_back(foot);
    return gait;
}

std::optional<PlantingRates> rates_on(const Model& model, double from_s, double to_s)
{
    const Clip& clip = model.clips.front();
    const auto local = local_rates(model, clip, from_s, to_s);
    return PlantingRates::of(model, clip, gait_on(model), 0, *local, from_s, to_s);
}

// How much of the bounds the derivatives of what planting adds take, at most.
struct Used {
    double first = 0, second = 0;
};
Used used(const Model& model, double from_s, double to_s)
{
    const Clip& clip = model.clips.front();
    const Gait gait = gait_on(model);
    const auto rates = rates_on(model, from_s, to_s);
    EXPECT_TRUE(rates);
    Used out;
    const double h = 1e-3;
    for (double t = from_s + 2 * h; t < to_s - h; t += (to_s - from_s) / 50)
        for (const int n : {0, hip, knee, ankle, toe})
            for (const glm::dvec4& p : {glm::dvec4(0, 0, 0, 1), glm::dvec4(0.1, -0.2, 0.1, 1)}) {
                const auto added = [&](double time) {
                    const auto i = static_cast<std::size_t>(n);
                    return glm::dvec3(planted(model, clip, gait, time).to_model[i] * p -
                                      stance_at(model, &clip, time).to_model[i] * p);
                };
                const glm::dvec3 before = added(t - h), now = added(t), after = added(t + h);
                const auto bound = rates->at(n, {glm::length(glm::dvec3(p)), 0, 0});
                const double first = glm::length(after - before) / (2 * h),
                             second = glm::length(after - 2.0 * now + before) / (h * h);
                constexpr double single =
                    1e-8; // precision: of poses, and so of what the sole takes
                EXPECT_LE(first, bound.first + single / h) << n << " " << t;
                EXPECT_LE(second, bound.second + 4 * single / (h * h)) << n << " " << t;
                if (bound.first > 0) out.first = std::max(out.first, first / bound.first);
                if (bound.second > 0) out.second = std::max(out.second, second / bound.second);
            }
    return out;
}

TEST(PlantingRates, BoundWhatIsAddedToALegThatGrows)
{
    for (const float longer : {0.2f, -0.2f}) {
        const Used most = used(leg(longer), 0.3, 0.4);
        EXPECT_GT(most.first, 0.3); // no idle bounds
        EXPECT_GT(most.second, 0.01);
    }
}

TEST(PlantingRates, BoundWhatIsAddedToALegWithASoleThatSwells)
{
    const Model model = leg(0, true);
    EXPECT_GT(used(model, 0.3, 0.4).second, 0.01);
    EXPECT_GT(rates_on(model, 0.3, 0.4)->at(ankle, {}).second, 0);
}

TEST(PlantingRates, AreEvenWhereALegOnlyTurns)
{
    const Model model = leg(0);
    EXPECT_GT(used(model, 0.3, 0.4).first, 0.3);
    for (const int n : {hip, knee, ankle, toe})
        EXPECT_EQ(rates_on(model, 0.3, 0.4)->at(n, {0.5, 0, 0}).second, 0) << n;
}

TEST(PlantingRates, SayNothingOfALegThatMayHaveNoLength)
{
    EXPECT_TRUE(rates_on(leg(-0.4f), 0.5, 0.6));
    EXPECT_FALSE(rates_on(leg(-20), 0.0, 0.2));
}

} // namespace
} // namespace trivar
