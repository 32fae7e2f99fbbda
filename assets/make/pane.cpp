// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/pane.h"

#include "assets/make/outline.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>

namespace make {

Mesh pane(const Distance& body, const std::vector<vec2>& o, const Place& at, vec3 dir, float out,
          int rows, float rim)
{
    std::vector<vec2> even;
    {
        float len = 0;
        int n = int(o.size());
        for (int i = 0; i < n; i++) len += glm::distance(o[i], o[(i + 1) % n]);
        int N = std::clamp(int(len / .0095f), 20, 84);
        float step = len / N, need = 0;
        for (int i = 0; i < n; i++) {
            vec2 a = o[i], b = o[(i + 1) % n];
            float l = glm::distance(a, b);
            while (need < l && int(even.size()) < N) {
                even.push_back(glm::mix(a, b, need / l));
                need += step;
            }
            need -= l;
        }
    }
    int N = int(even.size());
    vec2 c(0);
    for (auto& q : even) c += q / float(N);
    Mesh m;
    float R = 0;
    for (auto& q : even) R += glm::distance(q, c) / N;
    auto ring = [&](float s, float lift) {
        for (auto& q : even) {
            vec2 t = c + (q - c) * s;
            vec3 x = onto(body, at(t), dir);
            m.points.push_back(x + slope(body, x) * lift);
        }
    };
    std::vector<vec2> r{{1, -.006f}, {1, out * .3f}, {1 - rim / R, out}};
    for (int i = 1; i < rows; i++) r.push_back({(1 - rim / R) * (1 - float(i) / rows), out});
    for (auto& q : r) ring(q.x, q.y);
    int K = int(r.size()), top = int(m.points.size());
    {
        vec3 x = onto(body, at(c), dir), n = slope(body, x);
        m.points.push_back(x + n * out);
        m.points.push_back(x - n * .006f);
    }
    int under = int(m.points.size());
    ring(.5f, -.006f);
    for (int i = 0; i < N; i++) {
        int j = (i + 1) % N;
        for (int k = 0; k + 1 < K; k++)
            m.faces.push_back({k * N + i, k * N + j, (k + 1) * N + j, (k + 1) * N + i});
        m.faces.push_back({(K - 1) * N + i, (K - 1) * N + j, top, -1});
        m.faces.push_back({under + i, under + j, j, i});
        m.faces.push_back({under + j, under + i, top + 1, -1});
    }
    orient_outward(m);
    return m;
}

// a panel gap: a thin dark cord laid half into the body
Mesh gap(const Distance& body, const std::vector<vec2>& path, const Place& at, vec3 dir, float r)
{
    std::vector<vec4> q;
    for (auto& t : smooth_loop(path, 6, false)) q.push_back(vec4(onto(body, at(t), dir), r));
    return tube(q, 6, false, 1);
}

} // namespace make
