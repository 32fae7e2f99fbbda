// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model terrain()
{
    Model m;
    int g = m.material("ground", vec3(1), .95f);
    const int N = 92;
    Mesh k;
    auto H = [](float x, float z) {
        vec3 p(x * 3.1f, 0, z * 3.1f);
        float h = .55f * noise(p * .8f + vec3(3, 0, 1)) + .26f * noise(p * 1.9f + vec3(9, 0, 4)) +
                  .06f * noise(p * 4.5f);
        return .13f + .13f * h + .045f * std::sin(x * 7.f + 1.f) * std::cos(z * 5.f);
    };
    auto at = [&](int i, int j) {
        float x = float(i) / N, z = float(j) / N - .5f;
        return vec3(x, H(x, z), z);
    };
    for (int j = 0; j <= N; j++)
        for (int i = 0; i <= N; i++) {
            vec3 p = at(i, j);
            float e = 1.f / N;
            vec3 n = glm::normalize(
                vec3(H(p.x - e, p.z) - H(p.x + e, p.z), 2 * e, H(p.x, p.z - e) - H(p.x, p.z + e)));
            k.points.push_back(p);
            vec3 c = glm::mix(srgb(0x7f9a4a), srgb(0xb9ae6c),
                              smooth_step(.10f, .24f, p.y + .03f * noise(p * 14.f)));
            c = glm::mix(c, srgb(0x8b735a), smooth_step(.90f, .78f, n.y));
            c = glm::mix(c, srgb(0x55763a), smooth_step(.10f, .05f, p.y));
            k.colors.push_back(c * (1.f + .06f * noise(p * 60.f)));
        }
    int T = (N + 1) * (N + 1);
    for (int j = 0; j <= N; j++)
        for (int i = 0; i <= N; i++) {
            vec3 p = at(i, j);
            k.points.push_back({p.x, -.04f, p.z});
            k.colors.push_back(srgb(0x6b5140));
        }
    auto id = [&](int i, int j) { return j * (N + 1) + i; };
    auto uv = [&](int v) {
        return vec2(float(v % T % (N + 1)) / N, 1 - float(v % T / (N + 1)) / N);
    };
    auto quad = [&](int a, int b, int c, int d) {
        k.faces.push_back({a, b, c, d});
        k.uvs.push_back({uv(a), uv(b), uv(c), uv(d)});
    };
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            quad(id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j));
            quad(T + id(i, j), T + id(i + 1, j), T + id(i + 1, j + 1), T + id(i, j + 1));
        }
    for (int i = 0; i < N; i++) {
        quad(id(i + 1, 0), T + id(i + 1, 0), T + id(i, 0), id(i, 0));
        quad(id(i, N), T + id(i, N), T + id(i + 1, N), id(i + 1, N));
        quad(id(0, i), T + id(0, i), T + id(0, i + 1), id(0, i + 1));
        quad(id(N, i + 1), T + id(N, i + 1), T + id(N, i), id(N, i));
    }
    m.root().parts.push_back(k.mat(g));
    return m;
}

} // namespace make
