// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/parts.h"

#include "assets/make/field.h"

#include <cmath>

namespace make {

Mesh lathe(const std::vector<vec2>& rz, int n, bool loop)
{
    Mesh m;
    int R = int(rz.size());
    std::vector<int> base(R);
    std::vector<float> s(R + 1, 0);
    for (int i = 1; i <= R; i++) s[i] = s[i - 1] + glm::distance(rz[i % R], rz[i - 1]);
    float total = loop ? s[R] : s[R - 1];
    for (int i = 0; i < R; i++) {
        base[i] = int(m.points.size());
        bool pole = rz[i].x < 1e-6f;
        for (int k = 0; k < (pole ? 1 : n); k++) {
            float a = 6.2831853f * k / n;
            m.points.push_back({rz[i].x * std::sin(a), rz[i].y, rz[i].x * std::cos(a)});
        }
    }
    for (int i = 0; i < (loop ? R : R - 1); i++)
        for (int k = 0; k < n; k++) {
            int j = (i + 1) % R;
            bool a = rz[i].x < 1e-6f, b = rz[j].x < 1e-6f;
            int k1 = (k + 1) % n;
            float u0 = float(k) / n, u1 = float(k + 1) / n, v0 = s[i] / total,
                  v1 = s[i + 1] / total;
            if (a && b) continue;
            if (a) {
                m.faces.push_back({base[i], base[j] + k1, base[j] + k, -1});
                m.uvs.push_back({vec2((u0 + u1) / 2, v0), {u1, v1}, {u0, v1}, {}});
            } else if (b) {
                m.faces.push_back({base[i] + k, base[i] + k1, base[j], -1});
                m.uvs.push_back({vec2(u0, v0), {u1, v0}, {(u0 + u1) / 2, v1}, {}});
            } else {
                m.faces.push_back({base[i] + k, base[i] + k1, base[j] + k1, base[j] + k});
                m.uvs.push_back({vec2(u0, v0), {u1, v0}, {u1, v1}, {u0, v1}});
            }
        }
    return m;
}

Mesh cylinder(float r0, float r1, float h, float b, int n, int rows)
{
    std::vector<vec2> p{{0, 0}, {r0 * .5f, 0}};
    for (int i = 0; i <= 3; i++) {
        float a = 1.5708f * i / 3;
        p.push_back({r0 - b + b * std::sin(a), b - b * std::cos(a)});
    }
    for (int i = 1; i < rows; i++)
        p.push_back({mix(r0, r1, float(i) / rows), mix(b, h - b, float(i) / rows)});
    for (int i = 0; i <= 3; i++) {
        float a = 1.5708f * i / 3;
        p.push_back({r1 - b + b * std::cos(a), h - b + b * std::sin(a)});
    }
    p.push_back({r1 * .5f, h});
    p.push_back({0, h});
    return lathe(p, n);
}

} // namespace make
