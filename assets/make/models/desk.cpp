// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model desk()
{ // what lies around on Escher's table
    Model m;
    int oak = m.material("oak", srgb(0xa9794a), .6f),
        brass = m.material("brass", srgb(0xc7993f), .28f, .7f),
        perspex = m.material("set_square", srgb(0x9fc3b4), .15f),
        pot = m.material("pot", srgb(0xa85a38), .8f),
        green = m.material("cactus", srgb(0x5d8a4e), .7f),
        earth = m.material("earth", srgb(0x4a3527), 1),
        paper = m.material("paper", srgb(0xf1ecdd), .9f);
    int root = m.node("desk");
    m.nodes[root].parts.push_back(
        bevel_box({.80f, .020f, .55f}, .008f, 2, {24, 1, 16}).move({.5f, -.020f, 0}).mat(oak));
    m.nodes[root].parts.push_back(bevel_box({.34f, .0022f, .26f}, .0016f, 1, {16, 1, 12})
                                      .turn(8, {0, 1, 0})
                                      .move({.42f, .0022f, .05f})
                                      .mat(paper));
    int a = m.node("mortar", root, {1.02f, 0, .10f});
    m.nodes[a].parts.push_back(lathe(fillet({{0, 0},
                                             {.085f, 0},
                                             {.085f, .022f},
                                             {.048f, .045f},
                                             {.062f, .075f},
                                             {.095f, .155f},
                                             {.115f, .200f},
                                             {.098f, .200f},
                                             {.080f, .155f},
                                             {.045f, .075f},
                                             {0, .062f}},
                                            .010f, 4, false),
                                     56)
                                   .mat(brass));
    m.nodes[a].parts.push_back(tube(curve({{-.01f, .085f, .0f, .020f},
                                           {.02f, .15f, .0f, .013f},
                                           {.07f, .25f, .0f, .011f},
                                           {.085f, .285f, 0, .016f}},
                                          5),
                                    16)
                                   .mat(brass));
    int b = m.node("set_square", root, {.40f, .010f, -.36f});
    auto tri = fillet({{0, 0}, {.42f, 0}, {0, .26f}}, .004f, 3);
    Mesh sq = surface(
        [=](vec3 p) {
            float d = polygon({p.x, p.z}, tri),
                  hole =
                      polygon({p.x, p.z}, {{.055f, .050f}, {.235f, .050f}, {.055f, .160f}}) - .006f;
            return Sample{prism(std::max(d, -hole), p.y, .0065f, .003f), vec3(1)};
        },
        {0, -.01f, 0}, {.42f, .01f, .26f}, {.0052f, false, 6});
    sq.colors.clear();
    m.nodes[b].parts.push_back(sq.mat(perspex));
    int c = m.node("cactus", root, {-.12f, 0, -.30f});
    m.nodes[c].parts.push_back(lathe(fillet({{0, 0},
                                             {.070f, 0},
                                             {.095f, .135f},
                                             {.108f, .135f},
                                             {.110f, .170f},
                                             {.090f, .170f},
                                             {.086f, .140f},
                                             {0, .140f}},
                                            .008f, 4, false),
                                     48)
                                   .mat(pot));
    m.nodes[c].parts.push_back(
        cylinder(.086f, .086f, .02f, .006f, 40).move({0, .136f, 0}).mat(earth));
    Mesh cac = surface(
        [](vec3 p) {
            auto rib = [](vec3 q, float r) {
                return .0048f * r * 14.f * std::cos(10.f * std::atan2(q.z, q.x));
            };
            float d = capsule(p, {0, .14f, 0}, {0, .36f, 0}, .050f, .046f) + rib(p, .05f);
            vec3 q = p - vec3(.085f, 0, 0);
            d = smin(d, capsule(p, {.03f, .23f, 0}, {.085f, .245f, 0}, .022f, .024f), .02f);
            d = smin(d,
                     capsule(p, {.085f, .245f, 0}, {.085f, .325f, 0}, .025f, .024f) +
                         .5f * rib(q, .05f),
                     .015f);
            return Sample{d * .85f, srgb(0x6f9c58)};
        },
        {-.07f, .08f, -.07f}, {.13f, .43f, .07f}, {.0078f, true, 6});
    m.nodes[c].parts.push_back(cac.mat(green));
    m.nodes[c].parts.back().colors.clear();
    return m;
}

} // namespace make
