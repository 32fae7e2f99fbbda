// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/walk.h"

#include <algorithm>
#include <cmath>

namespace make {

Model robot()
{
    Model m;
    int white = m.material("shell", srgb(0xe9e6dd), .35f),
        orange = m.material("accent", srgb(0xe5762a), .4f),
        dark = m.material("joint", srgb(0x33383f), .5f),
        glass = m.material("visor", srgb(0x161c26), .08f),
        glow = m.material("glow", srgb(0x66e6ff), .2f);
    auto field = [](auto d) { return Field([=](vec3 p) { return Sample{d(p), vec3(1)}; }); };
    const float hip_height = .418f, ankle = .078f, L = .186f, hz = .078f, e = .0082f;
    int root = m.node("robot"), pelvis = m.node("pelvis", root, {0, hip_height, 0});
    m.nodes[pelvis].parts.push_back(
        plain(surface(field([=](vec3 p0) {
                          vec3 p = mirror_z(p0);
                          float d = box(p, {0, .012f, 0}, {.066f, .040f, .082f}, .034f);
                          return smax(d,
                                      -(glm::length(vec2(p.x, p.y + .002f)) - .050f +
                                        10 * std::max(0.f, .058f - p.z)),
                                      .012f);
                      }),
                      {-.1f, -.06f, -.13f}, {.1f, .1f, .13f}, {e}),
              white));
    m.nodes[pelvis].parts.push_back(
        cylinder(.030f, .030f, .2f, .006f, 24, 4).turn(90, {1, 0, 0}).move({0, 0, -.1f}).mat(dark));
    int torso = m.node("torso", pelvis, {0, .052f, 0});
    m.nodes[torso].parts.push_back(
        cylinder(.056f, .050f, .05f, .008f, 32, 4).move({0, -.022f, 0}).mat(dark));
    auto chest = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        float w = mix(.86f, 1.12f, smooth_step(.0f, .22f, p.y));
        vec3 q(p.x / mix(.92f, 1.08f, smooth_step(0, .2f, p.y)), p.y, p.z / w);
        float d = box(q, {0, .135f, 0}, {.084f, .118f, .118f}, .062f);
        return d * .92f;
    };
    m.nodes[torso].parts.push_back(
        plain(surface(field([=](vec3 p0) {
                          vec3 p = mirror_z(p0);
                          float d = chest(p0);
                          float seam = std::abs(p.y - .098f) - .0028f;
                          d = smax(d, -std::max(seam, -(d + .006f)), .004f);
                          d = smax(d, -(glm::length(p - vec3(0, .205f, .168f)) - .052f), .012f);
                          return smax(d,
                                      -(glm::length(vec2(p.z, p.y - .170f)) - .034f +
                                        10 * std::max(0.f, .070f - p.x)),
                                      .004f);
                      }),
                      {-.13f, 0, -.17f}, {.13f, .28f, .17f}, {e}),
              white));
    m.nodes[torso].parts.push_back(cylinder(.031f, .026f, .020f, .005f, 32)
                                       .turn(-90, {0, 0, 1})
                                       .move({.078f, .170f, 0})
                                       .mat(glow));
    {
        std::vector<vec4> ring;
        for (int i = 0; i < 40; i++) {
            float a = 2 * pi * i / 40;
            ring.push_back({.0905f, .170f + .034f * std::cos(a), .034f * std::sin(a), .0052f});
        }
        m.nodes[torso].parts.push_back(tube(ring, 10, true).mat(orange));
    }
    m.nodes[torso].parts.push_back(plain(
        surface(field([=](vec3 p0) {
                    vec3 p = mirror_z(p0);
                    float d = box(p, {-.105f, .150f, 0}, {.040f, .075f, .078f}, .026f);
                    return smax(d, -(std::max(std::abs(p.y - .15f) - .004f, -(d + .007f))), .005f);
                }),
                {-.16f, .05f, -.1f}, {-.05f, .24f, .1f}, {e * 1.1f}),
        orange));
    for (int s : {1, -1}) {
        m.nodes[torso].parts.push_back(cylinder(.017f, .021f, .03f, .004f, 20)
                                           .turn(180, {1, 0, 0})
                                           .move({-.110f, .078f, s * .042f})
                                           .mat(dark));
        for (int i = 0; i < 3; i++)
            m.nodes[torso].parts.push_back(
                bevel_box({.004f, .0035f, .024f}, .003f)
                    .move({.0790f - .001f * i, .072f - .014f * i, s * .04f})
                    .mat(dark));
    }
    int neck = m.node("neck", torso, {0, .252f, 0});
    for (int i = 0; i < 3; i++)
        m.nodes[neck].parts.push_back(
            cylinder(.034f - .002f * i, .034f - .002f * i, .012f, .004f, 28)
                .move({0, -.006f + .011f * i, 0})
                .mat(dark));
    int head = m.node("head", neck, {0, .026f, 0});
    auto skull = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        float w = mix(.95f, 1.05f, smooth_step(0, .16f, p.y));
        return box({p.x, p.y, p.z / w}, {.008f, .090f, 0}, {.098f, .086f, .116f}, .068f) * .95f;
    };
    auto visor = [=](vec3 p) {
        return prism(box({p.z, p.y, 0}, {0, .090f, 0}, {.088f, .046f, 1}, .040f), p.x - .1f, .1f,
                     .004f);
    };
    m.nodes[head].parts.push_back(
        plain(surface(field([=](vec3 p) {
                          float d = skull(p);
                          return smax(d, -std::max(visor(p) - .004f, -(d + .012f)), .004f);
                      }),
                      {-.12f, -.01f, -.14f}, {.12f, .19f, .14f}, {e}),
              white));
    m.nodes[head].parts.push_back(
        plain(surface(field([=](vec3 p) {
                          float d = skull(p) + .003f;
                          return smax(smax(d, -(d + .020f), .002f), visor(p), .004f);
                      }),
                      {-.02f, .03f, -.12f}, {.12f, .15f, .12f}, {e * .8f}),
              glass));
    for (int s : {1, -1}) {
        m.nodes[head].parts.push_back(ball_mesh(.0165f, 8)
                                          .scale({.42f, 1.25f, .9f})
                                          .turn(-s * 14.f, {0, 1, 0})
                                          .move({.1015f, .093f, s * .037f})
                                          .mat(glow));
        Mesh ear = cylinder(.037f, .031f, .022f, .006f, 28, 2).turn(90, {1, 0, 0});
        if (s < 0) ear = mirrored(ear);
        m.nodes[head].parts.push_back(ear.move({.0f, .09f, s * .112f}).mat(orange));
        Mesh hub = cylinder(.016f, .014f, .014f, .004f, 20).turn(90, {1, 0, 0});
        if (s < 0) hub = mirrored(hub);
        m.nodes[head].parts.push_back(hub.move({.0f, .09f, s * .130f}).mat(dark));
    }
    m.nodes[head].parts.push_back(
        tube({{-.02f, .168f, 0, .0055f}, {-.03f, .215f, 0, .0042f}}, 12).mat(dark));
    m.nodes[head].parts.push_back(ball_mesh(.0135f, 6).move({-.033f, .226f, 0}).mat(glow));
    struct Arm {
        int shoulder, elbow, hand;
        float s;
    };
    std::vector<Arm> arms;
    struct LegN {
        int hip, knee, foot;
        float s;
    };
    std::vector<LegN> legs;
    // limbs, built once for the left and mirrored
    Mesh shoulder =
        plain(surface(field([=](vec3 p) {
                          float d = ellipsoid(p, {0, .004f, .004f}, {.050f, .048f, .046f});
                          return smax(d, -(std::max(std::abs(p.y + .012f) - .0022f, -(d + .004f))),
                                      .003f);
                      }),
                      {-.06f, -.06f, -.06f}, {.06f, .06f, .06f}, {e, false}),
              orange);
    Mesh uparm = cylinder(.026f, .026f, .085f, .006f, 28, 5).move({0, -.115f, .0f}).mat(dark);
    Mesh elbow_ball = ball_mesh(.031f, 8).mat(dark);
    Mesh fore = plain(
        surface(field([=](vec3 p) {
                    float t = saturate(-p.y / .13f), r = mix(.028f, .046f, smooth_step(0, .8f, t));
                    float d =
                        smax(glm::length(vec2(p.x, p.z)) - r, std::abs(p.y + .078f) - .056f, .024f);
                    return smax(d, -(std::max(std::abs(p.y + .108f) - .002f, -(d + .004f))),
                                .003f) *
                           .95f;
                }),
                {-.06f, -.15f, -.06f}, {.06f, .0f, .06f}, {e, false}),
        white);
    Mesh palm = plain(surface(field([=](vec3 p) {
                                  return box(p, {0, -.024f, 0}, {.026f, .024f, .016f}, .013f);
                              }),
                              {-.04f, -.06f, -.03f}, {.04f, .01f, .03f}, {e * .8f, false}),
                      dark);
    std::vector<Mesh> fingers;
    for (int i = 0; i < 3; i++) {
        float a = -.018f + .018f * i;
        fingers.push_back(tube(curve({{a, -.038f, 0, .0098f},
                                      {a * 1.25f, -.064f, -.002f, .0095f},
                                      {a * 1.2f, -.088f, -.012f, .0080f}},
                                     3),
                               12)
                              .mat(white));
    }
    fingers.push_back(tube(curve({{.024f, -.016f, -.004f, .0095f},
                                  {.040f, -.034f, -.010f, .0092f},
                                  {.040f, -.056f, -.016f, .0078f}},
                                 3),
                           12)
                          .mat(white));
    Mesh hip_ball = ball_mesh(.043f, 10).mat(dark);
    Mesh thigh = plain(
        surface(field([=](vec3 p) {
                    float t = saturate(-p.y / .18f), r = mix(.046f, .036f, t);
                    float d = smax(glm::length(vec2(p.x, p.z * 1.05f)) - r,
                                   std::abs(p.y + .085f) - .062f, .020f);
                    return smax(d, -(std::max(std::abs(p.y + .045f) - .002f, -(d + .004f))), .003f);
                }),
                {-.06f, -.17f, -.06f}, {.06f, 0, .06f}, {e, false}),
        white);
    Mesh knee = cylinder(.036f, .036f, .064f, .008f, 32, 2)
                    .turn(90, {1, 0, 0})
                    .move({0, 0, -.032f})
                    .mat(dark),
         cap = plain(surface(field([=](vec3 p) {
                                 return smax(ellipsoid(p, {.018f, 0, 0}, {.032f, .042f, .036f}),
                                             .0f - p.x + .012f, .01f);
                             }),
                             {0, -.06f, -.05f}, {.06f, .06f, .05f}, {e * .9f, false}),
                     orange);
    Mesh shin =
        plain(surface(field([=](vec3 p) {
                          float t = saturate(-p.y / .18f),
                                r = mix(.034f, .058f, smooth_step(.1f, .95f, t));
                          float d = smax(glm::length(vec2(p.x + .004f, p.z * 1.06f)) - r,
                                         std::abs(p.y + .098f) - .070f, .022f);
                          return smax(d, -(std::max(std::abs(p.y + .142f) - .002f, -(d + .004f))),
                                      .003f) *
                                 .95f;
                      }),
                      {-.08f, -.19f, -.08f}, {.08f, 0, .08f}, {e, false}),
              white);
    Mesh ankle_ball = ball_mesh(.034f, 8).mat(dark);
    Mesh foot = plain(surface(field([=](vec3 p) {
                                  float w = mix(.050f, .060f, smooth_step(-.06f, .08f, p.x)),
                                        top = mix(.006f, -.030f, smooth_step(.0f, .10f, p.x));
                                  float d =
                                      prism(box({p.x, p.z, 0}, {.028f, 0, 0}, {.094f, w, 1}, .050f),
                                            p.y - (-ankle + .016f + top) * .5f - -.016f,
                                            (top + ankle + .0f - .016f) * .5f, .022f);
                                  return d * .9f;
                              }),
                              {-.1f, -.085f, -.08f}, {.16f, .03f, .08f}, {e, true}),
                      white);
    Mesh sole = prism_mesh(smooth_loop({{-.070f, 0},
                                        {-.062f, .040f},
                                        {-.02f, .053f},
                                        {.05f, .063f},
                                        {.105f, .050f},
                                        {.126f, 0},
                                        {.105f, -.050f},
                                        {.05f, -.063f},
                                        {-.02f, -.053f},
                                        {-.062f, -.040f}},
                                       4),
                           .0115f, .005f)
                    .turn(90, {1, 0, 0})
                    .move({0, -ankle + .0115f, 0})
                    .mat(orange);
    for (int s : {1, -1}) {
        auto mir = [&](const Mesh& k) { return s > 0 ? k : mirrored(k); };
        std::string id = s > 0 ? "_l" : "_r";
        auto P = [&](int n) -> std::vector<Mesh>& { return m.nodes[n].parts; };
        int sh = m.node("shoulder" + id, torso, {0, .205f, s * .172f}),
            el = m.node("elbow" + id, sh, {0, -.130f, s * .010f}),
            ha = m.node("hand" + id, el, {0, -.138f, 0});
        P(sh) = {mir(shoulder), mir(uparm)};
        P(el) = {mir(elbow_ball), mir(fore)};
        P(ha) = {mir(palm)};
        for (auto& f : fingers) P(ha).push_back(mir(f));
        arms.push_back({sh, el, ha, float(s)});
        int hi = m.node("hip" + id, pelvis, {0, 0, s * hz}),
            kn = m.node("knee" + id, hi, {0, -L, 0}), fo = m.node("foot" + id, kn, {0, -L, 0});
        P(hi) = {mir(hip_ball), mir(thigh)};
        P(kn) = {mir(knee), mir(cap), mir(shin)};
        P(fo) = {mir(ankle_ball), mir(foot), mir(sole)};
        legs.push_back({hi, kn, fo, float(s)});
    }
    const int K = 48;
    const float travel = .23f, duty = .60f;
    Clip c;
    c.name = "walk";
    auto chan = [&](int n) {
        c.channels.push_back({n, {}, {}});
        return int(c.channels.size()) - 1;
    };
    int pt = chan(pelvis), pr = chan(torso), hr = chan(head);
    std::vector<std::array<int, 3>> ac, lc;
    for (auto& a : arms) ac.push_back({chan(a.shoulder), chan(a.elbow), chan(a.hand)});
    for (auto& l : legs) lc.push_back({chan(l.hip), chan(l.knee), chan(l.foot)});
    for (int k = 0; k <= K; k++) {
        float u = float(k) / K, w = 2 * pi * u;
        c.times_s.push_back(u);
        float bob = -.006f + .009f * std::cos(2 * (w - 2 * pi * duty / 2));
        vec3 pp(0, hip_height + bob, 0);
        c.channels[pt].translations.push_back(pp);
        c.channels[pr].rotations.push_back(rotation(.09f * std::sin(w + .35f), {0, 1, 0}) *
                                           rotation(-.05f, {0, 0, 1}) *
                                           rotation(.025f * std::sin(w), {1, 0, 0}));
        c.channels[hr].rotations.push_back(rotation(-.08f * std::sin(w + .35f), {0, 1, 0}) *
                                           rotation(.05f + .02f * std::sin(2 * w), {0, 0, 1}));
        for (size_t i = 0; i < 2; i++) {
            float ph = u + (i ? .5f : 0);
            Step st = step_at(ph, travel, duty, .060f);
            float dx = st.x, dy = ankle + st.lift - pp.y;
            // links hang along -y: express the target in a frame whose +x is down; the knee bends
            // forward
            Bend b = reach(-dy, dx, L, L, 1);
            c.channels[lc[i][0]].rotations.push_back(rotation(b.upper, {0, 0, 1}));
            c.channels[lc[i][1]].rotations.push_back(rotation(b.lower, {0, 0, 1}));
            float fr = ph - std::floor(ph),
                  pitch = fr > duty ? -.16f * std::sin(2 * pi * (fr - duty) / (1 - duty)) *
                                          (1 - .3f * (fr - duty))
                                    : 0;
            c.channels[lc[i][2]].rotations.push_back(
                rotation(-b.upper - b.lower + pitch, {0, 0, 1}));
            float sw = -.42f * std::cos(2 * pi * (ph - .05f));
            c.channels[ac[i][0]].rotations.push_back(rotation(sw, {0, 0, 1}) *
                                                     rotation(arms[i].s * -.10f, {1, 0, 0}));
            c.channels[ac[i][1]].rotations.push_back(
                rotation(.42f + .22f * std::sin(2 * pi * (ph - .05f) - pi / 2), {0, 0, 1}));
            c.channels[ac[i][2]].rotations.push_back(
                rotation(.08f * std::sin(2 * pi * ph), {0, 0, 1}));
        }
    }
    m.clips.push_back(c);
    m.extras = {{"stride", std::to_string(travel / duty)},
                {"duty", std::to_string(duty)},
                {"cycle", "1"},
                {"gait", "\"biped\""}};
    for (auto& h : c.channels) {
        if (!h.rotations.empty())
            m.nodes[h.node].rotation = h.rotations[6];
        else
            m.nodes[h.node].translation = h.translations[6];
    }
    return m;
}

} // namespace make
