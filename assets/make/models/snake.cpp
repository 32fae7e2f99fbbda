// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

// How many rows of scales lie between the tail and x: they shrink with the body.
float scale_rows(float x)
{
    constexpr float longest = .0105f, taper = .45f;
    return std::log(1 + std::min(x, taper) * 3.2f) / 3.2f / longest * 1.35f +
           std::max(0.f, x - taper) / longest;
}

// 1 in the middle of a scale, 0 on the skin between; t is the angle from the back, -1..1.
float scales(float x, float t)
{
    constexpr float around = 26; // scales about the body
    const vec2 q(scale_rows(x), t * around / 2);
    const vec2 a = q - glm::round(q), b = q + .5f - glm::round(q + .5f);
    const float edge =
        std::min(std::abs(a.x) * 1.05f + std::abs(a.y), std::abs(b.x) * 1.05f + std::abs(b.y));
    return smooth_step(.52f, .30f, edge);
}

// Dark saddles with pale rims on sand, a row of spots on the flank, cream below.
vec3 body_color(float x, float t)
{
    constexpr float period = .062f;
    const vec3 sand = srgb(0xc9ab62), rust = srgb(0x8c5a2b), dark = srgb(0x2b2417),
               pale = srgb(0xeedfae), cream = srgb(0xf0e6c2);
    const float side = std::abs(t), u = x / period, c = std::abs(u - std::floor(u) - .5f) * 2;
    const float saddle = c * .9f + side / .40f;
    const float spot = std::abs(c - 1) + std::abs(side - .58f) / .12f;
    vec3 k = glm::mix(sand, pale, smooth_step(1.22f, 1.10f, saddle));
    k = glm::mix(k, dark, smooth_step(1.08f, .98f, saddle));
    k = glm::mix(k, rust, smooth_step(.82f, .66f, saddle));
    k = glm::mix(k, dark, .9f * smooth_step(.75f, .6f, spot));
    k = glm::mix(k, cream, smooth_step(.70f, .80f, side));
    return k * mix(.62f, 1.08f, mix(scales(x, t), 1.f, smooth_step(.74f, .84f, side) * .6f));
}

} // namespace

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
    // The axis round which the pattern and the texture coordinates go.
    const Curve spine({{0, .004f}, {.06f, .008f}, {.2f, .0185f}, {.4f, .026f}, {1, .026f}});
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0);

        const float t = std::atan2(p.z, p.y - spine(p.x)) / pi; // 0 on the back, 1 under the belly
        vec3 k = body_color(p.x, t);
        if (p.x > .885f) {
            const vec3 sand = srgb(0xc9ab62), brown = srgb(0x5f4423), dark = srgb(0x2b2417);
            const float band = path_distance(
                {p.x, p.y}, {{.88f, .026f}, {.925f, .031f}, {.957f, .032f}, {.988f, .027f}});
            vec3 crown = glm::mix(brown, sand, smooth_step(.22f, .40f, t));
            crown = glm::mix(crown, dark,
                             smooth_step(.0055f, .003f, band) * smooth_step(.15f, .25f, t));
            crown = glm::mix(crown, srgb(0xf0e6c2), smooth_step(.70f, .80f, t));
            crown *= mix(.86f, 1.04f, scales(p.x, t));
            k = glm::mix(k, crown, smooth_step(.885f, .90f, p.x));
        }
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
    Mesh b = surface(f, {-.01f, 0, -.05f}, {1.02f, .07f, .05f}, {.0040f});
    wrap_about_x(b, spine);
    m.materials[std::size_t(skin)].texture =
        bake(b, {384, 2048}, [&](vec3 p) { return f(p).color; });
    b.colors.clear();
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
