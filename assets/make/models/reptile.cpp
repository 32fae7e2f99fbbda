// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/models/reptile.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

// distance to the nearest of a jittered lattice of dots
float spots(vec2 p, float cell)
{
    float d = 1e9f;
    vec2 c = glm::floor(p / cell);
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            vec2 k = c + vec2(i, j);
            vec2 o(noise(vec3(k, 2)), noise(vec3(k, 7)));
            d = std::min(d, glm::distance(p, (k + .5f + .42f * o) * cell));
        }
    return d;
}

} // namespace

Model reptile()
{
    Model m;
    int skin = m.material("skin", vec3(1), .6f), eye = m.material("eye", srgb(0x15140f), .08f);
    Loft body({{.0f, .008f, .004f, .006f, .006f, 2},
               {.12f, .014f, .011f, .012f, .012f, 2},
               {.28f, .021f, .021f, .019f, .019f, 2.1f},
               {.40f, .026f, .033f, .024f, .025f, 2.2f},
               {.47f, .029f, .052f, .028f, .028f, 2.3f},
               {.56f, .031f, .072f, .032f, .030f, 2.4f},
               {.65f, .031f, .070f, .031f, .030f, 2.3f},
               {.73f, .031f, .052f, .027f, .027f, 2.2f},
               {.785f, .033f, .043f, .025f, .024f, 2.2f},
               {.84f, .035f, .058f, .028f, .023f, 2.3f},
               {.885f, .035f, .060f, .028f, .022f, 2.3f},
               {.94f, .034f, .041f, .022f, .018f, 2.3f},
               {.975f, .033f, .025f, .015f, .013f, 2.2f}});
    Limb fore({{.70f, .033f, .040f, .028f},
               {.690f, .038f, .090f, .0205f},
               {.688f, .034f, .122f, .018f},
               {.725f, .020f, .142f, .0145f},
               {.758f, .012f, .156f, .013f}}),
        hind({{.49f, .032f, .036f, .032f},
              {.520f, .038f, .085f, .0245f},
              {.535f, .034f, .122f, .020f},
              {.490f, .021f, .140f, .0155f},
              {.452f, .012f, .158f, .0135f}});
    struct Toe {
        vec3 a, b;
    };
    std::vector<Toe> toes;
    auto foot = [&](vec3 o, float dir) {
        for (int i = 0; i < 5; i++) {
            float a = glm::radians(dir + (i - 2) * 33.f), l = i == 0 || i == 4 ? .034f : .044f;
            toes.push_back({o, o + vec3(std::cos(a) * l, -.004f, std::sin(a) * l)});
        }
    };
    foot({.762f, .0115f, .158f}, 35);
    foot({.449f, .0115f, .161f}, 95);
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0), back = srgb(0x4f8a5b), spot = srgb(0x2d5b46), pale = srgb(0xe6e3b8),
             lime = srgb(0x9fbf6a);
        Sample s{body(p), {}};
        s.distance = smin(s.distance, fore(p), .020f);
        s.distance = smin(s.distance, hind(p), .024f);
        for (auto& t : toes)
            if (glm::length(p - t.a) < .08f) {
                s.distance = smin(s.distance, capsule(p, t.a, t.b, .0080f, .0068f), .007f);
                s.distance = smin(s.distance, ball(p, t.b, .0088f), .004f);
            }
        s.color = glm::mix(back, lime,
                           .8f * smooth_step(.024f, .010f, spots(vec2(p0.x, p0.z) + .37f, .060f)));
        s.color = glm::mix(s.color, spot,
                           smooth_step(.0165f, .0100f, spots({p0.x, p0.z}, .040f)) *
                               smooth_step(.02f, .035f, p.y));
        float strip = std::abs(p.z) / mix(.012f, .022f, saturate(p.x * 1.4f));
        s.color = glm::mix(s.color, spot,
                           .8f * smooth_step(1.15f, .8f, strip) * smooth_step(.03f, .045f, p.y) *
                               (p.x < .80f));
        s.color = glm::mix(pale, s.color, smooth_step(.012f, .024f, p.y));
        float du = .020f, cx = std::round(p.x / du) * du;
        if (cx > .10f && cx < .80f)
            add(s,
                ellipsoid(p,
                          {cx,
                           cx < .47f ? mix(.0265f, .0565f, saturate((cx - .12f) / .35f))
                                     : mix(.0575f, .0625f, 1 - std::abs(cx - .6f) / .2f),
                           0},
                          {.0080f, .0075f, .0042f}),
                .004f);
        add(s, ellipsoid(p, {.900f, .0560f, .036f}, {.020f, .012f, .014f}), .010f);
        cut(s, ball(p, {.905f, .0570f, .0475f}, .0075f), .004f);
        float mouth = path_distance({p.x, p.y},
                                    {{.855f, .030f}, {.89f, .027f}, {.94f, .029f}, {1.05f, .033f}});
        cut(s, std::max(mouth - .0012f, -(s.distance + .004f)), srgb(0x26392c), .003f);
        cut(s, ball(p, {.985f, .0420f, .010f}, .0030f), srgb(0x1d2a20), .003f);
        return s;
    };
    Mesh b = surface(f, {-.02f, -.003f, -.23f}, {1.02f, .09f, .23f}, {.0056f});
    b.uvs.resize(b.faces.size());
    for (size_t i = 0; i < b.faces.size(); i++)
        for (int k = 0; k < 4; k++) {
            vec3 p = b.points[b.faces[i][k]];
            b.uvs[i][k] = {p.x, p.z / .5f + .5f};
        }
    const auto stand = [](vec3 p) { // off its belly, on its feet
        return p + vec3(0, reptile_rise * smooth_step(.150f, .075f, std::abs(p.z)), 0);
    };
    auto& P = m.root().parts;
    P.push_back(b.warp(stand).mat(skin));
    both(P, ball_mesh(.0092f, 6).move({.905f, .0565f, .0425f}).warp(stand).mat(eye));
    crawl(m, fore, hind);
    return m;
}

} // namespace make
