// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

// A Yarn is a twisted thread along a path; t runs from 0 to 1, and so does x of its ends.
struct Yarn {
    std::function<vec3(float)> path;
    float radius;
    int plies, turns; // threads that it is twisted of, and how often they go round it
    int rows, sides;
    vec3 dark, light;         // colours between the plies and on them
    bool ends_upright = true; // its rings are in planes of constant x
};

// One period: it begins in the plane x = 0 and ends in x = 1 with the same ring, so that copies in
// a line continue each other.
Mesh spun(const Yarn& yarn)
{
    Mesh m;
    const int n = yarn.sides;
    for (int j = 0; j <= yarn.rows; j++) {
        const float t = float(j) / yarn.rows, e = 1e-3f;
        const vec3 c = yarn.path(t), along = glm::normalize(yarn.path(t + e) - yarn.path(t - e)),
                   up = glm::normalize(vec3(0, 0, 1) - along * along.z),
                   left = glm::cross(up, along);
        for (int i = 0; i < n; i++) {
            const float a = 2 * pi * i / n,
                        ply = std::cos(yarn.plies * a - 2 * pi * yarn.turns * t);
            vec3 w = yarn.radius * (1 + .09f * ply) * (left * std::cos(a) + up * std::sin(a));
            if (yarn.ends_upright) w -= along * (w.x / along.x);
            m.points.push_back(c + w);
            m.colors.push_back(glm::mix(yarn.dark, yarn.light, smooth_step(-.9f, .6f, ply)));
        }
    }
    for (int j = 0; j < yarn.rows; j++)
        for (int i = 0; i < n; i++) {
            const int k = (i + 1) % n;
            m.faces.push_back({j * n + i, j * n + k, (j + 1) * n + k, (j + 1) * n + i});
        }
    for (const bool last : {false, true}) {
        const int o = int(m.points.size()), b = last ? yarn.rows * n : 0;
        m.points.push_back(yarn.path(last ? 1.f : 0.f));
        m.colors.push_back(yarn.dark);
        for (int i = 0; i < n; i++) {
            const int k = (i + 1) % n;
            m.faces.push_back(last ? Face{b + i, b + k, o, -1} : Face{b + k, b + i, o, -1});
        }
    }
    return m;
}

} // namespace

// Three strands, laid once round each other; copies at a distance of their size continue it.
Model tile_rope()
{
    Model m;
    const int a = m.material("hemp", vec3(1), .85f);
    constexpr float r = .098f, lay = .112f;
    for (int k = 0; k < 3; k++)
        m.root().parts.push_back(spun({[=](float t) {
                                           const float g = 2 * pi * (t + k / 3.f);
                                           return vec3(t, .5f + lay * std::cos(g),
                                                       r * 1.08f + lay + lay * std::sin(g));
                                       },
                                       r, 4, -3, 40, 16, srgb(0x6f5330), srgb(0xd9b877)})
                                     .mat(a));
    return m;
}

// A plait of three strands; copies at a distance of their size continue it.
Model tile_braid()
{
    Model m;
    const int a = m.material("plait", vec3(1), .6f);
    constexpr float r = .105f, wide = .215f, high = .075f;
    const vec3 dark[3] = {srgb(0x6a4213), srgb(0x7a5018), srgb(0x5c380f)},
               light[3] = {srgb(0xe0ad55), srgb(0xefc672), srgb(0xd09a45)};
    for (int k = 0; k < 3; k++)
        m.root().parts.push_back(spun({[=](float t) {
                                           const float g = 2 * pi * (t + k / 3.f);
                                           return vec3(t, .5f + wide * std::sin(g),
                                                       r * 1.12f + high + high * std::sin(2 * g));
                                       },
                                       r, 4, 1, 40, 16, dark[k], light[k]})
                                     .mat(a));
    return m;
}

// A lock of wavy hair; copies at a distance of their size continue it.
Model tile_lock()
{
    Model m;
    const int a = m.material("hair", vec3(1), .42f);
    constexpr int hairs = 13;
    for (int k = 0; k < hairs; k++) {
        // Hairs fill an ellipse, the outer ones lower; they wave together, and a little on their
        // own.
        const float g = k * 2.39996f, far = std::sqrt((k + .5f) / hairs),
                    y = .5f + .20f * far * std::cos(g), z = .135f + .085f * far * std::sin(g),
                    own = k * 1.7f, shade = .5f + .5f * noise(vec3(k * 2.7f, 1, 0));
        m.root().parts.push_back(
            spun({[=](float t) {
                      const float w = 2 * pi * t;
                      return vec3(
                          t, y + .035f * std::sin(w + .35f * own) + .022f * std::sin(2 * w + own),
                          z + .016f * std::cos(w + own));
                  },
                  .046f, 2, 1, 20, 8, glm::mix(srgb(0x7d5526), srgb(0xa8793c), shade),
                  glm::mix(srgb(0xd3a862), srgb(0xf3dba6), shade)})
                .mat(a));
    }
    return m;
}

// A stitch of a knitted row; copies at a distance of their size continue the row, and rows hook
// into each other at half of it.
Model tile_knit()
{
    Model m;
    const int a = m.material("wool", vec3(1), .9f);
    constexpr float r = .122f, high = .366f, deep = .095f;
    m.root().parts.push_back(spun({[=](float t) {
                                       const float g = 2 * pi * t;
                                       return vec3(t + .15f * std::sin(2 * g),
                                                   .5f + high * std::cos(g),
                                                   r * 1.1f + deep - deep * std::cos(2 * g));
                                   },
                                   r, 3, 6, 52, 12, srgb(0xb8b0a4), srgb(0xf6f1e7), false})
                                 .mat(a));
    return m;
}

} // namespace make
