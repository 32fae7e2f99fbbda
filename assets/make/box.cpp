// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace make {

namespace {

Mesh box_grid(const std::vector<float> (&g)[3], const std::function<vec3(vec3)>& place)
{
    Mesh m;
    std::map<std::array<int, 3>, int> id;
    auto vert = [&](std::array<int, 3> k) {
        auto [it, fresh] = id.try_emplace(k, int(m.points.size()));
        if (fresh) m.points.push_back(place({g[0][k[0]], g[1][k[1]], g[2][k[2]]}));
        return it->second;
    };
    for (int a = 0; a < 3; a++)
        for (int side = 0; side < 2; side++) {
            int b = (a + 1) % 3, c = (a + 2) % 3;
            for (int i = 0; i + 1 < int(g[b].size()); i++)
                for (int j = 0; j + 1 < int(g[c].size()); j++) {
                    Face q;
                    int o[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                    for (int k = 0; k < 4; k++) {
                        std::array<int, 3> v{};
                        v[a] = side ? int(g[a].size()) - 1 : 0;
                        v[b] = i + o[k][0];
                        v[c] = j + o[k][1];
                        q[k] = vert(v);
                    }
                    if (!side) std::swap(q[1], q[3]);
                    m.faces.push_back(q);
                }
        }
    return m;
}

} // namespace

Mesh bevel_box(vec3 half, float r, int seg, glm::ivec3 div)
{
    r = std::min({r, half.x * .98f, half.y * .98f, half.z * .98f});
    std::vector<float> g[3];
    for (int a = 0; a < 3; a++) {
        float in = half[a] - r;
        for (int i = 0; i < seg; i++)
            g[a].push_back(-in - r * std::tan((1 - float(i) / seg) * .785398f));
        for (int i = 0; i <= div[a]; i++) g[a].push_back(-in + 2 * in * i / div[a]);
        for (int i = 1; i <= seg; i++) g[a].push_back(in + r * std::tan(float(i) / seg * .785398f));
    }
    return box_grid(g, [=](vec3 q) {
        vec3 c = glm::clamp(q, -(half - r), half - r), d = q - c;
        float l = glm::length(d);
        return l > 0 ? c + d * (r / l) : q;
    });
}

Mesh ball_mesh(float r, int n)
{
    std::vector<float> g[3];
    for (auto& a : g)
        for (int i = 0; i <= n; i++) a.push_back(std::tan((2.f * i / n - 1) * .785398f));
    return box_grid(g, [=](vec3 q) { return glm::normalize(q) * r; });
}

} // namespace make
