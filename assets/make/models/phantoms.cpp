// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/phantoms.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

struct Bone {
    vec3 a, b;
    float r;
};

std::vector<Bone> hand_bones()
{
    std::vector<Bone> o;
    vec3 knuckle[5] = {{-.150f, .335f, .03f},
                       {-.098f, .475f, .0f},
                       {-.030f, .490f, -.006f},
                       {.035f, .475f, -.004f},
                       {.092f, .440f, .004f}};
    vec3 wrist[5] = {{-.075f, .245f, .02f},
                     {-.048f, .270f, 0},
                     {-.016f, .275f, -.004f},
                     {.016f, .272f, -.004f},
                     {.045f, .262f, 0}};
    float ang[5] = {-40, -9, -1, 6, 15}, len[5][3] = {{.098f, .072f, 0},
                                                      {.118f, .072f, .050f},
                                                      {.130f, .082f, .054f},
                                                      {.120f, .076f, .052f},
                                                      {.094f, .056f, .046f}};
    for (int f = 0; f < 5; f++) {
        o.push_back({wrist[f], knuckle[f], .0165f});
        vec3 p = knuckle[f];
        float a = glm::radians(ang[f]), z = 0;
        for (int k = 0; k < 3; k++)
            if (len[f][k] > 0) {
                vec3 d(std::sin(a), std::cos(a), z);
                vec3 s = p + d * .010f, e = p + d * len[f][k];
                o.push_back({s, e, .0145f - .0025f * k});
                p = e;
                a *= .92f;
                z -= .05f;
            }
    }
    return o;
}

float bone(vec3 p, const Bone& b, float waist = .66f)
{
    vec3 d = b.b - b.a;
    float t = saturate(glm::dot(p - b.a, d) / glm::dot(d, d)),
          r = b.r * mix(waist, 1.f, std::pow(std::abs(2 * t - 1), 2.2f));
    return glm::length(p - b.a - d * t) - r;
}

float hand_bone(vec3 p)
{
    static const auto B = hand_bones();
    float d = 1e9f;
    for (auto& b : B) d = std::min(d, bone(p, b));
    static const vec4 carpal[8] = {{-.058f, .225f, .012f, .021f},  {-.034f, .238f, -.002f, .019f},
                                   {-.004f, .243f, -.004f, .022f}, {.028f, .236f, 0, .021f},
                                   {-.042f, .193f, .006f, .022f},  {-.008f, .198f, 0, .022f},
                                   {.024f, .198f, 0, .020f},       {.044f, .212f, .012f, .014f}};
    for (auto& c : carpal)
        d = std::min(d, ellipsoid(p, vec3(c), vec3(c.w, c.w * .92f, c.w * .85f)));
    d = std::min(d, bone(p, {{-.030f, -.02f, 0}, {-.030f, .158f, 0}, .031f}, .62f));
    return std::min(d, bone(p, {{.034f, -.02f, 0}, {.032f, .165f, 0}, .023f}, .66f));
}

float jaw_bone(vec3 p0)
{
    vec3 p(p0.x, p0.y, std::abs(p0.z));
    static const Limb arch({{.405f, .085f, .0f, .040f},
                            {.388f, .085f, .070f, .038f},
                            {.31f, .088f, .140f, .034f},
                            {.18f, .094f, .195f, .034f},
                            {.06f, .105f, .235f, .034f}});
    static const auto ramus = smooth_loop({{.10f, .045f},
                                           {.150f, .13f},
                                           {.125f, .24f},
                                           {.118f, .33f},
                                           {.098f, .385f},
                                           {.070f, .345f},
                                           {.035f, .315f},
                                           {.005f, .360f},
                                           {-.015f, .405f},
                                           {-.050f, .400f},
                                           {-.040f, .335f},
                                           {-.040f, .22f},
                                           {-.025f, .10f},
                                           {.03f, .045f}});
    vec3 q(p.x, .085f + (p.y - .092f) * .60f, p.z);
    float d = arch(q) * .95f;
    d = smin(d, ellipsoid(p, {.412f, .045f, 0}, {.045f, .034f, .055f}), .05f);
    float lean = .238f + .10f * (p.y - .1f);
    d = smin(d, prism(polygon({p.x, p.y}, ramus), p.z - lean, .0145f, .013f), .045f);
    return smin(d, ellipsoid(p, {-.032f, .405f, .268f}, {.026f, .020f, .044f}), .025f);
}

float jaw_teeth(vec3 p0)
{
    vec3 p(p0.x, p0.y, std::abs(p0.z));
    static const float w[7] = {.0125f, .0135f, .0150f, .0165f, .0170f, .0225f, .0225f};
    float d = 1e9f, s = .0135f;
    auto at = [](float t) {
        vec2 a(.415f, 0), b(.395f, .075f), c(.31f, .140f), e(.17f, .199f);
        float l1 = glm::distance(a, b), l2 = glm::distance(b, c);
        return t < l1        ? glm::mix(a, b, t / l1)
               : t < l1 + l2 ? glm::mix(b, c, (t - l1) / l2)
                             : glm::mix(c, e, (t - l1 - l2) / glm::distance(c, e));
    };
    for (int i = 0; i < 7; i++) {
        vec2 o = at(s), t = glm::normalize(at(s + .01f) - at(s - .01f));
        vec3 q(glm::dot(vec2(p.x, p.z) - o, t), p.y - .170f,
               glm::dot(vec2(p.x, p.z) - o, vec2(-t.y, t.x)));
        d = std::min(d,
                     box(q, vec3(0), {w[i], i < 3 ? .034f : .028f, i < 3 ? .011f : .019f}, .009f));
        s += w[i] + (i < 6 ? w[i + 1] : 0) + .0030f;
    }
    return d;
}

float crystal_density(vec3 p)
{ // silicon: eight atoms a cell, charge piled up on the bonds
    static const vec3 base[8] = {{0, 0, 0},          {0, .5f, .5f},      {.5f, 0, .5f},
                                 {.5f, .5f, 0},      {.25f, .25f, .25f}, {.25f, .75f, .75f},
                                 {.75f, .25f, .75f}, {.75f, .75f, .25f}},
                      dir[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    float v = 0;
    p *= 2.f;
    for (int i = 0; i < 8; i++) {
        vec3 d = p - base[i];
        d -= glm::round(d);
        float r = glm::dot(d, d);
        v += .85f * std::exp(-r / .0075f) + .10f * std::exp(-r / .03f);
        if (i >= 4)
            for (auto& e : dir) {
                vec3 b = p - (base[i] - e * .125f);
                b -= glm::round(b);
                v += .42f * std::exp(-glm::dot(b, b) / .0070f);
            }
    }
    return v;
}

} // namespace make
