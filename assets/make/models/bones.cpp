// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/models/phantoms.h"

#include <algorithm>
#include <cmath>

namespace make {

Model bones_hand()
{
    Model m;
    int b = m.material("bone", srgb(0xe8dcc2), .5f);
    m.root().parts.push_back(plain(surface(
                                       [](vec3 p) {
                                           return Sample{hand_bone(p), vec3(1)};
                                       },
                                       {-.35f, -.05f, -.1f}, {.3f, .85f, .12f}, {.0062f, false, 6}),
                                   b));
    return m;
}

Model bones_jaw()
{
    Model m;
    int b = m.material("bone", srgb(0xe5d6b6), .5f), t = m.material("teeth", srgb(0xf7f3e8), .25f);
    m.root().parts.push_back(plain(surface(
                                       [](vec3 p) {
                                           return Sample{jaw_bone(p), vec3(1)};
                                       },
                                       {-.12f, -.03f, -.34f}, {.5f, .45f, .34f}, {.0105f, true, 6}),
                                   b));
    m.root().parts.push_back(plain(surface(
                                       [](vec3 p) {
                                           return Sample{jaw_teeth(p), vec3(1)};
                                       },
                                       {.1f, .1f, -.26f}, {.45f, .2f, .26f}, {.0065f, true, 6}),
                                   t));
    return m;
}

Model crystal()
{
    Model m;
    int b = m.material("density", srgb(0x5b8fc7), .3f);
    m.root().parts.push_back(plain(surface(
                                       [](vec3 p) {
                                           vec3 q = glm::abs(p - .5f) - .49f;
                                           return Sample{
                                               std::max(.03f * (.34f - crystal_density(p)) * 4.f,
                                                        std::max({q.x, q.y, q.z})),
                                               vec3(1)};
                                       },
                                       vec3(0), vec3(1), {.0165f, false, 3}),
                                   b));
    return m;
}

} // namespace make
