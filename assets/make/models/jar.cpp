// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

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
    j.paint([](vec3 p) {
        float r = glm::length(vec2(p.x, p.z));
        vec3 terra = srgb(0xb5623a), cream = srgb(0xead9b4), blue = srgb(0x2f4f6e);
        float a = std::atan2(p.z, p.x);
        vec3 c = terra;
        float band = std::abs(p.y - .50f);
        c = glm::mix(c, cream, smooth_step(.135f, .125f, band));
        float wave = std::abs(p.y - .50f - .055f * std::sin(a * 9.f));
        c = glm::mix(c, blue, smooth_step(.040f, .010f, wave));
        c = glm::mix(c, blue, smooth_step(.012f, .007f, std::abs(band - .125f)));
        c = glm::mix(c, blue, smooth_step(.010f, .006f, std::abs(p.y - .80f)) * (r > .2f));
        c = glm::mix(c, cream, smooth_step(.972f, .985f, p.y));
        return c;
    });
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
