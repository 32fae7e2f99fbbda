// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/face.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Sample face(vec3 p0, bool whole)
{ // whole: with hair and open eyes
    vec3 p = mirror_z(p0), skin = srgb(0xe8bb9c), rose = srgb(0xd9977f), lip = srgb(0xc4766a),
         brow = srgb(0x4a3022);
    float d = ellipsoid(p, {-.025f, .715f, 0}, {.325f, .285f, .258f});
    d = smin(d, ellipsoid(p, {.085f, .745f, 0}, {.195f, .185f, .205f}), .06f); // forehead
    d = smin(d, ellipsoid(p, {.075f, .50f, 0}, {.200f, .260f, .188f}), .07f);  // face
    d = smin(d, capsule(p, {-.01f, .42f, .165f}, {.185f, .285f, .055f}, .050f, .045f), .07f); // jaw
    d = smin(d, ellipsoid(p, {.232f, .284f, 0}, {.056f, .050f, .066f}), .055f); // chin
    d = smin(d, ellipsoid(p, {.182f, .530f, .128f}, {.070f, .060f, .070f}), .08f);
    d = smin(d, ellipsoid(p, {.150f, .430f, .105f}, {.090f, .100f, .078f}), .07f); // cheekbone
    d = smin(d, capsule(p, {-.075f, .45f, 0}, {-.105f, -.10f, 0}, .140f, .165f), .07f);
    d = smin(d, ellipsoid(p, {-.10f, -.03f, 0}, {.19f, .10f, .30f}), .10f);
    d = smin(d, ellipsoid(p, {.215f, .395f, 0}, {.078f, .085f, .098f}), .05f); // around the mouth
    d = smax(d, -ellipsoid(p, {.318f, .615f, .108f}, {.070f, .044f, .074f}), .050f); // sockets
    d = smin(d, capsule(p, {.262f, .672f, .045f}, {.222f, .680f, .165f}, .024f, .022f),
             .045f); // brows
    float nose = capsule(p, {.258f, .650f, 0}, {.324f, .502f, 0}, .019f, .033f);
    nose = smin(nose, ellipsoid(p, {.305f, .482f, .037f}, {.036f, .025f, .025f}), .022f);
    nose = smin(nose, ellipsoid(p, {.340f, .494f, 0}, {.030f, .028f, .031f}), .025f);
    d = smin(d, nose, .045f);
    d = smax(d, -ellipsoid(p, {.325f, .460f, .021f}, {.018f, .011f, .010f}), .010f);
    vec3 c = glm::mix(skin, rose,
                      .55f * smooth_step(.10f, .02f, glm::length(p - vec3(.22f, .50f, .13f))) +
                          .5f * smooth_step(.05f, .01f, glm::length(p - vec3(.362f, .494f, 0))));
    // lids: a ball over the eye, opened along an almond
    vec3 E(.232f, .612f, .108f);
    d = smin(d, glm::length(p - E) - .0575f, .014f);
    float tilt = .10f * (p.z - E.z),
          open = ellipsoid(p, {.300f, .607f + tilt, .112f}, {.070f, .0185f, .0440f});
    if (!whole)
        open = std::max(
            std::abs(p.y - .600f - tilt + .35f * (.045f - std::abs(p.z - .112f)) * .5f) - .0018f,
            std::abs(p.z - .112f) - .046f);
    d = smax(d, -smax(open, -(glm::length(p - E) - (whole ? .049f : .0535f)), .004f), .006f);
    d = smax(
        d,
        -(std::max(path_distance({p.z, p.y - tilt},
                                 {{.060f, .634f}, {.090f, .647f}, {.125f, .648f}, {.160f, .630f}}) -
                       .0035f,
                   -(d + .008f))),
        .010f); // lid fold
    c = glm::mix(c, brow, .85f * smooth_step(.0045f, -.002f, open) * smooth_step(.20f, .24f, p.x));
    // lips
    auto arc = [&](float y0, float y1, float x0, float x1, float r0, float r1) {
        float best = 1e9f;
        vec3 q[5];
        for (int i = 0; i < 5; i++) {
            float t = i / 4.f;
            q[i] = {
                mix(x0, x1, t * t),
                mix(y0, y1, t * t) +
                    (y0 > .385f ? .010f * std::sin(pi * std::min(1.f, t * 1.9f)) * (t < .53f) : 0),
                .086f * t};
        }
        for (int i = 0; i < 4; i++)
            best = std::min(
                best, capsule(p, q[i], q[i + 1], mix(r0, r1, i / 4.f), mix(r0, r1, (i + 1) / 4.f)));
        return best;
    };
    float up = arc(.400f, .3885f, .300f, .248f, .0165f, .006f),
          lo = arc(.366f, .3855f, .296f, .246f, .0195f, .006f);
    float lips = std::min(up, lo);
    d = smin(d, up, .014f);
    d = smin(d, lo, .014f);
    c = glm::mix(c, lip, smooth_step(.007f, -.001f, lips));
    float slit = arc(.3835f, .3870f, .322f, .262f, .0050f, .0035f);
    d = smax(d, -slit, .008f);
    c = glm::mix(c, srgb(0x6e322e), smooth_step(.006f, .0f, slit));
    d = smax(d, -ellipsoid(p, {.318f, .332f, 0}, {.022f, .014f, .05f}), .035f);
    d = smax(d, -capsule(p, {.335f, .450f, 0}, {.325f, .418f, 0}, .004f, .006f), .012f);
    float bl =
        path_distance({p.z, p.y}, {{.045f, .676f}, {.085f, .698f}, {.125f, .700f}, {.172f, .676f}});
    float bw = mix(.013f, .006f, saturate((p.z - .05f) / .12f));
    if (p.x > .15f) {
        c = glm::mix(c, brow, .9f * smooth_step(bw + .005f, bw - .003f, bl));
        d -= .0045f * smooth_step(bw + .004f, bw - .006f, bl);
    }
    // ears
    vec3 q = turned(p, {-.035f, .565f, .245f}, 22, {0, 1, 0});
    q = turned(q, {-.035f, .565f, .245f}, 10, {0, 0, 1});
    float ear = ellipsoid(q, {-.040f, .575f, .250f}, {.058f, .085f, .024f});
    ear = smin(ear, ellipsoid(q, {-.025f, .500f, .245f}, {.026f, .034f, .018f}), .02f);
    ear = smax(ear, -ellipsoid(q, {-.030f, .582f, .277f}, {.036f, .056f, .017f}), .012f);
    ear = smin(ear, ellipsoid(q, {-.048f, .565f, .256f}, {.018f, .045f, .012f}), .012f);
    d = smin(d, ear, .018f);
    Sample s{smax(d, -p.y, .024f), c};
    if (whole) {
        float st = .0048f * std::sin(22.f * std::atan2(p0.y - .62f, p0.x + .10f) + 10.f * p0.z +
                                     3.f * noise(p0 * 5.f)),
              h = ellipsoid(p, {-.035f, .730f, 0}, {.345f, .302f, .280f}) + st;
        h = smin(h, ellipsoid(p0, {.150f, .960f, .03f}, {.150f, .065f, .17f}) + st, .06f);
        float line = polygon({p.x, p.y}, {{.6f, .855f},
                                          {.20f, .860f},
                                          {.135f, .800f},
                                          {.085f, .700f},
                                          {.060f, .560f},
                                          {.010f, .560f},
                                          {-.015f, .660f},
                                          {-.085f, .660f},
                                          {-.120f, .480f},
                                          {-.20f, .405f},
                                          {-.6f, .36f},
                                          {-.6f, -.2f},
                                          {.6f, -.2f}});
        s = join(s, {smax(h, -line, .030f), srgb(0x5a3a26) * (1.f + 26.f * -st)}, .006f);
    }
    return s;
}

} // namespace make
