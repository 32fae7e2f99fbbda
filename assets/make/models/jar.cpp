// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

// Terracotta with a painted band: a wave between dotted borders, rings at foot and shoulder.
vec3 glaze(vec3 p)
{
    const vec3 terra = srgb(0xb5623a), cream = srgb(0xead9b4), blue = srgb(0x27496b),
               ochre = srgb(0xd29a3f);
    const float angle = std::atan2(p.z, p.x);
    const Curve outer({{0, .15f},
                       {.1f, .215f},
                       {.3f, .3f},
                       {.5f, .345f},
                       {.66f, .325f},
                       {.79f, .24f},
                       {.86f, .165f},
                       {.905f, .15f},
                       {.955f, .165f},
                       {1, .2f}});
    const bool outside = glm::length(vec2(p.x, p.z)) > outer(p.y) - .012f;
    vec3 c = terra * (1 + .05f * noise(p * 40.f));
    if (outside) {
        const float band = std::abs(p.y - .50f);
        const auto line = [&](float at, float half, vec3 color) {
            c = glm::mix(c, color, smooth_step(half + .003f, half, std::abs(band - at)));
        };
        c = glm::mix(c, cream, smooth_step(.137f, .134f, band));
        line(.130f, .006f, blue);
        line(.098f, .0025f, blue);
        const float dots = angle * 60 / (2 * pi), dot = (dots - std::round(dots)) * .036f;
        c = glm::mix(c, ochre, smooth_step(.0095f, .0075f, glm::length(vec2(dot, band - .114f))));
        for (const float side : {0.f, pi}) {
            const float wave = p.y - .50f - .052f * std::sin(angle * 9 + side);
            c = glm::mix(c, side == 0 ? blue : ochre, smooth_step(.0135f, .0105f, std::abs(wave)));
        }
        for (const float ring : {.22f, .245f, .775f, .80f}) {
            c = glm::mix(c, blue, smooth_step(.0065f, .0045f, std::abs(p.y - ring)));
        }
    }
    return glm::mix(c, cream, smooth_step(.972f, .985f, p.y));
}

} // namespace

Model jar()
{
    Model m;
    int clay = m.material("glaze", vec3(1), .28f), cord = m.material("handle", srgb(0x8a4a2e), .5f);
    std::vector<vec2> out = smooth_loop({{.150f, .0f},
                                         {.172f, .012f},
                                         {.215f, .10f},
                                         {.300f, .30f},
                                         {.345f, .50f},
                                         {.325f, .66f},
                                         {.240f, .79f},
                                         {.165f, .86f},
                                         {.150f, .905f},
                                         {.165f, .955f},
                                         {.200f, .985f},
                                         {.205f, .998f},
                                         {.190f, 1.002f}},
                                        11, false),
                      in = smooth_loop({{.178f, .990f},
                                        {.148f, .955f},
                                        {.130f, .905f},
                                        {.145f, .855f},
                                        {.220f, .775f},
                                        {.303f, .655f},
                                        {.322f, .50f},
                                        {.277f, .30f},
                                        {.195f, .11f},
                                        {.140f, .035f},
                                        {.0f, .030f}},
                                       5, false);
    std::vector<vec2> prof{{0, 0}, {.08f, 0}};
    prof.insert(prof.end(), out.begin(), out.end());
    prof.insert(prof.end(), in.begin(), in.end());
    Mesh j = lathe(prof, 76);
    m.materials[std::size_t(clay)].texture = bake(j, {768, 768}, glaze);
    auto& P = m.root().parts;
    P.push_back(j.mat(clay));
    for (float s : {1.f, -1.f}) {
        Mesh h = tube(curve({{s * .150f, .885f, 0, .020f},
                             {s * .235f, .925f, 0, .021f},
                             {s * .320f, .885f, 0, .022f},
                             {s * .345f, .79f, 0, .023f},
                             {s * .290f, .705f, 0, .024f}},
                            7),
                      16);
        P.push_back(h.mat(cord));
    }
    return m;
}

} // namespace make
