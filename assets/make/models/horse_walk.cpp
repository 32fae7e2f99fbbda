// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/quadruped.h"

#include "assets/make/kit.h"
#include "assets/make/walk.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr float on_ground = .28f, grounded = .64f; // way of a hoof there; share of a cycle
constexpr float sink = .014f, bob = .005f;         // of the trunk: legs that reach out are short
// The height of a sole over the ground: on it, where a volume ends, rounding would decide whether
// that still bends it.
constexpr float clearance = .0005f;

enum Trunk { pelvis, chest, neck, head, tail, tail_end, trunk_joints };
struct TrunkJoint {
    const char* name;
    vec3 at;
    int parent; // in this list; parents come first
};
constexpr std::array<TrunkJoint, trunk_joints> body{{{"pelvis", {.28f, .56f, 0}, -1},
                                                     {"chest", {.58f, .56f, 0}, pelvis},
                                                     {"neck", {.64f, .61f, 0}, chest},
                                                     {"head", {.82f, .90f, 0}, neck},
                                                     {"tail", {.12f, .65f, 0}, pelvis},
                                                     {"tail_end", {.055f, .45f, 0}, tail}}};

struct Limbs { // how legs in front differ from those behind
    Trunk trunk;
    vec3 top, middle, foot; // where they bend, for z > 0
    float knee;             // which way the middle bends: 1 forward, -1 backward
    float lift;             // of the hoof in the air
    vec2 free;              // heights between which it leaves the trunk
    float widest;           // how far from its axis's surface the trunk does not go with it
};
constexpr Limbs fore_limbs{chest,
                           {.630f, .550f, .074f},
                           {.635f, .262f, .074f},
                           {.628f, .090f, .074f},
                           1,
                           .075f,
                           {.56f, .41f},
                           .035f};
constexpr Limbs hind_limbs{pelvis,
                           {.240f, .550f, .078f},
                           {.203f, .270f, .078f},
                           {.214f, .092f, .078f},
                           -1,
                           .060f,
                           {.62f, .45f},
                           .045f};

struct SteedLeg {
    const char* name;
    const Limbs& limbs;
    float side, phase;
    std::array<int, 3> nodes{}; // upper, lower, foot
    vec3 at(vec3 p) const { return p * vec3(1, 1, side); }
};
// Each comes down a quarter of a cycle after the one before: left hind, left fore, right hind,
// right fore.
std::array<SteedLeg, 4> steed_legs()
{
    return {SteedLeg{"hind_l", hind_limbs, 1, 0}, SteedLeg{"fore_l", fore_limbs, 1, .75f},
            SteedLeg{"hind_r", hind_limbs, -1, .5f}, SteedLeg{"fore_r", fore_limbs, -1, .25f}};
}

// Shares of what goes in turn with the next of three, of which the last two are given.
void share_out(vec4& weights, float rest_to_first, float first_to_second)
{
    weights *= 1 - rest_to_first;
    weights.z = rest_to_first * (1 - first_to_second);
    weights.w = rest_to_first * first_to_second;
}

// Returns the influence of the joints of the trunk, then of upper, lower and foot of each leg.
Influence steed_influence(const Limb& fore, const Limb& hind, vec3 p)
{
    Influence out = along_x({body[chest].at.x, body[pelvis].at.x}, p);
    for (std::size_t k : {0, 1}) out.joints[k] = out.joints[k] == 0 ? chest : pelvis;
    const auto with = [&](int first, int second, float rest_to_first, float first_to_second) {
        out.joints[2] = std::uint8_t(first);
        out.joints[3] = std::uint8_t(second);
        share_out(out.weights, rest_to_first, first_to_second);
    };
    const bool front = p.x > .42f;
    const Limbs& limbs = front ? fore_limbs : hind_limbs;
    const vec3 q = mirror_z(p);
    constexpr float hoof = .11f; // its height
    const float distance = (front ? fore : hind)(q);
    const float near = p.y < hoof ? 1 : smooth_step(limbs.widest, .012f, distance);
    const float limb = near * smooth_step(limbs.free.x, limbs.free.y, p.y) *
                       (p.y < .36f ? 1 : smooth_step(.005f, .045f, q.z));
    if (limb > 0) {
        const std::array<SteedLeg, 4> all = steed_legs();
        const auto leg = std::ranges::find_if(all, [&](const SteedLeg& each) {
            return &each.limbs == &limbs && (each.side > 0) == (p.z > 0);
        });
        const int upper = trunk_joints + 3 * int(leg - all.begin());
        const float knee = limbs.middle.y;
        if (p.y > .5f * (knee + limbs.foot.y)) {
            with(upper, upper + 1, limb, smooth_step(knee + .03f, knee - .03f, p.y));
        } else {
            out.weights = {0, 0, 0, 0};
            with(upper + 1, upper + 2, 1,
                 smooth_step(limbs.foot.y + .025f, limbs.foot.y - .02f, p.y));
        }
    } else if (front) {
        const vec3 along = glm::normalize(body[head].at - body[neck].at);
        const float up = glm::dot(p - body[neck].at, along);
        with(neck, head, smooth_step(-.01f, .20f, up),
             smooth_step(.775f, .84f, p.x + .25f * (p.y - .9f)));
    } else {
        with(tail, tail_end, smooth_step(.125f, .075f, p.x), smooth_step(.55f, .35f, p.y));
    }
    return out;
}

float sway(float u, float late, float cycles = 1)
{
    return std::cos(2 * pi * cycles * (u - late));
}

// How a joint of the trunk turns against what it hangs on: so little that the horse stays in the
// box that it fills at rest, where a volume is laid.
quat turn_of(Trunk joint, float u)
{
    const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    switch (joint) {
    case pelvis: return rotation(.006f * sway(u, .2f, 2), z);
    case chest: return rotation(-.05f * sway(u, .2f), x) * rotation(-.025f * sway(u, .92f), y);
    case neck: return rotation(.05f * sway(u, .95f), y) * rotation(.035f * sway(u, .08f, 2), z);
    case head: return rotation(-.08f - .02f * sway(u, .12f, 2), z);
    case tail: return rotation(.14f * sway(u, .3f), x);
    default: return rotation(.20f * sway(u, .45f), x);
    }
}

} // namespace

void walk(Model& m, const Limb& fore, const Limb& hind)
{
    std::array<int, trunk_joints> nodes{};
    for (std::size_t k = 0; k < trunk_joints; ++k) {
        const bool top = body[k].parent < 0;
        const auto parent = std::size_t(body[k].parent);
        nodes[k] = m.node(body[k].name, top ? 0 : nodes[parent],
                          top ? body[k].at : body[k].at - body[parent].at);
    }
    m.skin.joints.assign(nodes.begin(), nodes.end());
    std::array<SteedLeg, 4> all = steed_legs();
    for (SteedLeg& leg : all) {
        const Limbs& limbs = leg.limbs;
        const std::string name = leg.name;
        const auto hung = [&](const char* part, int parent, vec3 above, vec3 at) {
            return m.node(part + name, parent, leg.at(at) - above);
        };
        leg.nodes[0] = hung("upper_", nodes[limbs.trunk], body[limbs.trunk].at, limbs.top);
        leg.nodes[1] = hung("lower_", leg.nodes[0], leg.at(limbs.top), limbs.middle);
        leg.nodes[2] = hung("foot_", leg.nodes[1], leg.at(limbs.middle), limbs.foot);
        m.skin.joints.insert(m.skin.joints.end(), leg.nodes.begin(), leg.nodes.end());
    }
    m.skin.at = [fore, hind](vec3 p) { return steed_influence(fore, hind, p); };

    constexpr int keys = 80; // so that hooves hardly slide from one to the next
    Clip c;
    c.name = "walk";
    c.channels.push_back({nodes[pelvis], {}, {}});
    for (const int node : nodes) c.channels.push_back({node, {}, {}});
    const std::size_t first_leg = c.channels.size();
    for (const SteedLeg& leg : all)
        for (const int node : {leg.nodes[0], leg.nodes[1], leg.nodes[2], leg.nodes[2]})
            c.channels.push_back({node, {}, {}});
    for (int key = 0; key <= keys; ++key) {
        const float u = float(key) / keys;
        c.times_s.push_back(u);
        std::array<mat4, trunk_joints> at{};
        for (std::size_t k = 0; k < trunk_joints; ++k) {
            const bool top = body[k].parent < 0;
            vec3 shift = m.nodes[std::size_t(nodes[k])].translation;
            if (top) {
                shift.y += bob * sway(u, .1f, 2) - sink;
                c.channels[0].translations.push_back(shift);
            }
            const quat turn = turn_of(Trunk(k), u);
            c.channels[1 + k].rotations.push_back(turn);
            at[k] = glm::translate(top ? mat4(1) : at[std::size_t(body[k].parent)], shift) *
                    glm::mat4_cast(turn);
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            const SteedLeg& leg = all[i];
            const Limbs& limbs = leg.limbs;
            const auto angle = [](vec3 link) { return std::atan2(link.y, link.x); };
            const vec3 upper = limbs.middle - limbs.top, lower = limbs.foot - limbs.middle;
            const Step step = step_at(u + leg.phase, on_ground, grounded, limbs.lift);
            const vec3 wanted = leg.at(limbs.foot) + vec3(step.x, step.lift + clearance, 0);
            const vec3 hip = m.nodes[std::size_t(leg.nodes[0])].translation;
            const vec3 there = vec3(glm::inverse(at[limbs.trunk]) * vec4(wanted, 1)) - hip;
            // In the plane through its top that the leg swings in.
            const float aside = std::atan2(-there.z, -there.y);
            const Bend bend = reach(there.x, -glm::length(vec2(there.y, there.z)),
                                    glm::length(vec2(upper)), glm::length(vec2(lower)), limbs.knee);
            const quat at_top =
                rotation(aside, {1, 0, 0}) * rotation(bend.upper - angle(upper), {0, 0, 1});
            const quat at_middle = rotation(bend.lower - (angle(lower) - angle(upper)), {0, 0, 1});
            const mat4 above =
                glm::translate(glm::translate(at[limbs.trunk], hip) * glm::mat4_cast(at_top),
                               m.nodes[std::size_t(leg.nodes[1])].translation) *
                glm::mat4_cast(at_middle);
            Channel* const out = &c.channels[first_leg + 4 * i];
            out[0].rotations.push_back(at_top);
            out[1].rotations.push_back(at_middle);
            // Its toe points down in the air; on the ground it is flat.
            const quat flat = rotation(-1.1f * step.lift / .075f, {0, 0, 1});
            out[2].rotations.push_back(glm::inverse(glm::quat_cast(above)) * flat);
            out[3].translations.push_back(vec3(glm::inverse(above) * vec4(wanted, 1)));
        }
    }
    m.clips.push_back(c);
    m.extras = {{"stride", std::to_string(on_ground / grounded)},
                {"duty", std::to_string(grounded)},
                {"cycle", "1"},
                {"gait", "\"walk\""}};
}

} // namespace make
