// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model book()
{
    Model m;
    int cover = m.material("cover", srgb(0x7a2f2a), .5f),
        page = m.material("pages", srgb(0xefe6cf), .9f),
        gold = m.material("gilt", srgb(0xd2a84a), .3f, .6f);
    auto& P = m.root().parts;
    auto pages = smooth_loop({{.035f, .020f},
                              {.30f, .020f},
                              {.60f, .020f},
                              {.705f, .022f},
                              {.690f, .055f},
                              {.686f, .085f},
                              {.690f, .115f},
                              {.705f, .148f},
                              {.60f, .150f},
                              {.30f, .150f},
                              {.035f, .150f},
                              {.018f, .115f},
                              {.014f, .085f},
                              {.018f, .055f}},
                             3);
    P.push_back(prism_mesh(pages, .470f, .002f, 16).mat(page));
    for (float y : {.010f, .160f})
        P.push_back(
            bevel_box({.360f, .010f, .500f}, .004f, 2, {14, 1, 18}).move({.372f, y, 0}).mat(cover));
    std::vector<vec2> spine;
    for (int i = 0; i <= 14; i++) {
        float a = glm::radians(mix(90, 270, i / 14.f));
        spine.push_back({.032f + .034f * std::cos(a), .085f + .085f * std::sin(a)});
    }
    for (int i = 14; i >= 0; i--) {
        float a = glm::radians(mix(90, 270, i / 14.f));
        spine.push_back({.036f + .018f * std::cos(a), .085f + .070f * std::sin(a)});
    }
    P.push_back(prism_mesh(spine, .500f, .003f, 18).mat(cover));
    for (float z : {-.30f, -.10f, .10f, .30f}) {
        std::vector<vec4> q;
        for (int i = 0; i <= 16; i++) {
            float a = glm::radians(mix(95, 265, i / 16.f));
            q.push_back({.032f + .033f * std::cos(a), .085f + .084f * std::sin(a), z, .0075f});
        }
        P.push_back(tube(q, 10).mat(cover));
    }
    for (float z : {-.40f, .40f})
        P.push_back(bevel_box({.30f, .0022f, .006f}, .0018f, 1, {8, 1, 1})
                        .move({.40f, .170f, z})
                        .mat(gold));
    for (float x : {.10f, .70f})
        P.push_back(
            bevel_box({.006f, .0022f, .40f}, .0018f, 1, {1, 1, 10}).move({x, .170f, 0}).mat(gold));
    return m;
}

} // namespace make
