// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

float bark(vec3 p)
{
    float a = std::atan2(p.z, p.x);
    return .010f * (std::abs(std::sin(a * 9.f + 3.f * noise(vec3(p.x * 6, p.y * 3, p.z * 6)) +
                                      1.3f * std::sin(p.y * 9.f))) -
                    .5f) +
           .006f * noise(p * vec3(22, 7, 22));
}

Sample trunk_field(vec3 p)
{
    float a = std::atan2(p.z, p.x),
          flare = .085f * std::exp(-p.y / .085f) * (.65f + .55f * std::cos(a * 5.f + 1.2f));
    vec3 q = p - vec3(.035f * std::sin(p.y * 3.2f), 0, .025f * std::sin(p.y * 2.6f + 1.f));
    float r = mix(.125f, .085f, saturate(p.y / .62f)) + flare,
          d = (glm::length(vec2(q.x, q.z)) - r) * .75f;
    float b = bark(p);
    vec3 c = glm::mix(srgb(0x4a3626), srgb(0x8a6a4a), saturate(.5f + b * 45.f));
    c = glm::mix(c, srgb(0x6c7a3c),
                 .45f * smooth_step(.16f, .02f, p.y) * saturate(.5f + noise(p * 12.f)));
    return {d + b * .8f, c};
}

} // namespace

Model tree()
{
    Model m;
    int wood = m.material("bark", vec3(1), .9f), leaf = m.material("leaves", vec3(1), .8f);
    std::vector<Limb> br{
        Limb({{.03f, .50f, .01f, .085f},
              {.06f, .64f, .03f, .066f},
              {.17f, .78f, .07f, .045f},
              {.26f, .90f, .10f, .028f}}),
        Limb({{.02f, .52f, .02f, .075f},
              {-.05f, .66f, .02f, .058f},
              {-.17f, .76f, .06f, .040f},
              {-.28f, .82f, .10f, .024f}}),
        Limb({{.03f, .50f, .01f, .08f},
              {.02f, .70f, -.03f, .056f},
              {.00f, .85f, -.09f, .042f},
              {-.02f, 1.0f, -.10f, .026f}}),
        Limb({{.05f, .60f, .02f, .05f}, {.14f, .68f, -.08f, .034f}, {.22f, .78f, -.20f, .022f}}),
        Limb({{.0f, .62f, .02f, .045f}, {-.02f, .74f, .14f, .032f}, {-.04f, .84f, .24f, .022f}})};
    auto f = [=](vec3 p) {
        Sample s = trunk_field(p);
        s.distance = smax(s.distance, p.y - .56f, .10f);
        for (auto& b : br)
            s = join(s, {b(p) + .004f * noise(p * vec3(30, 14, 30)), srgb(0x6f543a)}, .035f);
        s.distance = smax(s.distance, -p.y, .006f);
        return s;
    };
    Mesh t = surface(f, {-.36f, -.01f, -.32f}, {.36f, 1.06f, .32f}, {.0135f, false, 6});
    wrap_about_y(t, {0, 0});
    m.root().parts.push_back(t.mat(wood));
    std::vector<vec4> blob{
        {.26f, .93f, .10f, .20f},   {-.27f, .88f, .10f, .19f},  {-.02f, 1.06f, -.08f, .21f},
        {.22f, .84f, -.22f, .16f},  {-.05f, .90f, .25f, .16f},  {.12f, 1.06f, .06f, .17f},
        {-.15f, 1.02f, .06f, .16f}, {-.18f, .90f, -.16f, .15f}, {.10f, .93f, .24f, .13f}};
    auto g = [=](vec3 p) {
        float d = 1e9f;
        for (auto& b : blob) d = smin(d, ellipsoid(p, vec3(b), vec3(b.w, b.w * .78f, b.w)), .035f);
        float n = noise(p * 17.f) * .6f + noise(p * 36.f) * .4f;
        d += -.026f * n;
        vec3 c = glm::mix(srgb(0x3f6b2c), srgb(0x8bb34a),
                          saturate(.45f + 1.0f * n + .8f * (p.y - .95f)));
        return Sample{d * .75f, c};
    };
    m.root().parts.push_back(
        surface(g, {-.52f, .66f, -.46f}, {.52f, 1.32f, .46f}, {.0215f, false, 5}).mat(leaf));
    return m;
}

Model trunk()
{
    Model m;
    int wood = m.material("bark", vec3(1), .9f);
    Mesh t = surface(
        [](vec3 p) {
            Sample s = trunk_field(p);
            s.distance = smax(smax(s.distance, p.y - 1.f, .008f), -p.y, .006f);
            if (p.y > .992f) {
                float r = glm::length(vec2(p.x - .035f * std::sin(3.2f), p.z));
                s.color =
                    glm::mix(srgb(0xd9b787), srgb(0xa97c4c),
                             saturate(.5f + .6f * std::sin(r * 330.f + 2.f * noise(p * 20.f))));
            }
            return s;
        },
        {-.3f, -.01f, -.3f}, {.3f, 1.02f, .3f}, {.0125f, false, 6});
    wrap_about_y(t, {0, 0});
    m.root().parts.push_back(t.mat(wood));
    return m;
}

} // namespace make
