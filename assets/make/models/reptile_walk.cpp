// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/reptile.h"

#include "assets/make/kit.h"
#include "assets/make/walk.h"

#include <cmath>

namespace make {
namespace {

constexpr float travel = .13f, duty = .6f, lift = .035f; // of a foot on the ground, in the air

struct Joint {
    const char* name;
    float x;
    int parent; // in this list
    float yaw;  // radians to either side, relative to its parent
    float late; // of a cycle
};
// Falling x. Head and chest hang on the pelvis, and so does the tail.
constexpr std::array<Joint, 6> spine{{{"head", .83f, 1, .16f, .5f},
                                      {"chest", .70f, 2, .34f, 0},
                                      {"pelvis", .48f, -1, .18f, .5f},
                                      {"tail_1", .36f, 2, .24f, .12f},
                                      {"tail_2", .25f, 3, .26f, .26f},
                                      {"tail_3", .13f, 4, .28f, .40f}}};
constexpr float spine_y = .04f;

struct Leg {
    const char* name;
    std::size_t trunk; // joint of the spine
    vec3 hip, foot;
    float phase;
    int leg_node = 0, foot_node = 0;
};

std::vector<Leg> legs()
{
    std::vector<Leg> out;
    for (const float side : {1.f, -1.f}) {
        const bool left = side > 0;
        const vec3 mirror(1, 1, side);
        out.push_back({left ? "fore_l" : "fore_r", 1, vec3(.70f, spine_y, .050f) * mirror,
                       vec3(.765f, .012f, .158f) * mirror, left ? 0.f : .5f});
        out.push_back({left ? "hind_l" : "hind_r", 2, vec3(.49f, spine_y, .045f) * mirror,
                       vec3(.455f, .012f, .160f) * mirror, left ? .5f : 0.f});
    }
    return out;
}

// Returns the influence of joints 0 to 5 of the spine, then of leg and foot of each leg.
Influence influence(const Limb& fore, const Limb& hind, vec3 p)
{
    std::vector<float> x;
    for (const Joint& joint : spine) x.push_back(joint.x);
    Influence out = along_x(x, p);
    const bool front = p.x > .60f;
    const vec3 q = mirror_z(p);
    const float near = q.z > .09f ? 1 : smooth_step(.035f, .005f, (front ? fore : hind)(q));
    const float limb = near * smooth_step(.045f, .085f, q.z);
    const float foot = limb * smooth_step(.092f, .146f, q.z);
    const int leg = int(spine.size()) + (p.z > 0 ? 0 : 4) + (front ? 0 : 2);
    out.weights *= 1 - limb;
    out.joints[2] = std::uint8_t(leg);
    out.joints[3] = std::uint8_t(leg + 1);
    out.weights.z = limb - foot;
    out.weights.w = foot;
    return out;
}

} // namespace

void crawl(Model& m, const Limb& fore, const Limb& hind)
{
    std::array<int, spine.size()> nodes{};
    for (const std::size_t k : {2, 1, 0, 3, 4, 5}) { // parents first
        const Joint& joint = spine[k];
        const bool top = joint.parent < 0;
        const vec3 at = top ? vec3(joint.x, spine_y, 0)
                            : vec3(joint.x - spine[std::size_t(joint.parent)].x, 0, 0);
        nodes[k] = m.node(joint.name, top ? 0 : nodes[std::size_t(joint.parent)], at);
    }
    m.skin.joints.assign(nodes.begin(), nodes.end());
    std::vector<Leg> all = legs();
    for (Leg& leg : all) {
        const vec3 trunk(spine[leg.trunk].x, spine_y, 0);
        leg.leg_node = m.node(std::string("leg_") + leg.name, nodes[leg.trunk], leg.hip - trunk);
        leg.foot_node = m.node(std::string("foot_") + leg.name, leg.leg_node, leg.foot - leg.hip);
        m.skin.joints.insert(m.skin.joints.end(), {leg.leg_node, leg.foot_node});
    }
    m.skin.at = [fore, hind](vec3 p) { return influence(fore, hind, p); };

    constexpr int keys = 40;
    Clip c;
    c.name = "walk";
    for (const int node : nodes) c.channels.push_back({node, {}, {}});
    for (const Leg& leg : all) {
        c.channels.push_back({leg.leg_node, {}, {}});
        c.channels.push_back({leg.foot_node, {}, {}});
        c.channels.push_back({leg.foot_node, {}, {}});
    }
    for (int key = 0; key <= keys; ++key) {
        const float u = float(key) / keys;
        c.times_s.push_back(u);
        // Where a fore foot comes down its shoulder is in front, and so is the hip across.
        std::array<mat4, spine.size()> at{};
        for (const std::size_t k : {2, 1, 0, 3, 4, 5}) {
            const Joint& joint = spine[k];
            const quat turn =
                rotation(joint.yaw * std::cos(2 * pi * (u - joint.late - .04f)), {0, 1, 0});
            c.channels[k].rotations.push_back(turn);
            const mat4 above = joint.parent < 0 ? mat4(1) : at[std::size_t(joint.parent)];
            at[k] = glm::translate(above, m.nodes[std::size_t(nodes[k])].translation) *
                    glm::mat4_cast(turn);
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Leg& leg = all[i];
            const Step step = step_at(u + leg.phase, travel, duty, lift);
            const vec3 hip = m.nodes[std::size_t(leg.leg_node)].translation;
            const vec3 wanted = leg.foot + vec3(step.x, step.lift, 0);
            const vec3 there = vec3(glm::inverse(at[leg.trunk]) * vec4(wanted, 1)) - hip;
            const vec3 rest = leg.foot - leg.hip;
            const quat turn(glm::normalize(rest), glm::normalize(there));
            const quat trunk = glm::quat_cast(at[leg.trunk]);
            c.channels[spine.size() + 3 * i].rotations.push_back(turn);
            c.channels[spine.size() + 3 * i + 1].translations.push_back(glm::inverse(turn) * there);
            c.channels[spine.size() + 3 * i + 2].rotations.push_back(
                glm::inverse(trunk * turn)); // the sole stays flat and looks ahead
        }
    }
    m.clips.push_back(c);
    m.extras = {{"stride", std::to_string(travel / duty)},
                {"duty", std::to_string(duty)},
                {"cycle", "1"},
                {"gait", "\"trot\""}};
}

} // namespace make
