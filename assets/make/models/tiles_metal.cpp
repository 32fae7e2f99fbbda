// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

// Rings of one outline about (1/2, 1/2), each (scale, z), from the rim of the floor to a top point.
Mesh stacked(const std::vector<vec2>& outline, const std::vector<vec2>& steps, float top)
{
    Mesh m;
    const int n = int(outline.size()), rows = int(steps.size());
    for (const vec2& step : steps)
        for (const vec2& q : outline) m.points.push_back({vec2(.5f) + q * step.x, step.y});
    const int tip = int(m.points.size());
    m.points.push_back({.5f, .5f, top});
    m.points.push_back({.5f, .5f, 0});
    for (int i = 0; i < n; i++) {
        const int k = (i + 1) % n;
        for (int j = 0; j + 1 < rows; j++)
            m.faces.push_back({j * n + i, j * n + k, (j + 1) * n + k, (j + 1) * n + i});
        m.faces.push_back({(rows - 1) * n + i, (rows - 1) * n + k, tip, -1});
        m.faces.push_back({k, i, tip + 1, -1});
    }
    return m;
}

} // namespace

// A pyramid of brass as on leather: a flange, four facets and a small table.
Model tile_stud()
{
    Model m;
    const int a = m.material("brass", srgb(0xd8b15a), .22f, .85f);
    std::vector<vec2> square = fillet({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, .16f, 5), outline;
    for (size_t i = 0; i < square.size(); i++) { // with points along its sides, for bending
        const vec2 p = square[i], q = square[(i + 1) % square.size()];
        const int parts = std::max(1, int(glm::distance(p, q) / .25f));
        for (int k = 0; k < parts; k++) outline.push_back(glm::mix(p, q, float(k) / parts));
    }
    m.root().parts.push_back(stacked(outline,
                                     {{.478f, 0},
                                      {.490f, .012f},
                                      {.490f, .050f},
                                      {.478f, .062f},
                                      {.418f, .068f},
                                      {.404f, .074f},
                                      {.400f, .092f},
                                      {.388f, .112f},
                                      {.380f, .122f},
                                      {.30f, .198f},
                                      {.22f, .274f},
                                      {.14f, .350f},
                                      {.132f, .357f},
                                      {.118f, .364f},
                                      {.06f, .366f}},
                                     .366f)
                                 .mat(a));
    return m;
}

// A hammered head of steel on its washer.
Model tile_rivet()
{
    Model m;
    const int a = m.material("steel", vec3(.86f), .32f, .8f);
    std::vector<vec2> circle;
    for (int i = 0; i < 36; i++)
        circle.push_back({std::cos(2 * pi * i / 36), std::sin(2 * pi * i / 36)});
    std::vector<vec2> steps{{.478f, 0},     {.490f, .012f}, {.490f, .044f},
                            {.478f, .056f}, {.420f, .060f}, {.384f, .060f},
                            {.366f, .052f}, {.360f, .060f}, {.372f, .086f}};
    for (int i = 1; i < 12; i++) {
        const float g = pi / 2 * i / 12;
        steps.push_back({.374f * std::cos(g), .086f + .262f * std::sin(g)});
    }
    Mesh k = stacked(circle, steps, .348f);
    for (vec3& p : k.points)
        if (p.z > .10f) { // struck from above and round it
            const vec3 dents[] = {{.40f, .56f, .0f}, {.60f, .47f, 0}, {.47f, .36f, 0},
                                  {.30f, .42f, .0f}, {.55f, .66f, 0}, {.70f, .60f, 0}};
            for (const vec3& dent : dents)
                p.z -= .016f * smooth_step(.115f, .02f, glm::distance(vec2(p), vec2(dent)));
        }
    k.paint([](vec3 p) {
        const float r = glm::distance(vec2(p), vec2(.5f));
        const float seam =
                        smooth_step(.05f, .0f, std::abs(r - .372f)) * smooth_step(.10f, .05f, p.z),
                    rust = saturate(noise(p * 9.f) * .9f) * smooth_step(.2f, .05f, p.z);
        vec3 c =
            glm::mix(vec3(.80f, .82f, .84f), vec3(.92f, .93f, .94f), smooth_step(.1f, .34f, p.z));
        c = glm::mix(c, srgb(0x6b4630), .55f * rust);
        return glm::mix(c, srgb(0x2b2622), .85f * seam);
    });
    m.root().parts.push_back(k.mat(a));
    return m;
}

} // namespace make
