// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model crocodile()
{
    Model m;
    int skin = m.material("skin", vec3(1), .75f), eye = m.material("eye", srgb(0xd9b23c), .15f),
        pupil = m.material("pupil", srgb(0x14110c), .1f),
        tooth = m.material("tooth", srgb(0xf3ead2), .35f),
        claw = m.material("claw", srgb(0x2b2a22), .4f);
    Loft body({{.0f, .016f, .0035f, .008f, .007f, 2},
               {.10f, .026f, .010f, .022f, .020f, 2},
               {.24f, .038f, .023f, .031f, .032f, 2.1f},
               {.38f, .046f, .044f, .040f, .042f, 2.2f},
               {.48f, .051f, .066f, .044f, .048f, 2.3f},
               {.58f, .053f, .081f, .048f, .051f, 2.4f},
               {.67f, .053f, .076f, .046f, .050f, 2.3f},
               {.73f, .054f, .055f, .040f, .044f, 2.2f},
               {.785f, .056f, .047f, .036f, .038f, 2.2f},
               {.81f, .058f, .040f, .030f, .030f, 2.2f}});
    Loft upper({{.765f, .062f, .044f, .030f, .020f, 2.3f},
                {.805f, .063f, .050f, .031f, .017f, 2.5f},
                {.845f, .062f, .041f, .026f, .014f, 2.5f},
                {.885f, .060f, .031f, .0195f, .0125f, 2.4f},
                {.93f, .059f, .0255f, .0155f, .0115f, 2.3f},
                {.962f, .059f, .0275f, .0165f, .0115f, 2.2f},
                {.985f, .0585f, .021f, .0135f, .010f, 2.1f}});
    Loft lower({{.765f, .040f, .043f, .017f, .021f, 2.2f},
                {.82f, .037f, .044f, .0085f, .017f, 2.3f},
                {.87f, .035f, .031f, .0070f, .0125f, 2.3f},
                {.94f, .033f, .0225f, .0065f, .0100f, 2.2f},
                {.972f, .033f, .017f, .006f, .0085f, 2.1f}});
    Limb foreleg({{.695f, .052f, .052f, .036f},
                  {.680f, .060f, .098f, .0265f},
                  {.664f, .052f, .132f, .021f},
                  {.684f, .030f, .151f, .0165f},
                  {.706f, .014f, .163f, .0145f}});
    Limb hindleg({{.470f, .052f, .042f, .044f},
                  {.500f, .061f, .092f, .034f},
                  {.528f, .054f, .134f, .0245f},
                  {.497f, .030f, .154f, .0185f},
                  {.478f, .015f, .168f, .016f}});
    struct Toe {
        vec3 a, b;
        float r;
    };
    std::vector<Toe> toes;
    auto foot = [&](vec3 o, float dir, int n, float len, float r) {
        for (int i = 0; i < n; i++) {
            float a = glm::radians(dir + (float(i) - (n - 1) / 2.f) * 27.f),
                  l = len * (i == 0 || i == n - 1 ? .82f : 1.f);
            vec3 e(std::cos(a), 0, std::sin(a));
            toes.push_back({o, o + e * l + vec3(0, -o.y + r * .92f, 0), r});
        }
    };
    foot({.708f, .0125f, .164f}, 38, 5, .042f, .0066f);
    foot({.482f, .0135f, .170f}, 42, 4, .052f, .0072f);
    float jaw = -5.5f;
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        vec3 back = srgb(0x515c37), flank = srgb(0x87894f), belly = srgb(0xe2d9a8);
        float t = smooth_step(.020f, .052f, p.y + .01f * noise(p0 * 45.f)),
              side = smooth_step(.052f, .085f, p.y + .012f * noise(p0 * 60.f + 7.f));
        vec3 k = glm::mix(belly, flank, t);
        k = glm::mix(k, back, side);
        float stripe = std::sin(p.x * 52.f + 2.2f * noise(p0 * 14.f));
        if (p.x < .72f) k = glm::mix(k, back * .8f, .55f * smooth_step(.35f, .75f, stripe) * t);
        k *= 1 + .10f * noise(p0 * 150.f);
        float bd = body(p);
        Sample s{bd, k};
        s = join(s,
                 {foreleg(p),
                  glm::mix(flank, back, smooth_step(.02f, .06f, p.y + .01f * noise(p0 * 60.f)))},
                 .022f);
        s = join(s,
                 {hindleg(p),
                  glm::mix(flank, back, smooth_step(.02f, .06f, p.y + .01f * noise(p0 * 60.f)))},
                 .026f);
        for (auto& q : toes)
            if (glm::length(p - q.a) < .09f)
                add(s, capsule(p, q.a, q.b, q.r * 1.25f, q.r), flank * .9f, .006f);
        vec3 mouth = srgb(0xb96a5e);
        float up = upper(p);
        vec3 lp = turned(p, {.79f, .04f, 0}, jaw, {0, 0, 1});
        float lo = lower(lp);
        Sample hd{
            up, glm::mix(k, mouth, smooth_step(.051f, .048f, p.y) * smooth_step(.83f, .85f, p.x))};
        Sample lj{lo, glm::mix(glm::mix(belly, flank, smooth_step(.022f, .034f, lp.y)), mouth,
                               smooth_step(.0375f, .0405f, lp.y))};
        s = join(s, hd, .018f);
        s = join(s, lj, .010f * smooth_step(.86f, .80f, p.x) + .002f);
        add(s, capsule(p, {.800f, .086f, .0235f}, {.842f, .088f, .0225f}, .0095f, .0115f),
            .010f); // brow ridge
        cut(s, ball(p, {.842f, .0905f, .0315f}, .0072f), .003f);
        add(s, ellipsoid(p, {.974f, .0705f, .0105f}, {.0115f, .0065f, .0075f}), .006f);
        cut(s, ball(p, {.979f, .0775f, .0100f}, .0030f), srgb(0x1c1a12), .002f);
        // scutes: keeled rows on the back, a doubled then single crest on the tail
        float du = .0235f, i = std::round((p.x - .40f) / du), cx = .40f + i * du;
        if (cx > .385f && cx < .79f && p.y > .06f) {
            float bw = cx < .58f ? mix(.040f, .081f, saturate((cx - .38f) / .2f))
                                 : mix(.081f, .05f, saturate((cx - .60f) / .17f)),
                  top = .1f;
            for (int r = 0; r < 3; r++) {
                float cz = bw * (.14f + .26f * r), a = cz / bw;
                top = (cx < .58f ? mix(.086f, .1010f, saturate((cx - .38f) / .2f))
                                 : mix(.1010f, .0925f, saturate((cx - .60f) / .16f))) -
                      .053f;
                float cy = .053f + top * std::pow(1 - std::pow(a, 2.4f), 1 / 2.4f);
                add(s, ellipsoid(p, {cx, cy, cz}, {.0095f, .0075f, .0052f}), back * .75f, .0035f);
            }
        } else if (cx <= .385f && cx > .02f && p.y > .02f) {
            float w = cx < .1f    ? mix(.0035f, .010f, cx / .1f)
                      : cx < .24f ? mix(.010f, .023f, (cx - .1f) / .14f)
                                  : mix(.023f, .044f, (cx - .24f) / .14f),
                  top = cx < .1f    ? mix(.024f, .048f, cx / .1f)
                        : cx < .24f ? mix(.048f, .069f, (cx - .1f) / .14f)
                                    : mix(.069f, .086f, (cx - .24f) / .14f);
            float cz = cx < .20f ? 0 : w * .45f * saturate((cx - .20f) / .06f),
                  hgt = mix(.017f, .012f, saturate(cx / .38f));
            add(s,
                tilted(p, {cx, top - .003f - .1f * cz, cz}, {.0105f, hgt, .0042f}, 25, {0, 0, 1}),
                back * .7f, .004f);
        }
        return s;
    };
    Mesh b = surface(f, {-.01f, -.002f, -.24f}, {1.02f, .125f, .24f}, {.0056f});
    wrap_about_x(b, .045f);
    auto& P = m.root().parts;
    P.push_back(b.mat(skin));
    both(P, ball_mesh(.0088f, 6).move({.842f, .0900f, .0262f}).mat(eye));
    both(P, ball_mesh(.0060f, 4)
                .scale({.38f, 1, .62f})
                .turn(20, {0, 1, 0})
                .move({.8437f, .0905f, .0318f})
                .mat(pupil));
    for (int i = 0; i < 9; i++) {
        float x = .862f + .0135f * i, w = mix(.0355f, .0245f, saturate((x - .86f) / .06f));
        if (x > .95f) w = mix(.0245f, .0180f, saturate((x - .95f) / .03f));
        float l = .0115f * (.75f + .5f * std::abs(std::sin(i * 1.9f)));
        both(P, cone({x, .0545f, w * .93f}, {x + .002f, .0515f - l, w * 1.0f}, .0033f, tooth));
        vec3 q(x - .004f, .0385f, w * .84f), tip(x - .003f, .041f + l * .8f, w * .90f);
        mat3 R(glm::rotate(mat4(1), glm::radians(jaw), vec3(0, 0, 1)));
        vec3 o(.79f, .04f, 0);
        both(P, cone(o + R * (q - o), o + R * (tip - o), .0030f, tooth));
    }
    for (auto& t : toes) {
        vec3 e = glm::normalize((t.b - t.a) * vec3(1, 0, 1));
        both(P, cone(t.b + e * t.r * .4f, t.b + e * t.r * 2.5f - vec3(0, t.r * .55f, 0), t.r * .62f,
                     claw));
    }
    return m;
}

} // namespace make
