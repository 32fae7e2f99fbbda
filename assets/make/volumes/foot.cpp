// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/foot_parts.h"
#include "assets/make/volumes/volumes.h"

namespace make {

Tissue foot_skin()
{
    Tissue out;
    const vec3 back(0, 1, 0);
    out.part().join(tube({{{4, 207, 16}, 21, 22},
                          {{4, 192, 22}, 27, 32},
                          {{2, 168, 36}, 31, 46},
                          {{0, 142, 34}, 33, 40},
                          {{0, 112, 28}, 37, 35},
                          {{0, 82, 20}, 42, 27},
                          {{-1, 58, 12}, 45, 20},
                          {{-2, 42, 9}, 42, 15}}));
    out.join(tube({{{1, 176, 165}, 33, 38},
                   {{1, 178, 130}, 30, 36},
                   {{1, 177, 105}, 29, 35},
                   {{0, 175, 84}, 33, 37},
                   {{0, 176, 60}, 33, 40}},
                  back),
             16);
    out.join(tube({{{2, 211, 120}, 7, 7}, {{2, 211, 80}, 8, 8}, {{3, 208, 45}, 12, 10}}, back),
             12); // Achilles
    out.join(blob({-24, 166, 74}, {8, 12, 12}), 8);
    out.join(blob({25, 173, 64}, {8, 12, 13}), 8);
    out.cut(blob({-46, 118, -16}, {34, 46, 30}), 16);                                  // the arch
    out.cut(solid({-60, -40, -30}, {60, 230, -7}, [](vec3 p) { return p.z + 8; }), 7); // the sole
    out.join(tube({{{-28, 44, 9}, 14, 13},
                   {{-29.5f, 14, 8}, 12.5f, 11.5f},
                   {{-30.5f, -4, 6.5f}, 13, 11.5f},
                   {{-30.5f, -15, 5}, 11.5f, 9}}),
             5);
    const auto toe = [&](vec3 from, vec3 bend, vec3 tip, float r) {
        out.join(tube({{from, r, r},
                       {bend, r * .92f, r * 1.02f},
                       {glm::mix(bend, tip, .7f), r, r * .95f},
                       {tip, r * .88f, r * .8f}}),
                 2.5f);
    };
    toe({-12, 40, 10}, {-13, 8, 11}, {-13.4f, -13, 2.5f}, 7.4f);
    toe({1, 42, 9}, {.8f, 12, 10}, {.8f, -7, 2}, 7);
    toe({13.5f, 46, 8}, {13.4f, 20, 9}, {13, 2, 1.6f}, 6.8f);
    toe({27, 52, 7}, {26, 30, 7.5f}, {24.4f, 13, 1}, 7);
    return out;
}

Phantom foot()
{
    return {"foot",
            {66, 160, 92},
            {-50, -27, -11},
            1.54f,
            {foot_bones(), foot_skin()},
            [](vec3 p, std::span<const float> d) {
                constexpr float soft = 3.1f;
                float v = mix(-1000, 40, inside(d[1], soft));
                v = mix(v, -90, inside(d[1] + 3, soft));
                v = mix(v, 50 + 8 * noise(p / 3.f), inside(d[1] + 8, 4));
                const float cancellous = 740 + 40 * noise(p / 2.7f);
                return mix(v, mix(1250, cancellous, inside(d[0] + 2.6f, soft)), inside(d[0], soft));
            },
            .8f};
}

} // namespace make
