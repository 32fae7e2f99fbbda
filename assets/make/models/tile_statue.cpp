// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

// Seated in meditation, facing -v.
Model tile_statue()
{
    Model m;
    int a = m.material("bronze", vec3(1), .35f, .2f);
    vec3 gold = srgb(0xc59a4a), robe = srgb(0xa8762f), dark = srgb(0x6d4a20);
    auto f = [=](vec3 q) { // work in: side s, up t, front r
        float s = std::abs(q.x - .5f), t = q.z, r = .5f - q.y;
        vec3 p(s, t, r);
        Sample o{ellipsoid(p, {0, .42f, -.03f}, {.150f, .19f, .110f}), robe};
        add(o, ellipsoid(p, {0, .545f, -.03f}, {.185f, .105f, .105f}), robe, .06f);
        add(o, ellipsoid(p, {0, .30f, .0f}, {.165f, .10f, .13f}), robe, .06f); // belly, hips
        add(o, capsule(p, {.10f, .20f, -.03f}, {.315f, .180f, .130f}, .090f, .066f), robe, .05f);
        add(o, capsule(p, {.315f, .180f, .130f}, {.03f, .165f, .235f}, .062f, .045f), robe,
            .04f); // crossed legs
        add(o, capsule(p, {-.04f, .205f, .235f}, {.06f, .212f, .225f}, .030f, .024f), gold,
            .015f); // feet
        add(o, capsule(p, {.185f, .560f, -.03f}, {.255f, .385f, .015f}, .060f, .050f), robe, .045f);
        add(o, capsule(p, {.255f, .385f, .015f}, {.075f, .275f, .175f}, .048f, .032f), robe,
            .035f);                                                                      // arms
        add(o, ellipsoid(p, {.035f, .268f, .190f}, {.062f, .022f, .036f}), gold, .015f); // hands
        add(o, capsule(p, {0, .60f, -.03f}, {0, .70f, -.02f}, .060f, .055f), gold, .035f);
        Sample h{ellipsoid(p, {0, .775f, -.015f}, {.100f, .120f, .108f}), gold};
        h.distance = smin(h.distance, ellipsoid(p, {0, .715f, .020f}, {.072f, .062f, .072f}), .03f);
        o = join(o, h, .02f);
        Sample hr{smax(ellipsoid(p, {0, .790f, -.030f}, {.111f, .125f, .115f}),
                       -polygon({r, t}, {{.2f, .845f},
                                         {.065f, .845f},
                                         {.020f, .80f},
                                         {.0f, .70f},
                                         {-.06f, .66f},
                                         {.2f, .5f}}),
                       .015f),
                  dark};
        add(hr, ball(p, {0, .915f, -.035f}, .050f), dark, .03f);
        hr.distance +=
            .0045f * std::sin(q.x * 115.f) * std::sin(q.z * 115.f) * std::cos(q.y * 80.f);
        o = join(o, hr, .008f);
        add(o, ellipsoid(p, {.103f, .735f, -.02f}, {.014f, .065f, .026f}), gold, .012f); // ears
        add(o, capsule(p, {0, .785f, .090f}, {0, .738f, .112f}, .009f, .015f), gold, .014f);
        cut(o, capsule(p, {.018f, .772f, .110f}, {.062f, .770f, .090f}, .012f, .010f), .016f);
        add(o, capsule(p, {.020f, .764f, .088f}, {.055f, .763f, .075f}, .013f, .011f), gold, .008f);
        cut(o, capsule(p, {.020f, .760f, .103f}, {.056f, .762f, .089f}, .0045f, .004f), dark,
            .004f);
        add(o, capsule(p, {0, .706f, .094f}, {.026f, .711f, .084f}, .010f, .006f), gold, .008f);
        cut(o, capsule(p, {0, .704f, .106f}, {.030f, .711f, .090f}, .004f, .003f), dark, .004f);
        float fold = std::sin(48.f * (.8f * t + .9f * (q.x - .5f)));
        if (t > .30f && t < .62f && s < .2f)
            o.distance += .0045f * fold * smooth_step(.30f, .34f, t) * smooth_step(.62f, .56f, t) *
                          smooth_step(.20f, .14f, s);
        float edge =
            path_distance({q.x, t}, {{.66f, .60f}, {.56f, .50f}, {.46f, .38f}, {.38f, .33f}});
        if (r > 0 && t > .3f && t < .62f) {
            o.distance -= .007f * smooth_step(.016f, .006f, edge);
        }
        if (t > .38f && t < .64f && r > -.02f && q.x < .36f + .40f * (t - .30f) && s < .17f)
            o.color = glm::mix(o.color, gold, smooth_step(.012f, .022f, edge));
        // lotus seat: two rows of petals
        float ang = std::atan2(r - .02f, q.x - .5f),
              rad = glm::length(vec2(q.x - .5f, (r - .02f) * 1.12f)),
              petal = std::abs(std::sin(ang * 9.f)), petal2 = std::abs(std::cos(ang * 9.f));
        float seat = smax(rad - (.365f + .028f * std::pow(petal, .6f) -
                                 1.2f * (t - .085f) * (t - .085f)),
                          std::abs(t - .088f) - .038f, .022f) *
                     .8f,
              foot = smax(rad - (.385f + .030f * std::pow(petal2, .6f) -
                                 1.2f * (t - .03f) * (t - .03f)),
                          std::abs(t - .030f) - .032f, .020f) *
                     .8f;
        o = join(o,
                 {std::min(seat, foot),
                  glm::mix(dark, gold, .35f + .5f * (seat < foot ? petal : petal2))},
                 .010f);
        o.distance = smax(o.distance, -t, .004f);
        return o;
    };
    m.root().parts.push_back(
        surface(f, {.04f, .04f, -.01f}, {.96f, .96f, 1.0f}, {.0128f, false, 8}).mat(a));
    return m;
}

} // namespace make
