// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model mechanical()
{
    Model m;
    int a = m.material("steel", srgb(0x8f99a3), .35f, .6f);
    auto f = [](vec3 p0) {
        vec3 p(std::abs(p0.x), p0.y, std::abs(p0.z));
        float d =
            prism(box({p.x, p.z, 0}, {0, 0, 0}, {.50f, .32f, 1}, .09f), p.y - .055f, .055f, .014f);
        float r = glm::length(vec2(p.x, p.z));
        d = smin(d, prism(r - .21f, p.y - .20f, .20f, .018f), .035f);
        d = smin(d,
                 prism(polygon({p.x, p.y},
                               {{0, .05f}, {.43f, .05f}, {.43f, .12f}, {.20f, .33f}, {0, .33f}}),
                       p.z, .034f, .010f),
                 .022f);
        d = smax(d, -(r - .125f), .016f);
        d = smax(d, -(smax(r - .160f, .345f - p.y, .004f)), .010f);
        d = smax(d, -(glm::length(vec2(p.x - .395f, p.z - .215f)) - .050f), .012f);
        d = smax(d, -smax(glm::length(vec2(p.x - .395f, p.z - .215f)) - .078f, .092f - p.y, .004f),
                 .008f);
        return Sample{d, vec3(1)};
    };
    Mesh k = surface(f, {-.52f, -.01f, -.34f}, {.52f, .42f, .34f}, {.0138f, true, 10});
    k.colors.clear();
    k.move({.5f, 0, 0});
    m.root().parts.push_back(k.mat(a));
    return m;
}

} // namespace make
