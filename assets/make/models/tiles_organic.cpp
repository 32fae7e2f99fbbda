// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

Mesh rings(const std::function<vec3(float, float)>& at, int seg, int rows)
{ // s around, t from rim to tip; flat closed base
    Mesh m;
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i < seg; i++)
            m.points.push_back(at(float(i) / seg, float(j) / rows * .985f));
    int top = int(m.points.size());
    m.points.push_back(at(0, 1));
    for (int i = 0; i < seg; i++) {
        vec3 q = m.points[i];
        m.points.push_back({.5f + (q.x - .5f) * .5f, .5f + (q.y - .5f) * .5f, 0});
    }
    int base = int(m.points.size());
    m.points.push_back({.5f, .5f, 0});
    for (int i = 0; i < seg; i++) {
        int k = (i + 1) % seg;
        for (int j = 0; j < rows; j++)
            m.faces.push_back({j * seg + i, j * seg + k, (j + 1) * seg + k, (j + 1) * seg + i});
        m.faces.push_back({rows * seg + i, rows * seg + k, top, -1});
        m.faces.push_back({top + 1 + i, top + 1 + k, k, i});
        m.faces.push_back({base, top + 1 + k, top + 1 + i, -1});
    }
    return m;
}

vec2 squircle(float s, float n)
{
    float a = 2 * pi * s, c = std::cos(a), d = std::sin(a),
          r = std::pow(std::pow(std::abs(c), n) + std::pow(std::abs(d), n), -1 / n);
    return {r * c, r * d};
}

constexpr int segments = 40, row_count = 26;

} // namespace

Model tile_thorn()
{
    Model m;
    int a = m.material("thorn", vec3(1), .5f);
    Curve R({{0, .49f},
             {.06f, .49f},
             {.14f, .36f},
             {.26f, .22f},
             {.45f, .145f},
             {.7f, .085f},
             {.9f, .032f},
             {1, .0f}}),
        Z({{0, 0},
           {.06f, .030f},
           {.14f, .055f},
           {.26f, .13f},
           {.45f, .36f},
           {.7f, .68f},
           {.9f, .93f},
           {1, 1}}),
        X({{0, 0}, {.26f, 0}, {.45f, .015f}, {.7f, .09f}, {.9f, .21f}, {1, .28f}});
    Mesh k = rings(
        [&](float s, float t) {
            vec2 q = squircle(s, mix(9, 2, smooth_step(0, .22f, t))) * R(t);
            return vec3(.5f + q.x + X(t), .5f + q.y, Z(t));
        },
        segments, row_count);
    k.paint([](vec3 p) {
        return glm::mix(srgb(0x5d7a3c),
                        glm::mix(srgb(0x8f6a3a), srgb(0xc0392b), smooth_step(.55f, 1, p.z)),
                        smooth_step(.04f, .45f, p.z));
    });
    m.root().parts.push_back(k.mat(a));
    return m;
}

Model tile_flower()
{
    Model m;
    int a = m.material("flower", vec3(1), .5f);
    Mesh k = rings(
        [&](float s, float t) {
            Curve R({{0, .49f},
                     {.06f, .49f},
                     {.12f, .20f},
                     {.20f, .085f},
                     {.30f, .075f},
                     {.40f, .17f},
                     {.52f, .36f},
                     {.60f, .47f},
                     {.64f, .485f},
                     {.68f, .455f},
                     {.78f, .27f},
                     {.86f, .145f},
                     {.90f, .135f},
                     {.95f, .10f},
                     {1, 0}}),
                Z({{0, 0},
                   {.06f, .030f},
                   {.12f, .045f},
                   {.20f, .13f},
                   {.30f, .36f},
                   {.40f, .44f},
                   {.52f, .50f},
                   {.60f, .60f},
                   {.64f, .645f},
                   {.68f, .640f},
                   {.78f, .530f},
                   {.86f, .505f},
                   {.90f, .560f},
                   {.95f, .615f},
                   {1, .63f}});
            float petal = smooth_step(.36f, .56f, t) * smooth_step(.84f, .76f, t),
                  lobe = std::pow(std::abs(std::cos(4 * 2 * pi * s * .5f * 1.25f)), .55f);
            float n = mix(9, 2, smooth_step(0, .12f, t));
            vec2 q = squircle(s, n) * R(t) * (1 - petal * .46f * (1 - lobe));
            float z = Z(t) + petal * .05f * (lobe - .5f);
            return vec3(.5f + q.x, .5f + q.y, z);
        },
        segments, row_count);
    for (int j = 0; j <= row_count; j++)
        for (int i = 0; i < segments; i++) {
            float t = float(j) / row_count;
            vec3 c = glm::mix(srgb(0x5d7a3c), srgb(0x6f9a45), saturate(t * 3));
            c = glm::mix(c, srgb(0xd9538b), smooth_step(.36f, .46f, t));
            c = glm::mix(c, srgb(0xf7a8c6),
                         smooth_step(.70f, .58f, std::abs(t - .60f) * 6) *
                             smooth_step(.4f, .5f, t));
            c = glm::mix(c, srgb(0xf2c335), smooth_step(.82f, .87f, t));
            k.colors.push_back(c);
        }
    k.colors.resize(k.points.size(), srgb(0xf2c335));
    for (size_t i = size_t(segments * (row_count + 1) + 1); i < k.points.size(); i++)
        k.colors[i] = srgb(0x5d7a3c);
    m.root().parts.push_back(k.mat(a));
    return m;
}

Model tile_hair()
{
    Model m;
    int a = m.material("hair", vec3(1), .6f);
    for (int i = 0; i < 8; i++) {
        float g = i * 2.39996f, r = .36f * std::sqrt((i + .5f) / 8), x = .5f + r * std::cos(g),
              y = .5f + r * std::sin(g), h = .82f + .18f * noise(vec3(i * 3.1f, 0, 0)),
              lean = .16f + .10f * noise(vec3(0, i * 2.3f, 0)),
              side = .10f * noise(vec3(0, 0, i * 1.7f));
        std::vector<vec4> k{{x, y, .008f, .030f},
                            {x + lean * .10f, y + side * .2f, h * .30f, .027f},
                            {x + lean * .55f, y + side * .6f, h * .65f, .021f},
                            {x + lean * 1.5f, y + side * 1.3f, h, .006f}};
        Mesh t = tube(curve(k, 6), 8, false, 2);
        for (auto& p : t.points) p.z = std::max(p.z, 0.f);
        t.paint([=](vec3 p) {
            return glm::mix(srgb(0x4b2f1c), srgb(0xb98a4e), saturate(p.z) * (.8f + .05f * i));
        });
        m.root().parts.push_back(t.mat(a));
    }
    return m;
}

Model tile_scale()
{
    Model m;
    int a = m.material("scale", vec3(1), .3f);
    Mesh k = surface(
        [](vec3 p) {
            float y = p.y,
                  w = .50f *
                      std::sqrt(saturate(1 - std::pow(std::max(0.f, (.35f - y) / .62f), 2.2f))) *
                      (y > .35f ? mix(1.f, .72f, saturate((y - .35f) / .65f)) : 1.f);
            float out = std::max(std::abs(p.x - .5f) - w, std::max(-.26f - y, y - .97f)) * .8f;
            float mid = mix(.30f, .055f, saturate((y + .26f) / 1.23f)) -
                        .28f * (p.x - .5f) * (p.x - .5f) +
                        .018f * std::cos((p.x - .5f) * 10.f) * smooth_step(.9f, .2f, y);
            float d = smax(out, std::abs(p.z - mid) - mix(.040f, .050f, saturate(y)), .05f);
            vec3 c = glm::mix(srgb(0x2f8f86), srgb(0x174f63), smooth_step(-.2f, .8f, y));
            c = glm::mix(c, srgb(0xd7c56a),
                         smooth_step(.05f, .01f, -out) * smooth_step(.3f, -.1f, y));
            return Sample{d * .85f, c};
        },
        {-.02f, -.28f, -.04f}, {1.02f, 1.0f, .42f}, {.028f, false, 8});
    m.root().parts.push_back(k.mat(a));
    return m;
}

} // namespace make
