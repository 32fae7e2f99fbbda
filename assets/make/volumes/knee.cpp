// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/volumes.h"

// A left knee, a little bent at its cap. Millimetres; x to the outer side, y to the back, z up;
// the space of the joint is at z = 0.
namespace make {
namespace {

constexpr vec3 rearward{0, 1, 0};

// A wheel that is flat below and curls up behind, as condyles are.
Solid condyle(float x, float wide, float deep, float lean_deg)
{
    return joined({blob({x, 6, 25}, {wide, deep, 22}, lean_deg, {0, 0, 1}),
                   blob({x * 1.04f, 17, 23}, {wide * .96f, 16, 19}, lean_deg, {0, 0, 1}),
                   blob({x * .9f, -10, 27}, {wide * .92f, 17, 21}, lean_deg, {0, 0, 1})},
                  6);
}

Solid femur()
{
    const Solid shaft = tube({{{3, -3, 140}, 13.5f, 13.5f},
                              {{2, -3, 104}, 14, 14},
                              {{1, -2, 80}, 17, 15.5f},
                              {{0, -1, 60}, 25, 18},
                              {{0, 1, 44}, 33, 21},
                              {{0, 2, 32}, 36, 22}},
                             rearward);
    return joined({shaft, condyle(-22, 14.5f, 30, 6), condyle(22, 15, 30, -5),
                   blob({-36, 4, 36}, {6, 12, 13}), blob({36, 4, 33}, {5, 11, 11}), // epicondyles
                   blob({-31, 2, 48}, {6, 7, 8}), // adductor tubercle
                   blob({20, -17, 37}, {13, 10, 16}), blob({-18, -15, 36}, {12, 9, 14})},
                  8);
}

Solid tibia()
{
    const std::vector<vec2> heart{{-37, 2},  {-34, -14}, {-20, -21}, {0, -19}, {18, -20},
                                  {32, -13}, {36, 1},    {32, 15},   {19, 21}, {6, 16},
                                  {0, 13},   {-7, 17},   {-20, 24},  {-33, 17}};
    const Solid plateau = plate({0, 2, -12}, {1, 0, 0}, {0, 1, 0}, heart, 8.5f, 5);
    const Solid body = joined({plateau, tube({{{0, 3, -16}, 34, 20},
                                              {{0, 2, -28}, 29, 19},
                                              {{-1, 0, -44}, 20, 18},
                                              {{-2, -1, -66}, 14, 16},
                                              {{-2, 0, -100}, 12.5f, 15}},
                                             rearward)},
                              14);
    return joined({body, // with the tuberosity and the crest
                   tube({{{2, -17, -28}, 8, 5},
                         {{1, -20, -40}, 7, 6},
                         {{0, -16, -56}, 3, 4},
                         {{-1, -14, -84}, 2, 3}},
                        rearward),
                   blob({-4.5f, 2, -3.5f}, {3, 6, 6}),
                   blob({5, 3, -4}, {3, 5.5f, 5.5f}), // intercondylar eminence
                   blob({17, -18, -18}, {6, 4, 5})},  // Gerdy's tubercle
                  6);
}

Solid fibula()
{
    return joined({tube({{{35, 18, -24}, 6.5f, 8},
                         {{35, 18, -34}, 6.2f, 7},
                         {{33, 17, -48}, 4.6f, 5},
                         {{32, 16, -100}, 5, 6}},
                        rearward),
                   blob({37, 21, -19}, {4, 4.5f, 6})},
                  4);
}

Solid patella()
{
    const std::vector<vec2> shield{{-21, 8}, {-14, 17}, {0, 20},  {14, 17},   {21, 8},
                                   {19, -4}, {10, -15}, {0, -23}, {-10, -15}, {-19, -4}};
    return joined({plate({2, -45, 38}, {1, 0, 0}, {0, 0, 1}, shield, 6.5f, 6),
                   blob({2, -47, 39}, {17, 6.5f, 15}), blob({0, -41, 41}, {6, 6.5f, 13})},
                  5);
}

// Makes the cartilage on the part `where` of a bone's surface: a thickness that fades to its rim.
Solid coat(const Solid& bone, float thick, const Solid& where)
{
    const vec3 lo = glm::max(bone.lo - thick, where.lo), hi = glm::min(bone.hi + thick, where.hi);
    return {lo, hi, [=, b = bone.distance, w = where.distance](vec3 p) {
                return smax(b(p) - thick, w(p), 3);
            }};
}

Tissue bones()
{
    Tissue out;
    out.part().join(femur());
    out.cut(tube({{{0, 42, 2}, 9.5f, 12},
                  {{0, 26, 14}, 9.5f, 13},
                  {{0, 8, 10}, 8, 13},
                  {{0, -4, 0}, 6, 9}},
                 {0, 0, 1}),
            4); // intercondylar notch
    out.cut(
        tube({{{3, -36, 8}, 7.5f, 7}, {{3, -39, 34}, 9, 8.5f}, {{3, -35, 58}, 10, 8}}, rearward),
        7);                                      // groove of the patella
    out.cut(blob({0, 28, 62}, {22, 12, 24}), 9); // popliteal surface
    out.part().join(tibia());
    for (const float x : {-20.f, 20.f}) out.cut(blob({x, 2, 8.5f}, {15, 17, 14}), 3);
    out.part().join(fibula());
    out.cut(grown(tibia(), 2.4f), 1);
    out.part().join(patella());
    return out;
}

Tissue cartilages()
{
    Tissue out;
    out.part().join(coat(joined({condyle(-22, 14.5f, 30, 6), condyle(22, 15, 30, -5)}, 8), 2.6f,
                         blob({0, 4, 20}, {40, 42, 24})));
    out.cut(tube({{{0, 42, 2}, 8, 11}, {{0, 26, 14}, 8, 12}, {{0, 8, 10}, 7, 11}}, {0, 0, 1}), 4);
    for (const float side : {-1.f, 1.f}) { // menisci
        const float r = side < 0 ? 15.f : 14.f, start = side < 0 ? 3.6f : 3.9f;
        std::vector<Section> c;
        for (int i = 0; i <= 8; ++i) {
            const float a = -start / 2 * .75f * float(4 - i) / 2;
            c.push_back(
                {{side * (20 + r * std::cos(a)), 2 + 1.15f * r * std::sin(a), .6f}, 4.2f, 2.8f});
        }
        out.part().join(tube(c));
    }
    return out;
}

Tissue soft_parts()
{
    Tissue out;
    out.part().join(tube({{{2, -48, 58}, 13, 4}, {{2, -43, 84}, 14, 4}, {{2, -36, 130}, 20, 6}},
                         rearward)); // quadriceps' tendon
    out.part().join(tube({{{2, -46, 18}, 11, 3}, {{1, -36, -14}, 11, 3}, {{1, -25, -38}, 8, 3}},
                         rearward)); // patellar ligament
    out.part().join(tube({{{5, 12, 26}, 4, 4}, {{0, 0, 8}, 4, 3.6f}, {{-3, -10, -3}, 4, 4}},
                         rearward)); // cruciate ligaments
    out.part().join(
        tube({{{-7, 0, 20}, 4, 4}, {{-2, 12, 6}, 4, 4}, {{1, 20, -10}, 4, 4}}, rearward));
    out.part().join(
        tube({{{-40, 4, 38}, 2.4f, 6}, {{-40.5f, 3, 2}, 2, 6}, {{-32, 0, -36}, 2, 6}}, rearward));
    out.part().join(
        tube({{{40, 5, 34}, 2.2f, 3}, {{42, 12, 4}, 2.2f, 3}, {{38, 19, -18}, 2.2f, 3}}, rearward));
    return out;
}

} // namespace

Phantom knee()
{
    return {"knee",
            {86, 88, 140},
            {-50, -58, -66},
            1.18f,
            {bones(), cartilages(), soft_parts()},
            [](vec3 p, std::span<const float> d) {
                constexpr float soft = 2.4f;
                // Thick compact bone in the shafts, a thin shell over spongy bone near the joint.
                const float joint = smooth_step(62, 20, std::abs(p.z - 8));
                const float shell = mix(4.6f, .5f, joint);
                const float spongy = mix(60, 330 + 60 * noise(p / 2.4f), joint) +
                                     170 * joint * smooth_step(-3, -16, d[0]);
                const float compact = mix(1350, 620, joint);
                float v = mix(-60 + 6 * noise(p / 6.f), 95, inside(d[2], soft));
                v = mix(v, 165, inside(d[1], soft));
                return mix(v, mix(compact, spongy, inside(d[0] + shell + .5f, 2 + 2.4f * joint)),
                           inside(d[0], soft + 1.6f * joint));
            },
            .8f};
}

} // namespace make
