// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/parts.h"

#include "assets/make/field.h"

#include <algorithm>
#include <cmath>

namespace make {

Mesh prism_mesh(const std::vector<vec2>& v, float half, float b, int rows)
{
    int N = int(v.size());
    float area = 0;
    for (int i = 0; i < N; i++) area += v[i].x * v[(i + 1) % N].y - v[(i + 1) % N].x * v[i].y;
    std::vector<vec2> o = v;
    if (area < 0) std::reverse(o.begin(), o.end());
    auto inset = [&](float d) {
        std::vector<vec2> r(N);
        for (int i = 0; i < N; i++) {
            vec2 a = glm::normalize(o[i] - o[(i + N - 1) % N]),
                 c = glm::normalize(o[(i + 1) % N] - o[i]), n(-(a.y + c.y), a.x + c.x);
            float l = glm::dot(n, n) / 2;
            r[i] = o[i] + n * (d / std::max(l, .4f));
        }
        return r;
    };
    Mesh m;
    std::vector<float> zs;
    auto ring = [&](const std::vector<vec2>& r, float z) {
        for (auto& q : r) m.points.push_back({q.x, q.y, z});
    };
    int R = 0;
    auto cap = inset(b);
    for (int i = 0; i <= 2; i++, R++) {
        float a = 1.5708f * i / 2;
        ring(inset(b - b * std::sin(a)), -half + b - b * std::cos(a));
    }
    for (int i = 1; i < rows; i++, R++) ring(o, mix(-half + b, half - b, float(i) / rows));
    for (int i = 0; i <= 2; i++, R++) {
        float a = 1.5708f * i / 2;
        ring(inset(b - b * std::cos(a)), half - b + b * std::sin(a));
    }
    for (int i = 0; i + 1 < R; i++)
        for (int k = 0; k < N; k++) {
            int k1 = (k + 1) % N;
            m.faces.push_back({i * N + k, i * N + k1, (i + 1) * N + k1, (i + 1) * N + k});
        }
    std::vector<int> idx(N);
    for (int i = 0; i < N; i++) idx[i] = i; // ear clipping, best ear first
    auto cross = [](vec2 a, vec2 c) { return a.x * c.y - a.y * c.x; };
    while (idx.size() > 2) {
        int n = int(idx.size()), best = -1;
        float q = -2;
        for (int i = 0; i < n; i++) {
            vec2 a = cap[idx[(i + n - 1) % n]], c = cap[idx[i]], d = cap[idx[(i + 1) % n]];
            if (n > 3 && cross(c - a, d - c) <= 1e-12f) continue;
            bool ok = true;
            for (int j : idx) {
                vec2 p = cap[j];
                if (j == idx[i] || j == idx[(i + n - 1) % n] || j == idx[(i + 1) % n]) continue;
                if (cross(c - a, p - a) >= 0 && cross(d - c, p - c) >= 0 &&
                    cross(a - d, p - d) >= 0) {
                    ok = false;
                    break;
                }
            }
            if (!ok) continue;
            float l = std::max({glm::distance(a, c), glm::distance(c, d), glm::distance(a, d)}),
                  s = cross(c - a, d - a) / (l * l);
            if (s > q) {
                q = s;
                best = i;
            }
        }
        if (best < 0) best = 0;
        int a = idx[(best + n - 1) % n], c = idx[best], d = idx[(best + 1) % n];
        m.faces.push_back({d, c, a, -1});
        m.faces.push_back({(R - 1) * N + a, (R - 1) * N + c, (R - 1) * N + d, -1});
        idx.erase(idx.begin() + best);
    }
    return m;
}

} // namespace make
