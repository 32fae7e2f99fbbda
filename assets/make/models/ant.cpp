// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/walk.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace make {

Model ant()
{
    Model m;
    int shell = m.material("shell", vec3(1), .28f), limb = m.material("limb", srgb(0x5a2a1c), .4f),
        eye = m.material("eye", srgb(0x15100e), .08f),
        jaw = m.material("mandible", srgb(0x7d3a1c), .35f);
    vec3 red = srgb(0x9c4224), brown = srgb(0x5e2717), black = srgb(0x2a1712);
    int root = m.node("ant"), body = m.node("thorax", root, {.50f, .175f, 0});
    // the three parts of the body, each about its own joint
    Mesh thorax = surface(
        [=](vec3 p0) {
            vec3 p = mirror_z(p0);
            Sample s{ellipsoid(p, {.065f, .012f, 0}, {.075f, .060f, .055f}), red};
            add(s, ellipsoid(p, {-.030f, .004f, 0}, {.060f, .046f, .043f}), red, .030f);
            add(s, ellipsoid(p, {-.085f, -.012f, 0}, {.050f, .038f, .036f}), brown, .030f);
            add(s, capsule(p, {.115f, .010f, 0}, {.160f, .012f, 0}, .030f, .022f), red, .02f);
            for (float x : {.070f, .004f, -.062f})
                add(s, ball(p, {x, -.034f, .032f}, .021f), brown, .014f);
            float g = std::abs(p.x - (.018f + .25f * (p.y - .03f))) - .0015f;
            cut(s, std::max(g, -(s.distance + .006f)), .006f);
            add(s, capsule(p, {-.118f, .012f, .016f}, {-.150f, .036f, .022f}, .0075f, .0022f),
                brown, .008f);
            return s;
        },
        {-.20f, -.08f, -.08f}, {.2f, .1f, .08f}, {.0098f});
    m.nodes[body].parts.push_back(thorax.mat(shell));
    int petiole = m.node("petiole", body, {-.125f, -.016f, 0});
    m.nodes[petiole].parts.push_back(
        surface(
            [=](vec3 p) {
                Sample s{capsule(p, {.01f, 0, 0}, {-.075f, -.002f, 0}, .0165f, .0165f), brown};
                add(s, ellipsoid(p, {-.034f, .022f, 0}, {.017f, .029f, .023f}), red, .012f);
                return s;
            },
            {-.1f, -.04f, -.04f}, {.04f, .06f, .04f}, {.0085f})
            .mat(shell));
    int gaster = m.node("gaster", petiole, {-.066f, 0, 0});
    m.nodes[gaster].parts.push_back(
        surface(
            [=](vec3 p0) {
                vec3 p = mirror_z(p0);
                float r = 0;
                vec3 k = black;
                Sample s{ellipsoid(p, {-.128f, .022f, 0}, {.138f, .098f, .098f}), k};
                add(s, capsule(p, {.004f, 0, 0}, {-.05f, .01f, 0}, .019f, .04f), black, .03f);
                add(s, capsule(p, {-.235f, .008f, 0}, {-.285f, -.008f, 0}, .032f, .008f), .03f);
                for (float x : {-.075f, -.140f, -.200f}) {
                    float d = std::abs(p.x - x - .35f * (p.y - .02f) * (p.y - .02f) / .1f);
                    r = std::max(r, smooth_step(.010f, .003f, d));
                    cut(s, std::max(d - .002f, -(s.distance + .006f)), .009f);
                }
                s.color = glm::mix(s.color, srgb(0x9b6a3a), r * .75f);
                return s;
            },
            {-.31f, -.1f, -.12f}, {.04f, .14f, .12f}, {.0115f})
            .mat(shell));
    int head = m.node("head", body, {.158f, .014f, 0});
    m.nodes[head].parts.push_back(
        surface(
            [=](vec3 p0) {
                vec3 p = mirror_z(p0);
                Sample s{ellipsoid(p, {.070f, .000f, .020f}, {.078f, .062f, .058f}), red};
                add(s, ellipsoid(p, {.118f, -.016f, 0}, {.050f, .040f, .050f}), red, .035f);
                add(s, capsule(p, {0, 0, 0}, {.03f, 0, 0}, .024f, .034f), brown, .02f);
                add(s, ellipsoid(p, {.150f, -.020f, .0f}, {.020f, .018f, .034f}), brown, .014f);
                cut(s, ball(p, {.130f, .024f, .026f}, .010f), brown, .008f);
                s.color = glm::mix(s.color, brown, .5f * smooth_step(-.01f, -.04f, p.y));
                return s;
            },
            {-.04f, -.08f, -.1f}, {.19f, .09f, .1f}, {.0098f})
            .mat(shell));
    for (int s : {1, -1}) {
        auto mir = [&](const Mesh& k) { return s > 0 ? k : mirrored(k); };
        m.nodes[head].parts.push_back(
            mir(ball_mesh(.021f, 8).scale({1, .95f, .62f}).move({.092f, .022f, .0665f}).mat(eye)));
        int mn = m.node(s > 0 ? "mandible_l" : "mandible_r", head, {.155f, -.024f, s * .024f});
        m.nodes[mn].parts.push_back(mir(tube(curve({{-.006f, 0, .002f, .0125f},
                                                    {.022f, -.004f, .014f, .0125f},
                                                    {.050f, -.008f, .008f, .0095f},
                                                    {.066f, -.010f, -.010f, .0030f}},
                                                   4),
                                             10)
                                            .mat(jaw)));
        int an = m.node(s > 0 ? "antenna_l" : "antenna_r", head, {.130f, .026f, s * .028f});
        m.nodes[an].parts.push_back(mir(tube(curve({{-.004f, 0, 0, .0085f},
                                                    {.008f, .010f, .006f, .0065f},
                                                    {.045f, .052f, .034f, .0058f},
                                                    {.085f, .092f, .060f, .0068f}},
                                                   4),
                                             8)
                                            .mat(limb)));
        int fl = m.node(s > 0 ? "flagellum_l" : "flagellum_r", an, {.085f, .092f, s * .060f});
        std::vector<vec4> seg;
        for (int i = 0; i <= 30; i++) {
            float t = i / 30.f;
            vec3 c(.125f * t, -.020f * t - .060f * t * t, .045f * t);
            seg.push_back(
                vec4(c, (.0062f + .0035f * t) * (1 + .16f * std::cos(t * 30 / 3 * 2 * pi))));
        }
        m.nodes[fl].parts.push_back(mir(tube(seg, 8).mat(limb)));
    }
    // legs
    struct Leg {
        const char* n;
        vec3 hip, foot;
        float l1, l2, phase;
        int coxa, femur, tibia;
    };
    std::vector<Leg> legs;
    const float C = .030f;
    for (int s : {1, -1})
        for (int i = 0; i < 3; i++) {
            vec3 hip[3] = {{.072f, -.045f, .038f}, {.004f, -.045f, .042f}, {-.064f, -.045f, .038f}},
                 foot[3] = {{.205f, 0, .205f}, {.010f, 0, .265f}, {-.235f, 0, .235f}};
            float l1[3] = {.150f, .150f, .180f}, l2[3] = {.205f, .205f, .245f};
            Leg g{};
            g.hip = hip[i] * vec3(1, 1, s);
            g.foot = (foot[i] + vec3(.50f, 0, 0)) * vec3(1, 1, s);
            g.l1 = l1[i];
            g.l2 = l2[i];
            g.phase = ((i == 1) != (s < 0)) ? .5f : 0.f;
            std::string id = std::string(i == 0   ? "front"
                                         : i == 1 ? "mid"
                                                  : "hind") +
                             (s > 0 ? "_l" : "_r");
            g.coxa = m.node("coxa_" + id, body, g.hip);
            g.femur = m.node("femur_" + id, g.coxa, {C, 0, 0});
            g.tibia = m.node("tibia_" + id, g.femur, {g.l1, 0, 0});
            m.nodes[g.coxa].parts.push_back(
                tube({{0, 0, 0, .0165f}, {C * .6f, 0, 0, .0155f}, {C, 0, 0, .0120f}}, 10)
                    .mat(limb));
            std::vector<vec4> fe, ti;
            for (int j = 0; j <= 10; j++) {
                float t = j / 10.f;
                fe.push_back({g.l1 * t, .010f * std::sin(pi * t), 0,
                              mix(.0095f, .0085f, t) + .0072f * std::sin(pi * std::pow(t, .8f))});
            }
            for (int j = 0; j <= 14; j++) {
                float t = j / 14.f, a = t < .62f ? t / .62f : 0,
                      r = t < .62f
                              ? mix(.0080f, .0062f, a) + .0035f * std::sin(pi * a)
                              : .0056f * (1 + .18f * std::cos((t - .62f) / .38f * 4 * 2 * pi)) *
                                    mix(1.f, .8f, (t - .62f) / .38f);
                ti.push_back({g.l2 * t, .016f * std::sin(pi * t), 0, r});
            }
            ti.back().x -= .004f;
            m.nodes[g.femur].parts.push_back(tube(fe, 10).mat(limb));
            m.nodes[g.tibia].parts.push_back(tube(ti, 9).mat(limb));
            legs.push_back(g);
        }
    const int K = 48;
    const float T = 1, travel = .17f, duty = .55f;
    Clip c;
    c.name = "walk";
    auto chan = [&](int n) {
        c.channels.push_back({n, {}, {}});
        return int(c.channels.size()) - 1;
    };
    int bt = chan(body), br = chan(body);
    std::vector<std::array<int, 3>> lc;
    for (auto& g : legs) lc.push_back({chan(g.coxa), chan(g.femur), chan(g.tibia)});
    std::map<std::string, int> ex;
    for (size_t i = 0; i < m.nodes.size(); i++)
        for (const char* n :
             {"head", "gaster", "antenna_l", "antenna_r", "flagellum_l", "flagellum_r"})
            if (m.nodes[i].name == n) ex[n] = chan(int(i));
    for (int k = 0; k <= K; k++) {
        float u = float(k) / K, w = 2 * pi * u;
        c.times_s.push_back(T * u);
        vec3 bp = m.nodes[body].translation + vec3(0, .0035f * std::cos(2 * w), 0);
        quat bq = rotation(.022f * std::sin(w), {0, 1, 0}) *
                  rotation(.014f * std::sin(2 * w), {0, 0, 1}) *
                  rotation(.012f * std::cos(w), {1, 0, 0});
        c.channels[bt].translations.push_back(bp);
        c.channels[br].rotations.push_back(bq);
        c.channels[ex["head"]].rotations.push_back(
            rotation(-.03f * std::sin(w), {0, 1, 0}) *
            rotation(.03f * std::sin(2 * w + .7f), {0, 0, 1}));
        c.channels[ex["gaster"]].rotations.push_back(
            rotation(.04f * std::sin(2 * w + 1.f), {0, 0, 1}) *
            rotation(-.03f * std::sin(w), {0, 1, 0}));
        for (int s : {1, -1}) {
            std::string e = s > 0 ? "_l" : "_r";
            float a = w + (s > 0 ? 0 : pi);
            c.channels[ex["antenna" + e]].rotations.push_back(
                rotation(.14f * std::sin(a), {0, 1, 0}) *
                rotation(.10f * std::sin(2 * a), {0, 0, 1}));
            c.channels[ex["flagellum" + e]].rotations.push_back(
                rotation(.18f * std::sin(2 * a + .8f), {0, 0, 1}));
        }
        for (size_t i = 0; i < legs.size(); i++) {
            auto& g = legs[i];
            Step st = step_at(u + g.phase, travel, duty, .055f);
            vec3 foot = g.foot + vec3(st.x, st.lift + .0045f, 0);
            vec3 d = glm::inverse(bq) * (foot - bp) - g.hip;
            float yaw = -std::atan2(d.z, d.x), r = std::sqrt(d.x * d.x + d.z * d.z) - C;
            Bend b = reach(r, d.y, g.l1, g.l2, 1);
            c.channels[lc[i][0]].rotations.push_back(rotation(yaw, {0, 1, 0}));
            c.channels[lc[i][1]].rotations.push_back(rotation(b.upper, {0, 0, 1}));
            c.channels[lc[i][2]].rotations.push_back(rotation(b.lower, {0, 0, 1}));
        }
    }
    for (auto& h : c.channels) {
        if (!h.rotations.empty())
            m.nodes[h.node].rotation = h.rotations[0];
        else
            m.nodes[h.node].translation = h.translations[0];
    }
    m.clips.push_back(c);
    m.extras = {{"stride", std::to_string(travel / duty)},
                {"duty", std::to_string(duty)},
                {"cycle", "1"},
                {"gait", "\"tripod\""}};
    return m;
}

} // namespace make
