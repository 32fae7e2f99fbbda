// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/texture.h"

namespace make {

namespace {

float ridge(vec3 p)
{
    return 1 - 2 * std::abs(noise(p));
}

// Hills with rocky crests, rough at the size of a creature that crawls over them. x in 0..1, z in
// -0.5..0.5.
float ground_height(float x, float z)
{
    const vec3 p(x * 3.1f, 0, z * 3.1f);
    const float hills = .55f * noise(p * .8f + vec3(3, 0, 1)) +
                        .26f * noise(p * 1.9f + vec3(9, 0, 4)) +
                        .35f * std::sin(x * 7.f + 1.f) * std::cos(z * 5.f);
    const float crests = .16f * ridge(p * 1.3f + vec3(5, 0, 2)) * smooth_step(-.1f, .5f, hills);
    const float rocks = .055f * ridge(p * 3.7f) + .022f * ridge(p * 8.3f + vec3(1, 0, 7));
    return .13f + .125f * (hills + crests + rocks);
}

vec3 ground_color(vec3 p)
{
    constexpr float e = .004f;
    const auto h = [&](float dx, float dz) { return ground_height(p.x + dx, p.z + dz); };
    const float y = h(0, 0);
    const vec3 n = glm::normalize(vec3(h(-e, 0) - h(e, 0), 2 * e, h(0, -e) - h(0, e)));
    const vec3 q(p.x, 0, p.z);
    const float patches = .5f * noise(q * 9.f) + .5f * noise(q * 21.f);
    vec3 c = glm::mix(srgb(0x93a56c), srgb(0xcabd8d), smooth_step(.08f, .22f, y + .05f * patches));
    c = glm::mix(c, srgb(0x7d9460), smooth_step(.10f, .04f, y + .02f * patches));
    const float hollow = (h(3 * e, 0) + h(-3 * e, 0) + h(0, 3 * e) + h(0, -3 * e)) / 4 - y;
    c = glm::mix(c, srgb(0xa89b88), smooth_step(.90f, .76f, n.y + .05f * patches)); // bare rock
    c *= 1 - 22.f * glm::clamp(hollow, -.004f, .006f);
    const float grain = .05f * noise(q * 60.f) + .06f * noise(q * 170.f) + .10f * noise(q * 430.f);
    return c * (1 + grain);
}

} // namespace

Model terrain()
{
    constexpr int cells = 128;
    constexpr int points = (cells + 1) * (cells + 1); // of one side
    constexpr float bottom = -.04f;
    Mesh k;
    for (const bool top : {true, false}) {
        for (int j = 0; j <= cells; ++j) {
            for (int i = 0; i <= cells; ++i) {
                const float x = float(i) / cells, z = float(j) / cells - .5f;
                k.points.push_back({x, top ? ground_height(x, z) : bottom, z});
                k.colors.push_back(top ? vec3(1) : vec3(.62f, .52f, .44f)); // earth, on the texture
            }
        }
    }
    const auto id = [](int i, int j) { return j * (cells + 1) + i; };
    const auto uv = [](int v) {
        const int p = v % points, row = p / (cells + 1), column = p % (cells + 1);
        return vec2(float(column), float(row)) / float(cells);
    };
    const auto quad = [&](int a, int b, int c, int d) {
        k.faces.push_back({a, b, c, d});
        k.uvs.push_back({uv(a), uv(b), uv(c), uv(d)});
    };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            quad(a, d, c, b);
            quad(points + a, points + b, points + c, points + d);
        }
    }
    const auto wall = [&](int a, int b) { quad(a, b, points + b, points + a); };
    for (int i = 0; i < cells; ++i) {
        wall(id(i, 0), id(i + 1, 0));
        wall(id(i + 1, cells), id(i, cells));
        wall(id(0, i + 1), id(0, i));
        wall(id(cells, i), id(cells, i + 1));
    }
    Model m;
    const int ground = m.material("ground", vec3(1), .95f);
    m.materials[0].texture = bake(k, {1280, 1280}, ground_color);
    m.root().parts.push_back(k.mat(ground));
    return m;
}

} // namespace make
