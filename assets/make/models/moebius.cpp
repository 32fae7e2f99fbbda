// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/subdivide.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace make {

Model moebius()
{
    Model m;
    int a = m.material("band", vec3(1), .45f);
    const int N = 240;
    auto sec =
        fillet({{-.135f, -.0125f}, {.135f, -.0125f}, {.135f, .0125f}, {-.135f, .0125f}}, .010f, 3);
    std::vector<vec2> ring;
    for (size_t i = 0; i < sec.size(); i++) {
        vec2 p = sec[i], q = sec[(i + 1) % sec.size()];
        int n = std::max(1, int(glm::distance(p, q) / .018f));
        for (int k = 0; k < n; k++) ring.push_back(glm::mix(p, q, float(k) / n));
    }
    int K = int(ring.size());
    Mesh k;
    for (int i = 0; i < N; i++) {
        float t = 2 * pi * i / N, w = t / 2;
        vec3 o(.40f * std::cos(t), 0, -.40f * std::sin(t)), out(std::cos(t), 0, -std::sin(t)),
            up(0, 1, 0);
        for (auto& q : ring) {
            vec3 e = up * std::cos(w) + out * std::sin(w), n = out * std::cos(w) - up * std::sin(w);
            k.points.push_back(o + e * q.x + n * q.y + vec3(0, .15f, 0));
        }
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < K; j++) {
            int i1 = (i + 1) % N, s = i + 1 == N ? K / 2 : 0, j1 = (j + 1) % K;
            k.faces.push_back({i * K + j, i1 * K + (j + s) % K, i1 * K + (j1 + s) % K, i * K + j1});
            float u0 = float(i) / N, u1 = float(i + 1) / N, v0 = float(j) / K,
                  v1 = float(j + 1) / K;
            k.uvs.push_back({vec2(u0, v0), {u1, v0}, {u1, v1}, {u0, v1}});
        }
    orient_outward(k);
    k.paint([](vec3) { return srgb(0xc9a15c); });
    m.root().parts.push_back(k.mat(a));
    return m;
}

// the band as Escher drew it, a lattice: solid cells of a twisted grid, walls where solid meets
// hole, subdivided once
Model moebius_lattice()
{
    Model m;
    int a = m.material("band", srgb(0xa8603c), .5f);
    const int N = 114, J = 13;
    const float half = .145f, thick = .0125f;
    Mesh k;
    std::map<std::array<int, 3>, int> id;
    auto solid = [&](int i, int j) {
        if (j < 0 || j >= J) return false;
        i = (i + N) % N;
        return i % 3 == 0 || j % 3 == 0;
    };
    auto vert = [&](int i, int j, int s) {
        if (i >= N) {
            i -= N;
            j = J - j;
            s = 1 - s;
        }
        auto [it, fresh] = id.try_emplace({i, j, s}, int(k.points.size()));
        if (fresh) {
            float cell = 0, total = 0;
            for (int q = 0; q < J; q++) {
                float w = q % 3 == 0 ? 1.f : 1.15f;
                total += w;
                if (q < j) cell += w;
            }
            float t = 2 * pi * i / N, w = t / 2, x = (cell / total - .5f) * 2 * half;
            vec3 out(std::cos(t), 0, -std::sin(t)), up(0, 1, 0),
                e = up * std::cos(w) + out * std::sin(w), n = out * std::cos(w) - up * std::sin(w);
            k.points.push_back(out * .40f + e * x + n * (s ? thick : -thick) +
                               vec3(0, half + .01f, 0));
        }
        return it->second;
    };
    for (int i = 0; i < N; i++)
        for (int j = 0; j < J; j++) {
            if (!solid(i, j)) continue;
            auto quad = [&](std::array<int, 3> p, std::array<int, 3> q, std::array<int, 3> r,
                            std::array<int, 3> t) {
                k.faces.push_back({vert(p[0], p[1], p[2]), vert(q[0], q[1], q[2]),
                                   vert(r[0], r[1], r[2]), vert(t[0], t[1], t[2])});
            };
            quad({i, j, 1}, {i + 1, j, 1}, {i + 1, j + 1, 1}, {i, j + 1, 1});
            quad({i, j, 0}, {i, j + 1, 0}, {i + 1, j + 1, 0}, {i + 1, j, 0});
            auto wall = [&](int i0, int j0, int i1, int j1) {
                quad({i0, j0, 1}, {i0, j0, 0}, {i1, j1, 0}, {i1, j1, 1});
            };
            if (!solid(i, j - 1)) wall(i, j, i + 1, j);
            if (!solid(i, j + 1)) wall(i + 1, j + 1, i, j + 1);
            if (!solid(i + 1, j)) wall(i + 1, j, i + 1, j + 1);
            if (!solid(i - 1, j)) wall(i, j + 1, i, j);
        }
    orient_outward(k);
    m.root().parts.push_back(catmull_clark(k, {}, 1).mat(a));
    return m;
}

} // namespace make
