// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/quadruped.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model quadruped(const Steed& z)
{
    Model m;
    int skin = m.material("coat", vec3(1), .7f), eye = m.material("eye", srgb(0x18100c), .08f),
        hoof = m.material("hoof", srgb(0x2e2722), .5f),
        glint = m.material("glint", srgb(0xffffff), .1f);
    Loft trunk(z.trunk);
    Limb neck(z.neck), fore(z.fore), hind(z.hind), tail(z.tail), mane(z.mane);
    vec3 a = z.poll, b = z.muzzle, ax = glm::normalize(b - a),
         up = glm::normalize(glm::cross(vec3(0, 0, 1), ax));
    float L = glm::distance(a, b), H = z.head;
    auto head = [=](float t, float u, float s) {
        return a + ax * (L * t) + up * (H * u) + vec3(0, 0, H * s);
    }; // along, above, aside
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        float shade = smooth_step(.30f, .62f, p.y + .03f * noise(p0 * 9.f));
        vec3 k = glm::mix(z.light, z.coat, shade);
        if (!z.camel) {
            const float pinto = noise(p0 * 5.5f + vec3(2, 0, 7)) + .12f * noise(p0 * 21.f);
            k = glm::mix(k, srgb(0xf2ece2), smooth_step(.20f, .27f, pinto));
            k = glm::mix(k, z.dark, smooth_step(.30f, .16f, p.y));
        }
        Sample s{trunk(p), k};
        vec3 q = p * vec3(1, 1, z.neck_flatness);
        add(s, neck(q) * .9f, k, .07f);
        add(s, fore(p), k, .045f);
        add(s, hind(p), k, .06f);
        vec3 l(glm::dot(p - a, ax) / L, glm::dot(p - a, up) / H, p.z / H); // head space
        vec3 hk = glm::mix(k, glm::mix(z.dark, z.coat, z.camel ? .6f : .12f),
                           smooth_step(.62f, 1.02f, l.x));
        if (!z.camel) {
            float blaze = smooth_step(.30f, .16f, l.z) * smooth_step(.25f, .45f, l.y) *
                          smooth_step(.12f, .25f, l.x) * smooth_step(.92f, .80f, l.x);
            hk = glm::mix(hk, srgb(0xf2ece2), blaze);
        }
        float d = capsule(p * vec3(1, 1, 1.25f), head(.06f, .0f, 0), head(.55f, .05f, 0), H * .92f,
                          H * .66f) *
                  .9f;
        d = smin(d,
                 capsule(p * vec3(1, 1, 1.12f), head(.5f, .06f, 0), head(.93f, .02f, 0), H * .64f,
                         H * .54f) *
                     .95f,
                 H * .35f);
        d = smin(d,
                 tilted(p, head(.20f, -.42f, .36f), vec3(L * .22f, H * .62f, H * .32f),
                        glm::degrees(std::atan2(ax.y, ax.x)), {0, 0, 1}),
                 H * .4f); // jowl
        d = smin(d, ellipsoid(p, head(.93f, -.28f, 0), vec3(H * .42f, H * .36f, H * .36f)),
                 H * .25f); // lower lip
        d = smin(d, ellipsoid(p, head(.30f, .58f, .52f), vec3(H * .36f, H * .26f, H * .24f)),
                 H * .25f); // brow
        s = join(s, {d, hk}, .03f);
        cut(s, ball(p, head(.315f, .36f, .84f), H * .19f), z.dark, H * .14f);
        cut(s, ellipsoid(p, head(1.00f, .22f, .52f), vec3(H * .11f, H * .19f, H * .12f)),
            z.dark * .5f, H * .08f); // nostril
        vec2 hl{l.x * L, l.y * H};
        cut(s,
            groove(s.distance,
                   path_distance(
                       hl, {{L * .72f, -H * .30f}, {L * .86f, -H * .20f}, {L * 1.25f, -H * .12f}}),
                   H * .035f, H * .10f),
            z.dark * .5f, H * .06f);
        vec3 e0 = head(-.02f, .62f, .46f), e1 = head(-.16f, 1.55f, .62f);
        if (z.camel) e1 = head(-.16f, 1.15f, .85f);
        float ear = capsule(p, e0, glm::mix(e0, e1, .55f), H * .20f, H * .23f);
        ear = smin(ear, capsule(p, glm::mix(e0, e1, .5f), e1, H * .23f, H * .05f), H * .1f);
        vec3 fr = glm::normalize(ax * .8f + vec3(0, 0, .75f));
        ear = smax(ear,
                   -capsule(p, glm::mix(e0, e1, .35f) + fr * H * .2f,
                            glm::mix(e0, e1, .85f) + fr * H * .12f, H * .17f, H * .05f),
                   H * .06f);
        s = join(s, {ear, z.coat}, H * .10f);
        float st = .0016f * std::sin(p.y * 75.f + p.x * 50.f + 60.f * p.z + 3.f * noise(p0 * 9.f));
        if (!z.mane.empty() && !z.camel)
            s = join(s, {(mane(p * vec3(1, 1, 1.5f)) + st) * .8f, z.dark}, .010f);
        s = join(
            s,
            {(tail(p) +
              (z.camel ? 0 : .004f * std::sin(std::atan2(p0.z, p.x - .07f) * 7.f + p.y * 30.f))),
             z.dark},
            .012f);
        return s;
    };
    Mesh bd = surface(f, {-.03f, 0, -.22f}, {1.06f, 1.12f, .22f}, {.0105f, true, 10});
    wrap_about_x(bd, z.trunk[z.trunk.size() / 2].y);
    auto& P = m.root().parts;
    P.push_back(bd.mat(skin));
    vec3 e = head(.315f, .36f, .66f);
    both(P, ball_mesh(H * .185f, 6).move(e).mat(eye));
    both(P, ball_mesh(H * .045f, 4).move(e + vec3(H * .07f, H * .10f, H * .15f)).mat(glint));
    for (int i = 0; i < 2; i++) {
        vec4 t = i ? z.hind.back() : z.fore.back();
        float r = i ? z.hind_hoof : z.fore_hoof;
        Mesh h = z.camel ? ball_mesh(r * 1.15f, 8).scale({1.12f, .55f, .95f}).warp([=](vec3 q) {
            return vec3(q.x, std::max(q.y + r * .42f, q.y < 0 ? r * .02f * (q.y + r) : 0.f), q.z);
        })
                         : cylinder(r * 1.12f, r * .80f, r * 1.25f, r * .14f, 20, 3);
        if (!z.camel)
            h.warp([=](vec3 q) { return vec3(q.x + (r * 1.25f - q.y) * .34f, q.y, q.z); });
        both(P, h.move({t.x - r * .05f, 0, t.z}).mat(hoof));
    }
    return m;
}

} // namespace make
