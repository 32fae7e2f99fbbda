// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

Mesh link(vec3 o, float len, float wid, float r, float roll, vec3 axis)
{ // a stadium of wire lying in xy, rolled about axis
    std::vector<vec4> q;
    const int N = 60;
    float st = len - wid;
    for (int i = 0; i < N; i++) {
        float u = float(i) / N * (4 * st + 2 * pi * wid), x, y;
        if (u < 2 * st) {
            x = -st + u;
            y = -wid;
        } else if ((u -= 2 * st) < pi * wid) {
            float a = u / wid - pi / 2;
            x = st + wid * std::cos(a);
            y = wid * std::sin(a);
        } else if ((u -= pi * wid) < 2 * st) {
            x = st - u;
            y = wid;
        } else {
            u -= 2 * st;
            float a = u / wid + pi / 2;
            x = -st + wid * std::cos(a);
            y = wid * std::sin(a);
        }
        q.push_back({x, y, 0, r});
    }
    Mesh k = tube(q, 10, true);
    return k.turn(roll, axis).move(o);
}

} // namespace

Model tile_chain()
{
    Model m;
    int a = m.material("steel", srgb(0xb8bec6), .25f, .8f),
        b = m.material("gold", srgb(0xd9aa45), .25f, .8f);
    auto& P = m.root().parts;
    P.push_back(link({.25f, .5f, .26f}, .305f, .155f, .060f, 45, {1, 0, 0}).mat(a));
    P.push_back(link({.75f, .5f, .26f}, .305f, .155f, .060f, -45, {1, 0, 0}).mat(b));
    return m;
}

Model tile_mail()
{
    Model m;
    int a = m.material("steel", srgb(0xaab2bb), .3f, .8f);
    auto& P = m.root().parts;
    P.push_back(link({.25f, .25f, .24f}, .44f, .4399f, .048f, 26, {1, 0, 0}).mat(a));
    P.push_back(link({.75f, .75f, .24f}, .44f, .4399f, .048f, -26, {1, 0, 0}).mat(a));
    return m;
}

Model tile_hex()
{
    Model m;
    int a = m.material("tile_a", srgb(0x3f8f9b), .25f),
        b = m.material("tile_b", srgb(0xe9dcc0), .3f);
    vec2 o[4] = {{.25f, .25f}, {.75f, .25f}, {.5f, .75f}, {1.f, .75f}};
    for (int i = 0; i < 4; i++) {
        std::vector<vec2> h;
        for (int k = 0; k < 6; k++) {
            float g = pi / 3 * k + pi / 2;
            h.push_back(
                {.5f * .955f / std::sqrt(3.f) * std::cos(g), .6667f * .5f * .955f * std::sin(g)});
        }
        Mesh k;
        std::vector<vec2> e;
        for (int q = 0; q < 6; q++)
            for (int s = 0; s < 6; s++) e.push_back(glm::mix(h[q], h[(q + 1) % 6], s / 6.f));
        int N = int(e.size());
        Curve S({{0, 1}, {.3f, 1}, {.45f, .985f}, {.6f, .93f}, {1, .0f}}),
            Z({{0, 0}, {.3f, .14f}, {.45f, .185f}, {.6f, .205f}, {1, .255f}});
        const int R = 10;
        for (int j = 0; j < R; j++)
            for (auto& q : e) {
                float t = j < 6 ? j * .1f : .6f + (j - 5) * .08f;
                k.points.push_back(vec3(o[i] + q * S(t), Z(t)));
            }
        int c = int(k.points.size());
        k.points.push_back(vec3(o[i], Z(1)));
        int bs = int(k.points.size());
        for (auto& q : e) k.points.push_back(vec3(o[i] + q * .5f, 0));
        int bc = int(k.points.size());
        k.points.push_back(vec3(o[i], 0));
        for (int q = 0; q < N; q++) {
            int r = (q + 1) % N;
            for (int j = 0; j + 1 < R; j++)
                k.faces.push_back({j * N + q, j * N + r, (j + 1) * N + r, (j + 1) * N + q});
            k.faces.push_back({(R - 1) * N + q, (R - 1) * N + r, c, -1});
            k.faces.push_back({bs + q, bs + r, r, q});
            k.faces.push_back({bc, bs + r, bs + q, -1});
        }
        m.root().parts.push_back(k.mat(i == 2 || i == 0 ? a : b));
    }
    return m;
}

} // namespace make
