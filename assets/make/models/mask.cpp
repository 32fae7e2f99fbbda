// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/models/face.h"

#include <algorithm>
#include <cmath>

namespace make {

// the face as a regular grid with exact texture coordinates in [0,1]^2: a base for tiles and
// incisions, closed by a back sheet
Model mask()
{
    Model m;
    int skin = m.material("mask", vec3(1), .5f);
    const int U = 90, V = 90;
    Mesh k;
    Distance f = [](vec3 p) { return face(p, false).distance; };
    std::vector<vec3> g((U + 1) * (V + 1));
    for (int j = 0; j <= V; j++)
        for (int i = 0; i <= U; i++) {
            float u = float(i) / U, v = float(j) / V, a = (u - .5f) * 2 * 1.36f,
                  e = mix(-.66f, 1.12f, v);
            vec3 o(.02f, mix(.42f, .68f, v), 0),
                dir(std::cos(a) * std::cos(e), std::sin(e), -std::sin(a) * std::cos(e));
            g[j * (U + 1) + i] = onto(f, o + dir * .62f, -dir);
        }
    for (int it = 0; it < 14; it++) {
        auto s = g;
        for (int j = 1; j < V; j++)
            for (int i = 1; i < U; i++) {
                auto at = [&](int a, int b) { return g[b * (U + 1) + a]; };
                vec3 c = at(i, j),
                     l = .25f * (at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1)) - c,
                     n = slope(f, c);
                c += .5f * (l - n * glm::dot(l, n));
                n = slope(f, c);
                s[j * (U + 1) + i] = c - n * f(c);
            }
        g = s;
    }
    for (auto& p : g) {
        k.points.push_back(p);
        k.colors.push_back(glm::mix(face(p, false).color, srgb(0xd8b49a), .35f));
    }
    for (auto& p : g) {
        vec3 n = slope(f, p);
        k.points.push_back(p - n * .022f);
        k.colors.push_back(srgb(0xb08468));
    }
    int N = (U + 1) * (V + 1);
    auto id = [&](int i, int j) { return j * (U + 1) + i; };
    auto t = [&](int i, int j) { return vec2(float(i) / U, float(j) / V); };
    for (int j = 0; j < V; j++)
        for (int i = 0; i < U; i++) {
            k.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
            k.uvs.push_back({t(i, j), t(i + 1, j), t(i + 1, j + 1), t(i, j + 1)});
            k.faces.push_back(
                {N + id(i, j), N + id(i, j + 1), N + id(i + 1, j + 1), N + id(i + 1, j)});
            k.uvs.push_back({t(i, j), t(i, j + 1), t(i + 1, j + 1), t(i + 1, j)});
        }
    auto wall = [&](int a, int b) {
        k.faces.push_back({b, a, N + a, N + b});
        k.uvs.push_back({});
    };
    for (int i = 0; i < U; i++) {
        wall(id(i, 0), id(i + 1, 0));
        wall(id(i + 1, V), id(i, V));
    }
    for (int j = 0; j < V; j++) {
        wall(id(U, j), id(U, j + 1));
        wall(id(0, j + 1), id(0, j));
    }
    m.root().parts.push_back(k.mat(skin));
    return m;
}

} // namespace make
