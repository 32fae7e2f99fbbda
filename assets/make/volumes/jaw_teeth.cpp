// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/loft.h"
#include "assets/make/volumes/jaw_parts.h"

#include <memory>

namespace make {
namespace {

struct Cusp {
    float u, v, drop; // where, in halves of the crown, and how far below the highest
};

// A lower tooth: sizes in mm after the means of Wheeler's Dental Anatomy.
struct Tooth {
    float width, depth, height, root; // along the arch, across it, of the crown, of the root
    Curve wide, deep;                 // share of the half sizes over the height, 0 neck, 1 top
    std::vector<Cusp> cusps;
    float steep;  // of the cusps
    float square; // 0 oval, 1 boxy
    bool two_roots;
    float lean_deg; // outward at the top
};

Tooth incisor(float width, float depth, float height, float root)
{
    return {width,
            depth,
            height,
            root,
            Curve({{-.2f, .5f}, {0, .54f}, {.3f, .7f}, {.7f, .94f}, {.9f, 1}, {1, .97f}}),
            Curve({{-.2f, .92f}, {0, .95f}, {.18f, 1}, {.5f, .72f}, {.8f, .42f}, {1, .27f}}),
            {{-.7f, 0, 0}, {0, 0, .05f}, {.7f, 0, .1f}},
            .3f,
            .75f,
            false,
            9};
}

Tooth canine()
{
    return {6.8f,
            7.7f,
            10.4f,
            16,
            Curve({{-.2f, .56f}, {0, .6f}, {.3f, .8f}, {.62f, 1}, {.85f, .86f}, {1, .7f}}),
            Curve({{-.2f, .9f}, {0, .95f}, {.2f, 1}, {.55f, .76f}, {.85f, .5f}, {1, .34f}}),
            {{0, .1f, 0}},
            .72f,
            .3f,
            false,
            5};
}

Tooth premolar(float lingual_drop, float depth)
{
    return {7,
            depth,
            8.4f,
            14.5f,
            Curve({{-.2f, .58f}, {0, .62f}, {.45f, .92f}, {.7f, 1}, {1, .8f}}),
            Curve({{-.2f, .8f}, {0, .84f}, {.35f, 1}, {.7f, .9f}, {1, .66f}}),
            {{0, .42f, 0}, {0, -.5f, lingual_drop}},
            .75f,
            .35f,
            false,
            -2};
}

Tooth molar(float width, float depth, float height, float root, bool five)
{
    std::vector<Cusp> cusps{{-.55f, .48f, .1f}, {.3f, .5f, .3f}, {-.5f, -.5f, 0}, {.5f, -.5f, .2f}};
    if (five) cusps.push_back({.8f, .2f, .7f});
    return {width,
            depth,
            height,
            root,
            Curve({{-.2f, .7f}, {0, .74f}, {.4f, .94f}, {.7f, 1}, {1, .9f}}),
            Curve({{-.2f, .76f}, {0, .8f}, {.35f, 1}, {.7f, .92f}, {1, .74f}}),
            cusps,
            .62f,
            .85f,
            true,
            -10};
}

std::vector<Tooth> lower_teeth()
{
    return {incisor(5.3f, 6, 9, 12.5f),
            incisor(5.8f, 6.4f, 9.3f, 13.5f),
            canine(),
            premolar(2.4f, 7.6f),
            premolar(1.2f, 8.2f),
            molar(11.2f, 10.4f, 7.6f, 14, true),
            molar(10.6f, 10.2f, 7.2f, 13, false),
            molar(9.8f, 9.4f, 6.6f, 11, false)};
}

constexpr float tooth_gap = .5f, neck_over_crest = 1.7f;

float crown_distance(const Tooth& t, vec3 q)
{
    const float h = std::clamp(q.z / t.height, -.2f, 1.f);
    const float a = .5f * t.width * t.wide(h), b = .5f * t.depth * t.deep(h);
    const float x = q.x / a, y = q.y / b, x2 = x * x, y2 = y * y;
    const float oval = std::sqrt(x2 + y2), boxy = std::sqrt(std::sqrt(x2 * x2 + y2 * y2));
    const float side = (mix(oval, boxy, t.square) - 1) * std::min(a, b);
    float top = -1e9f;
    const float wide = .5f * t.width, deep = .5f * t.depth;
    for (const Cusp& cusp : t.cusps) {
        const vec2 off(q.x - cusp.u * wide, q.y - cusp.v * deep);
        const float cone =
            t.height - cusp.drop - t.steep * (std::sqrt(glm::dot(off, off) + .6f) - .77f);
        top = top < -1e8f ? cone : smax(top, cone, .5f);
    }
    return smax(smax(side, .85f * (q.z - top), 1.1f), -1.5f - q.z, .6f);
}

// Where a tooth stands: its own axes are distal, outward and up.
struct Stand {
    vec3 origin;
    mat3 axes;
    bool left;

    Solid operator()(const Solid& own) const
    {
        vec3 lo(1e9f), hi(-1e9f);
        for (int i = 0; i < 8; ++i) {
            const vec3 corner(i & 1 ? own.hi.x : own.lo.x, i & 2 ? own.hi.y : own.lo.y,
                              i & 4 ? own.hi.z : own.lo.z);
            lo = glm::min(lo, origin + axes * corner);
            hi = glm::max(hi, origin + axes * corner);
        }
        const Solid here{lo, hi,
                         [f = own.distance, at = origin, back = glm::transpose(axes)](vec3 p) {
                             return f(back * (p - at));
                         }};
        return left ? here : mirrored(here);
    }
};

// Turned and lifted a little, as no tooth stands quite as the same one of the other side.
Stand stand_of(const Tooth& t, int number, bool left, const JawArch& arch, float along)
{
    const float outside = number < 3 ? -.3f : number < 5 ? -1.2f : -2.2f + .2f * float(number - 7);
    const float crest = 31 - .055f * std::max(along - 12, 0.f);
    const float lean = glm::radians(t.lean_deg);
    const float turn = glm::radians(4 * noise(vec3(float(number) * 1.7f, left ? 3.3f : 8.1f, 0)));
    const float lift = .35f * noise(vec3(2.1f, float(number) * 1.3f, left ? 5.7f : 1.9f));
    const vec2 d = arch.tangent(along);
    const vec3 ahead(d, 0), outward(d.y, -d.x, 0);
    const vec3 up = vec3(0, 0, std::cos(lean)) + outward * std::sin(lean);
    const vec3 distal = ahead * std::cos(turn) + glm::cross(up, ahead) * std::sin(turn);
    return {arch.at(along, outside, crest + neck_over_crest + lift),
            mat3(distal, glm::normalize(glm::cross(distal, up)), up), left};
}

void add_root(JawTeeth& out, const Tooth& t, const Stand& stand, float at, float across, float curl)
{
    const float b = .5f * t.depth * t.deep(0);
    out.roots.join(stand(tube({{{.4f * at, 0, 1}, across, .9f * b},
                               {{at, 0, -.35f * t.root}, .85f * across, .82f * b},
                               {{at + .4f * curl, 0, -.75f * t.root}, .55f * across, .55f * b},
                               {{at + curl, 0, -t.root}, .22f * across, .22f * b}},
                              {0, 1, 0})),
                   1);
    out.pulps.join(stand(tube({{{.3f * at, 0, .38f * t.height}, .3f * across, .25f * b},
                               {{.8f * at, 0, 0}, .32f * across, .28f * b},
                               {{at + curl * .6f, 0, -.8f * t.root}, .35f, .4f}},
                              {0, 1, 0})),
                   .5f);
}

void add_tooth(JawTeeth& out, const Tooth& t, const Stand& stand)
{
    out.crowns.part().join(stand(solid(
        {-.5f * t.width, -.5f * t.depth, -1.5f}, {.5f * t.width, .5f * t.depth, t.height},
        [shared = std::make_shared<Tooth>(t)](vec3 q) { return crown_distance(*shared, q); })));
    out.roots.part();
    out.pulps.part();
    const float a = .5f * t.width * t.wide(0);
    if (!t.two_roots) return add_root(out, t, stand, 0, a, 1);
    add_root(out, t, stand, -.45f * a, .46f * a, 1.2f);
    add_root(out, t, stand, .5f * a, .44f * a, 1.6f);
}

} // namespace

JawTeeth jaw_teeth(const JawArch& arch)
{
    constexpr float inner_arch = 1.03f; // how much longer the arch is than that of the teeth
    JawTeeth out;
    float along = .1f;
    int number = 0;
    for (const Tooth& t : lower_teeth()) {
        const float half = .5f * t.width * inner_arch;
        for (const bool left : {true, false})
            add_tooth(out, t, stand_of(t, number, left, arch, along + half));
        along += 2 * half + tooth_gap;
        ++number;
    }
    return out;
}

float over_roots(float along)
{
    static constexpr float middles[]{2.8f, 8.8f, 15.6f, 23, 30.5f, 37.6f, 42.9f, 49.3f, 54.4f};
    float out = 0;
    for (const float middle : middles) {
        const float t = (along - middle) / 2.4f;
        out = std::max(out, std::exp(-t * t));
    }
    return out;
}

} // namespace make
