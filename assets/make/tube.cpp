// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>

namespace make {

std::vector<vec4> curve(const std::vector<vec4>& k, int n)
{
    std::vector<vec4> o;
    int N = int(k.size());
    for (int i = 0; i + 1 < N; i++) {
        vec4 b = k[i], c = k[i + 1], a = i ? k[i - 1] : 2.f * b - c,
             d = i + 2 < N ? k[i + 2] : 2.f * c - b;
        for (int j = 0; j < n; j++) {
            float t = float(j) / n;
            o.push_back(.5f * (2.f * b + t * (c - a) + t * t * (2.f * a - 5.f * b + 4.f * c - d) +
                               t * t * t * (3.f * b - a - 3.f * c + d)));
        }
    }
    o.push_back(k.back());
    return o;
}

Mesh tube(const std::vector<vec4>& path0, int n, bool loop, int cap)
{
    std::vector<vec4> P = path0;
    std::vector<vec4> ring;
    std::vector<vec3> T;
    int N = int(P.size());
    auto tan = [&](int i) {
        int a = loop ? (i + N - 1) % N : std::max(0, i - 1),
            b = loop ? (i + 1) % N : std::min(N - 1, i + 1);
        return glm::normalize(vec3(P[b]) - vec3(P[a]));
    };
    if (!loop)
        for (int k = 1; k <= cap; k++) {
            float a = 1.5708f * k / (cap + 1);
            vec3 t = tan(0);
            ring.push_back(vec4(vec3(P[0]) - t * P[0].w * std::cos(a), P[0].w * std::sin(a)));
            T.push_back(t);
        }
    for (int i = 0; i < N; i++) {
        ring.push_back(P[i]);
        T.push_back(tan(i));
    }
    if (!loop)
        for (int k = cap; k >= 1; k--) {
            float a = 1.5708f * k / (cap + 1);
            vec3 t = tan(N - 1);
            ring.push_back(
                vec4(vec3(P[N - 1]) + t * P[N - 1].w * std::cos(a), P[N - 1].w * std::sin(a)));
            T.push_back(t);
        }
    Mesh m;
    int R = int(ring.size());
    vec3 u =
        glm::normalize(glm::cross(T[0], std::abs(T[0].y) < .9f ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    std::vector<vec3> U(R);
    for (int i = 0; i < R; i++) {
        u = glm::normalize(u - T[i] * glm::dot(u, T[i]));
        U[i] = u;
    }
    float twist = 0;
    if (loop) {
        vec3 e = glm::normalize(u - T[0] * glm::dot(u, T[0]));
        twist = std::atan2(glm::dot(glm::cross(e, U[0]), T[0]), glm::dot(e, U[0]));
    }
    for (int i = 0; i < R; i++)
        for (int k = 0; k < n; k++) {
            float a = 6.2831853f * k / n + twist * i / R;
            vec3 w = glm::cross(T[i], U[i]);
            m.points.push_back(vec3(ring[i]) + ring[i].w * (U[i] * std::cos(a) + w * std::sin(a)));
        }
    for (int i = 0; i < (loop ? R : R - 1); i++)
        for (int k = 0; k < n; k++) {
            int j = (i + 1) % R, k1 = (k + 1) % n;
            m.faces.push_back({i * n + k, i * n + k1, j * n + k1, j * n + k});
            m.uvs.push_back({vec2(float(k) / n, float(i) / R),
                             {float(k + 1) / n, float(i) / R},
                             {float(k + 1) / n, float(i + 1) / R},
                             {float(k) / n, float(i + 1) / R}});
        }
    if (!loop)
        for (int e = 0; e < 2; e++) {
            int o = int(m.points.size()), b = e ? (R - 1) * n : 0;
            vec4 q = e ? P[N - 1] : P[0];
            vec3 t = e ? T[R - 1] : -T[0];
            m.points.push_back(vec3(q) + t * q.w);
            for (int k = 0; k < n; k++) {
                int k1 = (k + 1) % n;
                m.faces.push_back(e ? Face{b + k, b + k1, o, -1} : Face{b + k1, b + k, o, -1});
                float a = float(k) / n, c = float(k + 1) / n, v = e ? 1.f : 0.f;
                if (e)
                    m.uvs.push_back({vec2(a, v), {c, v}, {(a + c) / 2, v}, {}});
                else
                    m.uvs.push_back({vec2(c, v), {a, v}, {(a + c) / 2, v}, {}});
            }
        }
    return m;
}

} // namespace make
