// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

Model brick(int kind)
{
    Model m;
    int a = m.material("brick", vec3(1), .9f);
    auto one = [=](vec3 p, vec3 lo, vec3 hi, float seed, vec3 col) {
        vec3 c = .5f * (lo + hi), h = .5f * (hi - lo);
        float d =
            box(p, c, h, .045f) + .012f * noise(p * 7.f + seed) + .006f * noise(p * 19.f + seed);
        return Sample{d * .9f,
                      col * (1.f + .13f * noise(p * 11.f + seed * 2.f) + .08f * noise(p * 34.f))};
    };
    vec3 c0 = srgb(0xb0533a), c1 = srgb(0xc26a48), c2 = srgb(0x9a4633);
    auto f = [=](vec3 p) {
        Sample s;
        float T = .34f;
        if (kind == 0) {
            s = one(p, {.03f, .04f, .0f}, {.97f, .96f, T}, 1, c0);
        } else if (kind == 1) {
            s = one(p, {.03f, .04f, 0}, {.485f, .96f, T * .95f}, 5, c1);
            Sample t = one(p, {.515f, .04f, 0}, {.97f, .96f, T * 1.05f}, 9, c2);
            s = t.distance < s.distance ? t : s;
        } else if (kind == 2) {
            s = one(p, {.03f, .04f, 0}, {.97f, .96f, T}, 13, c2);
            cut(s, ellipsoid(p, {1.0f, .98f, .36f}, {.26f, .22f, .20f}) + .03f * noise(p * 13.f),
                c1 * 1.15f, .03f);
            cut(s, ellipsoid(p, {.28f, .0f, .36f}, {.16f, .12f, .11f}) + .02f * noise(p * 17.f),
                c1 * 1.1f, .03f);
            cut(s,
                std::max(path_distance({p.x, p.y},
                                       {{.40f, 1.f}, {.46f, .72f}, {.42f, .52f}, {.50f, .35f}}) -
                             .010f,
                         .24f - p.z),
                c2 * .7f, .02f);
        } else {
            s = one(p, {.03f, .04f, 0}, {.97f, .96f, T}, 21, c1);
            for (float x : {.27f, .73f})
                cut(s, glm::length(vec2(p.x - x, p.y - .5f)) - .15f + .008f * noise(p * 14.f),
                    c2 * .8f, .035f);
        }
        s.distance = smax(s.distance, -p.z, .006f);
        return s;
    };
    Mesh k = surface(f, {0, 0, -.02f}, {1, 1, .42f}, {.030f, false, 8});
    k.uvs.resize(k.faces.size());
    for (size_t i = 0; i < k.faces.size(); i++)
        for (int q = 0; q < 4; q++) k.uvs[i][q] = vec2(k.points[k.faces[i][q]]);
    m.root().parts.push_back(k.mat(a));
    return m;
}

} // namespace

Model tile_brick_a()
{
    return brick(0);
}
Model tile_brick_b()
{
    return brick(1);
}
Model tile_brick_c()
{
    return brick(2);
}
Model tile_brick_hollow()
{
    return brick(3);
}

} // namespace make
