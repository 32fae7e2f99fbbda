// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <cmath>

namespace make {

// A solid spur gear that lies flat, its axis up, with a groove in either face.
Model gear()
{
    constexpr int teeth = 18;
    constexpr float root = .405f, outer = .5f, half = .1f;
    std::vector<vec2> outline;
    for (int i = 0; i < teeth; i++)
        for (const vec2 corner :
             {vec2(-.30f, root), vec2(-.16f, outer), vec2(.16f, outer), vec2(.30f, root)}) {
            const float angle = 6.2831853f * (float(i) + corner.x) / teeth;
            outline.push_back(corner.y * vec2(std::cos(angle), std::sin(angle)));
        }
    auto f = [&](vec3 p) {
        const float r = glm::length(vec2(p.x, p.z));
        float d = prism(polygon({p.x, p.z}, outline), p.y - half, half, .016f);
        const float groove = smax(std::abs(r - .285f) - .055f, .07f - std::abs(p.y - half), .012f);
        return Sample{smax(d, -groove, .012f), vec3(1)};
    };
    Model m;
    const int steel = m.material("steel", srgb(0x8f99a3), .35f, .6f);
    Mesh k = surface(f, {-.53f, -.02f, -.53f}, {.53f, .22f, .53f}, {.0125f, true, 10});
    k.colors.clear();
    k.move({.5f, 0, 0});
    m.root().parts.push_back(k.mat(steel));
    return m;
}

} // namespace make
