// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model snake()
{
    Model m;
    int skin = m.material("skin", vec3(1), .45f), eye = m.material("eye", srgb(0x1a1410), .1f),
        iris = m.material("iris", srgb(0xe0a92a), .2f),
        red = m.material("tongue", srgb(0xc22f3a), .5f);
    Loft body({{0, .004f, .0025f, .003f, .003f, 2},
               {.06f, .008f, .0075f, .008f, .0075f, 2},
               {.2f, .0185f, .0185f, .0195f, .018f, 2.1f},
               {.4f, .0275f, .0285f, .0285f, .027f, 2.2f},
               {.62f, .030f, .032f, .031f, .0295f, 2.2f},
               {.78f, .026f, .0265f, .0265f, .0255f, 2.2f},
               {.865f, .0215f, .0195f, .020f, .020f, 2.1f},
               {.89f, .0225f, .022f, .021f, .020f, 2.1f},
               {.918f, .0245f, .0345f, .0225f, .019f, 2.2f},
               {.945f, .025f, .0365f, .021f, .017f, 2.25f},
               {.972f, .0245f, .0275f, .0165f, .0135f, 2.3f},
               {.990f, .024f, .0185f, .0115f, .0105f, 2.3f}});
    const float per = .062f;
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        float yc = p.x < .2f ? .012f : .026f,
              th = std::atan2(p.z, p.y - yc) / 3.14159f; // 0 on the back, 1 under the belly
        vec3 sand = srgb(0xb9a15a), olive = srgb(0x4c5b2b), dark = srgb(0x20291a),
             cream = srgb(0xeee3b8);
        float u = p.x / per, cx = std::abs(u - std::floor(u) - .5f) * 2, dia = cx * .9f + th / .42f,
              side = std::abs(cx - 1) + std::abs(th - .60f) / .13f;
        vec3 k = glm::mix(sand, dark, smooth_step(1.08f, .96f, dia));
        k = glm::mix(k, olive, smooth_step(.82f, .70f, dia));
        k = glm::mix(k, dark, .9f * smooth_step(.75f, .6f, side));
        if (p.x > .885f) {
            float e = smooth_step(.885f, .90f, p.x);
            vec3 hd = glm::mix(olive, sand, smooth_step(.22f, .40f, th));
            float band = path_distance(
                {p.x, p.y}, {{.88f, .026f}, {.925f, .031f}, {.957f, .032f}, {.988f, .027f}});
            hd = glm::mix(hd, dark, smooth_step(.0055f, .003f, band) * smooth_step(.15f, .25f, th));
            k = glm::mix(k, hd, e);
        }
        k = glm::mix(k, cream, smooth_step(.70f, .80f, th));
        Sample s{body(p), k};
        add(s, tilted(p, {.950f, .0395f, .0195f}, {.017f, .0055f, .008f}, -12, {0, 0, 1}),
            .008f);                                              // brow
        cut(s, ball(p, {.959f, .0365f, .0285f}, .0058f), .004f); // socket
        float mouth = path_distance(
            {p.x, p.y},
            {{.925f, .0195f}, {.945f, .0175f}, {.968f, .0195f}, {.99f, .0215f}, {1.02f, .0225f}});
        cut(s, groove(s.distance, mouth, .0012f, .0035f), srgb(0x2c1d16), .0022f);
        cut(s, ball(p, {.9955f, .0300f, .0085f}, .0022f), srgb(0x18140f), .002f); // nostril
        return s;
    };
    Mesh b = surface(f, {-.01f, 0, -.05f}, {1.02f, .07f, .05f}, {.0042f});
    wrap_about_x(b, .022f);
    auto& P = m.root().parts;
    P.push_back(b.mat(skin));
    both(P, ball_mesh(.0072f, 6).move({.9585f, .0362f, .0262f}).mat(iris));
    both(P, ball_mesh(.0052f, 4)
                .scale({.42f, 1, .6f})
                .turn(12, {0, 1, 0})
                .move({.9600f, .0365f, .0312f})
                .mat(eye));
    P.push_back(tube(curve({{.985f, .0215f, 0, .0022f},
                            {1.012f, .0205f, 0, .0020f},
                            {1.024f, .0225f, .0010f, .0017f},
                            {1.042f, .026f, .0075f, .0009f}},
                           4),
                     8)
                    .mat(red));
    P.push_back(tube(curve({{1.012f, .0205f, 0, .0018f},
                            {1.024f, .0225f, -.0010f, .0017f},
                            {1.042f, .026f, -.0075f, .0009f}},
                           4),
                     8)
                    .mat(red));
    return m;
}

} // namespace make
