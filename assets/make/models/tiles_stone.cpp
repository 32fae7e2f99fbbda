// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

// A cobblestone, hewn once and worn since.
Model tile_cobble()
{
    Model m;
    const int a = m.material("stone", vec3(1), .8f);
    const auto f = [](vec3 p) {
        const vec3 c(.5f, .5f, .16f);
        float d = box(p, c, {.47f, .45f, .255f}, .20f);
        const vec4 hewn[] = {{.62f, .25f, .75f, .385f},
                             {-.70f, .55f, .45f, .425f},
                             {-.30f, -.80f, .52f, .40f},
                             {.85f, -.50f, .15f, .475f},
                             {.10f, .93f, .35f, .415f}};
        for (const vec4& face : hewn)
            d = smax(d, glm::dot(glm::normalize(vec3(face)), p - c) - face.w, .05f);
        d += .022f * noise(p * 4.2f + 3.f) + .009f * noise(p * 11.f);
        d = smax(d, -p.z, .012f);
        const float grain = noise(p * 9.f + 5.f), speck = noise(p * 31.f);
        vec3 color = glm::mix(srgb(0x857d72), srgb(0xb3aa9b), saturate(.5f + .7f * grain));
        color = glm::mix(color, srgb(0xd9d3c6), .6f * smooth_step(.35f, .6f, speck));
        color = glm::mix(color, srgb(0x59544d), .6f * smooth_step(.35f, .6f, -speck));
        color = glm::mix(srgb(0x46413a), color, smooth_step(.02f, .24f, p.z));
        return Sample{d * .9f, color};
    };
    m.root().parts.push_back(surface(f, {0, 0, -.03f}, {1, 1, .5f}, {.047f, false, 8}).mat(a));
    return m;
}

// A slate, its root at +y and its weathered lower end, raised to lie on the next row, at -y.
Model tile_shingle()
{
    Model m;
    const int a = m.material("slate", vec3(1), .7f);
    const auto broken = [](float x) { // how much of the lower end is gone
        return .055f * smooth_step(.14f, .0f, x) +
               .085f * smooth_step(.13f, .02f, std::abs(x - .70f)) +
               .16f * smooth_step(.86f, 1, x) + .012f * noise({x * 11, 0, 4});
    };
    const auto place = [=](vec2 q) {
        const float side =
            .012f * noise({q.x > .5f ? 7.f : 2.f, q.y * 7, 0}) * (std::abs(q.x - .5f) * 2);
        return vec2(mix(.02f, .98f, q.x) + side, mix(-.26f + broken(q.x), .97f, q.y));
    };
    const auto under = [](vec2 p) { return mix(.205f, .012f, saturate((p.y + .26f) / 1.23f)); };
    const auto rim = [](vec2 q, float w) {
        return smooth_step(w, 0, std::min({q.x, 1 - q.x, q.y, 1 - q.y}));
    };
    Plate slate{
        {0,    .02f, .07f, .14f, .21f, .28f, .35f, .42f, .49f, .56f,  .60f,
         .64f, .68f, .72f, .76f, .80f, .84f, .88f, .92f, .96f, .985f, 1},
        {0, .016f, .05f, .09f, .14f, .2f, .27f, .35f, .44f, .54f, .64f, .74f, .84f, .93f, .984f, 1},
        [=](vec2 q) {
            const vec2 p = place(q);
            const float split = noise({p.x * 3, p.y * 5, 2}),
                        layer = smooth_step(.0f, .12f, split) + smooth_step(.32f, .42f, split),
                        flake = broken(q.x) * smooth_step(.14f, 0, q.y);
            return vec3(p, under(p) + .058f + .010f * layer +
                               .006f * noise({p.x * 9, p.y * 17, 0}) - .014f * rim(q, .03f) -
                               .30f * flake);
        },
        [=](vec2 q) { return vec3(place(q), under(place(q))); },
        [=](vec2 q, bool above) {
            const vec2 p = place(q);
            const float split = noise({p.x * 3, p.y * 5, 2}), n = noise({p.x * 8, p.y * 12, 5});
            vec3 c = glm::mix(srgb(0x48525f), srgb(0x66717f), saturate(.5f + .6f * n));
            c = glm::mix(c, srgb(0x3c4550), smooth_step(.05f, .4f, split));
            c = glm::mix(c, srgb(0x81705a),
                         .45f * smooth_step(.15f, .5f, noise({p.x * 4, p.y * 3, 8})));
            c = glm::mix(c, srgb(0xa3acb5),
                         above ? .7f * saturate(broken(q.x) * smooth_step(.12f, 0, q.y) * 14)
                               : 0.f);
            return glm::mix(c, srgb(0x8d97a1), .5f * rim(q, .025f));
        }};
    m.root().parts.push_back(plate(slate).mat(a));
    return m;
}

} // namespace make
