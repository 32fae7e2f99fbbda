// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/subdivide.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace make {

Model dodecahedron()
{
    Model m;
    int a = m.material("ivory", srgb(0xd9cfb8), .35f);
    const float g = 1.6180340f;
    std::vector<vec3> V;
    for (int i = 0; i < 8; i++) V.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    for (int i = 0; i < 4; i++) {
        float s = i & 1 ? 1.f : -1.f, t = i & 2 ? 1.f : -1.f;
        V.push_back({0, s / g, t * g});
        V.push_back({s / g, t * g, 0});
        V.push_back({t * g, 0, s / g});
    }
    std::vector<vec3> N;
    for (int i = 0; i < 4; i++) {
        float s = i & 1 ? 1.f : -1.f, t = i & 2 ? 1.f : -1.f;
        for (vec3 n : {vec3(0, s * g, t), vec3(s * g, t, 0), vec3(t, 0, s * g)})
            N.push_back(glm::normalize(n));
    }
    Mesh k;
    k.points = V;
    float h = 0;
    for (auto& v : V) h = std::max(h, glm::dot(v, N[0]));
    for (auto& n : N) {
        std::vector<int> f;
        for (int i = 0; i < 20; i++)
            if (glm::dot(V[i], n) > h - .01f) f.push_back(i);
        vec3 c(0);
        for (int i : f) c += V[i] / 5.f;
        vec3 x = glm::normalize(V[f[0]] - c), y = glm::cross(n, x);
        std::sort(f.begin(), f.end(), [&](int p, int q) {
            return std::atan2(glm::dot(V[p] - c, y), glm::dot(V[p] - c, x)) <
                   std::atan2(glm::dot(V[q] - c, y), glm::dot(V[q] - c, x));
        });
        int o = int(k.points.size());
        k.points.push_back(c);
        for (int i = 0; i < 5; i++) {
            vec3 mid = .5f * (V[f[i]] + V[f[(i + 1) % 5]]);
            int at = -1;
            for (size_t q = 20; q < k.points.size(); q++)
                if (glm::distance(k.points[q], mid) < 1e-4f) at = int(q);
            if (at < 0) {
                at = int(k.points.size());
                k.points.push_back(mid);
            }
            f.push_back(at);
        }
        for (int i = 0; i < 5; i++) k.faces.push_back({f[i], f[5 + i], o, f[5 + (i + 4) % 5]});
    }
    std::map<std::pair<int, int>, float> sharp;
    for (auto& q : k.faces)
        for (int i = 0; i < 4; i++) {
            int p = q[i], r = q[(i + 1) & 3];
            sharp[{std::min(p, r), std::max(p, r)}] = 10;
        }
    k = catmull_clark(k, sharp, 3);
    const float r = .10f;
    for (auto& p : k.points) { // nearest point of the inner solid (Dykstra), then out by r: edges
                               // and corners become round
        vec3 x = p;
        std::vector<vec3> e(12, vec3(0));
        for (int it = 0; it < 60; it++)
            for (int i = 0; i < 12; i++) {
                vec3 y = x + e[i];
                float d = glm::dot(y, N[i]) - (h - r);
                vec3 z = d > 0 ? y - N[i] * d : y;
                e[i] = y - z;
                x = z;
            }
        vec3 d = p - x;
        float l = glm::length(d);
        if (l > 1e-6f) p = x + d * (r / l);
    }
    vec3 ax = glm::cross(N[0], vec3(0, -1, 0));
    if (glm::length(ax) > 1e-5f) {
        mat4 q =
            glm::rotate(mat4(1), std::acos(glm::clamp(glm::dot(N[0], vec3(0, -1, 0)), -1.f, 1.f)),
                        glm::normalize(ax));
        k.apply(q);
    }
    k.scale(vec3(.5f / 1.6f));
    k.move({0, h * .5f / 1.6f, 0});
    m.root().parts.push_back(k.mat(a));
    return m;
}

} // namespace make
