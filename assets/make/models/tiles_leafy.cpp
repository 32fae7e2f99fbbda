// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

std::vector<float> even_steps(int n)
{
    std::vector<float> out;
    for (int i = 0; i <= n; i++) out.push_back(float(i) / n);
    return out;
}

// A blade along +x whose veins or barbs run from the middle to the rim and forward: u along the
// middle, v across it from -1 to 1.
struct Blade {
    float stem;                             // x where it begins; it ends at x = 1
    float forward;                          // how far the rim is ahead of the middle
    Curve half_width, height;               // along it
    vec2 place(vec2 q, float widened) const // x and y
    {
        const float v = std::abs(q.y), rim = q.x + forward * (1 - q.x) * smooth_step(0, .3f, q.x),
                    along = mix(q.x, rim, std::pow(v, 1.25f));
        return {mix(stem, 1, along), .5f + q.y * half_width(rim) * widened};
    }
};

// How far u is from one vein to the next, 0 on a vein.
float between(float u, int veins)
{
    return u * veins - std::floor(u * veins + 1e-4f);
}

} // namespace

// A leaf with its stem at the origin; the tip points along +x.
Model tile_leaf()
{
    Model m;
    const int a = m.material("leaf", vec3(1), .45f);
    constexpr int veins = 8;
    const Blade blade{.15f, .20f,
                      Curve({{0, .012f},
                             {.06f, .12f},
                             {.2f, .255f},
                             {.38f, .325f},
                             {.6f, .265f},
                             {.8f, .145f},
                             {.93f, .055f},
                             {1, .004f}}),
                      Curve({{0, .075f}, {.2f, .15f}, {.5f, .26f}, {.78f, .275f}, {1, .15f}})};
    const auto top = [=](vec2 q) {
        const float v = std::abs(q.y), f = between(q.x, veins);
        const vec2 p = blade.place(q, mix(1.05f, .97f, std::min(1.f, 3 * f))); // with teeth
        const float quilt = .020f * std::sin(pi * f) * std::sin(pi * std::min(1.f, v * 1.05f)),
                    fold = .12f * std::pow(v, 1.5f) * std::sin(pi * std::min(.9f, q.x + .1f)),
                    wave = .022f * v * v * std::sin(17 * p.x + (q.y > 0 ? 0.f : 1.9f));
        return vec3(p, blade.height(q.x) + fold + quilt + wave - .014f * (v < .01f ? 1.f : 0.f));
    };
    std::vector<float> rows; // close to the veins, so that these are narrow
    for (int i = 0; i < veins; i++)
        for (const float f : {0.f, .13f, .5f, .87f}) rows.push_back((i + f) / veins);
    rows.push_back(1);
    Plate leaf{
        rows,
        {-1, -.97f, -.78f, -.56f, -.34f, -.15f, -.045f, 0, .045f, .15f, .34f, .56f, .78f, .97f, 1},
        top,
        [=](vec2 q) { return top(q) - vec3(0, 0, .012f); },
        [=](vec2 q, bool above) {
            const float v = std::abs(q.y), f = between(q.x, veins),
                        rib = std::max(v < .02f ? 1.f : 0.f,
                                       f < .05f ? smooth_step(1.1f, .3f, v) * .85f : 0.f);
            vec3 c = glm::mix(srgb(0x24602a), srgb(0x6da83c),
                              saturate(.15f + .55f * v + .3f * std::sin(pi * f)));
            c = glm::mix(c, srgb(0xc2803a), .55f * smooth_step(.9f, 1, v * .8f + q.x * .3f));
            c = glm::mix(c, srgb(0xcfe08e), rib);
            return above ? c : glm::mix(c, srgb(0xa9bd86), .55f);
        }};
    m.root().parts.push_back(plate(leaf).mat(a));
    Mesh stem = tube(curve({{.02f, .5f, .020f, .019f},
                            {.08f, .5f, .032f, .015f},
                            {.16f, .5f, .072f, .013f},
                            {.26f, .5f, .108f, .009f}},
                           3),
                     8, false, 2);
    stem.paint([](vec3 p) {
        return glm::mix(srgb(0x6e4a2c), srgb(0xaebf6a), smooth_step(.0f, .2f, p.x));
    });
    m.root().parts.push_back(stem.mat(a));
    return m;
}

// A feather of a hawk with its quill at the origin; the tip points along +x.
Model tile_feather()
{
    Model m;
    const int a = m.material("vane", vec3(1), .7f), b = m.material("quill", vec3(1), .4f);
    constexpr int barbs = 58;
    const Blade blade{.15f, .20f,
                      Curve({{0, .03f},
                             {.06f, .10f},
                             {.2f, .185f},
                             {.45f, .235f},
                             {.7f, .245f},
                             {.87f, .20f},
                             {.96f, .11f},
                             {1, .012f}}),
                      Curve({{0, .035f}, {.25f, .075f}, {.6f, .165f}, {.85f, .225f}, {1, .235f}})};
    const auto torn = [](vec2 q) { // where barbs have come apart
        float w = q.y > 0 ? 1.08f : .86f;
        for (const vec2 gap : {vec2(.34f, 1), vec2(.60f, -1), vec2(.74f, 1), vec2(.20f, -1)})
            if (gap.y * q.y > 0) w *= 1 - .42f * smooth_step(.026f, .004f, std::abs(q.x - gap.x));
        return w;
    };
    const auto top = [=](vec2 q) {
        const float v = std::abs(q.y), odd = int(q.x * barbs + .5f) % 2 ? 1.f : -1.f;
        const float z = blade.height(q.x);
        return vec3(blade.place(q, torn(q)),
                    z * (1 - .42f * v * v) +
                        .005f * odd * smooth_step(0, .3f, v) * smooth_step(1, .6f, v) + .006f);
    };
    Plate vane{even_steps(barbs),
               {-1, -.72f, -.42f, -.16f, -.03f, .03f, .16f, .42f, .72f, 1},
               top,
               [=](vec2 q) { return top(q) - vec3(0, 0, .010f); },
               [=](vec2 q, bool above) {
                   const float along = blade.place(q, 1).x + .012f * noise({q.x * 60, q.y * 3, 1}),
                               odd = int(q.x * barbs + .5f) % 2 ? 1.05f : .93f;
                   vec3 c = glm::mix(srgb(0xd8c6a2), srgb(0xa9825a), smooth_step(.2f, .9f, along));
                   const float bar = std::sin(2 * pi * (along * 5.2f - .12f));
                   c = glm::mix(c, srgb(0x4a2e1b),
                                smooth_step(.1f, .5f, bar) * smooth_step(.2f, .34f, along));
                   c = glm::mix(c, srgb(0x33200f), smooth_step(.86f, .88f, along));
                   c = glm::mix(c, srgb(0xf3ead8), smooth_step(.935f, .95f, along));
                   c = glm::mix(srgb(0xf1eadb), c, smooth_step(.14f, .32f, along));
                   return glm::min(c * odd * (above ? 1.f : .85f), vec3(1));
               }};
    m.root().parts.push_back(plate(vane).mat(a));
    std::vector<vec4> quill{{.012f, .5f, .022f, .012f}};
    for (int i = 0; i <= 8; i++) {
        const float u = i / 8.f * .97f;
        quill.push_back({mix(.15f, 1, u), .5f, blade.height(u) + .010f, mix(.020f, .004f, u)});
    }
    Mesh shaft = tube(curve(quill, 2), 7, false, 1);
    shaft.paint([](vec3 p) {
        return glm::mix(srgb(0xeadfc6), srgb(0x7d5a3a), smooth_step(.15f, .8f, p.x));
    });
    m.root().parts.push_back(shaft.mat(b));
    for (int i = 0; i < 8; i++) { // down
        const float side = i % 2 ? 1.f : -1.f, x = .10f + .018f * i,
                    w = .10f + .035f * noise({i * 1.7f, 0, 0}), z = .034f + .004f * i;
        Mesh wisp = tube(
            curve({{x, .5f + side * .01f, z, .008f},
                   {x + .02f, .5f + side * w * .6f, z + .03f, .007f},
                   {x + .07f + .02f * noise({0, i * 2.1f, 0}), .5f + side * w, z + .015f, .004f}},
                  3),
            5, false, 1);
        wisp.paint([](vec3) { return srgb(0xf1eadb); });
        m.root().parts.push_back(wisp.mat(a));
    }
    return m;
}

// A tuft of blades that lean outward, most of them toward +x.
Model tile_grass()
{
    Model m;
    const int a = m.material("grass", vec3(1), .55f);
    for (int i = 0; i < 11; i++) {
        const float g = 2.39996f * i, from = .16f * std::sqrt(i / 11.f),
                    tall = .72f + .26f * noise({i * 2.7f, 0, 0}),
                    out = .20f + .12f * noise({0, i * 1.9f, 0});
        const vec2 way = vec2(std::cos(g) + .25f, std::sin(g));
        const vec3 foot(vec2(.45f, .5f) + from * way, .004f);
        std::vector<vec4> keys;
        for (const float t : {0.f, .3f, .6f, .85f, 1.f})
            keys.push_back(vec4(foot + vec3(out * t * t * way, tall * (t - .18f * t * t)),
                                mix(.030f, .004f, t * t)));
        Mesh blade = tube(curve(keys, 2), 5, false, 1);
        const vec3 across = glm::normalize(vec3(-way.y, way.x, 0));
        blade.warp([=](vec3 p) { // flat: thin along its way
            const float t = saturate(p.z / tall),
                        along = glm::dot(vec2(p - foot), glm::normalize(way)),
                        middle = out * t * t * glm::length(way);
            p -= .55f * (along - middle) * glm::cross(across, vec3(0, 0, 1));
            return vec3(vec2(p), std::max(p.z, 0.f));
        });
        blade.paint([=](vec3 p) {
            const vec3 tip = i % 3 == 0 ? srgb(0xb9c765) : srgb(0x86b54a);
            return glm::mix(srgb(0x2f5a22), tip, saturate(p.z * 1.25f));
        });
        m.root().parts.push_back(blade.mat(a));
    }
    return m;
}

} // namespace make
