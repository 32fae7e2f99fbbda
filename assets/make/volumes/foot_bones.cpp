// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/foot_parts.h"

namespace make {
namespace {

constexpr float joint_space = 3; // space between two bones

// A bone with the space of the joints to its neighbours taken off.
void add(Tissue& out, const Solid& bone, const std::vector<Solid>& neighbours,
         float space = joint_space)
{
    out.part().join(bone);
    for (const Solid& each : neighbours) out.cut(grown(each, space), 1.2f);
}

Solid calcaneus()
{
    return joined({tube({{{2, 207, 19}, 12, 17},
                         {{3, 199, 21}, 13.5f, 20},
                         {{5, 184, 26}, 11, 16.5f},
                         {{8, 166, 31}, 12, 15},
                         {{13, 150, 31}, 12, 13},
                         {{15.5f, 143, 31}, 11, 11.5f}}),
                   blob({-9, 163, 45}, {13, 9, 5}, -8, {0, 1, 0}),  // sustentaculum tali
                   blob({5, 172, 44}, {11, 13, 8}, -28, {1, 0, 0}), // posterior facet
                   blob({-4, 204, 5}, {6.5f, 8, 4.5f}),             // medial process
                   blob({9, 205, 6}, {4.5f, 6, 4}),
                   blob({18, 158, 26}, {2.5f, 4, 3})}, // peroneal trochlea
                  5);
}

Solid talus()
{
    const auto trochlea = [](vec3 p) {
        const vec3 q = p - vec3(-2, 170, 58);
        const float pulley =
            std::sqrt(q.y * q.y + q.z * q.z) - 20 + 1.6f * std::exp(-q.x * q.x / 40) - .05f * q.x;
        const float side = std::abs(q.x) - (14.5f - .09f * q.y * .5f);
        return smax(smax(pulley, side, 4), -q.z - 5, 5);
    };
    return joined(
        {solid({-18, 149, 50}, {14, 191, 80}, trochlea),
         tube({{{-4, 162, 57}, 13, 9}, {{-9, 148, 54}, 11, 9}, {{-13, 138, 50}, 12, 10.5f}}),
         blob({-14, 134, 49}, {13, 9.5f, 11}, -15, {0, 0, 1}),
         blob({11, 167, 55}, {6.5f, 8, 6}, 20, {0, 1, 0}), // lateral process
         blob({-3, 190, 54}, {8, 7, 5}), blob({-4, 172, 50}, {14, 15, 8})},
        4);
}

struct Metatarsal {
    std::vector<Section> shaft;
    vec3 head, head_radii;
};

std::vector<Metatarsal> metatarsals()
{
    return {{{{{-20, 98, 37}, 8.5f, 14},
              {{-20.5f, 90, 34}, 7.5f, 11.5f},
              {{-23, 72, 26.5f}, 6, 7},
              {{-26, 56, 18.5f}, 6.8f, 7},
              {{-28, 46, 14.5f}, 8.5f, 8.5f}},
             {-28.5f, 42, 13},
             {10.5f, 9.5f, 9.8f}},
            {{{{-7.5f, 106, 44}, 6.3f, 9.5f},
              {{-8, 98, 41.5f}, 5, 7},
              {{-10, 74, 30.5f}, 3.7f, 4.3f},
              {{-11.5f, 54, 20.5f}, 3.9f, 4.6f},
              {{-12, 44, 15.5f}, 4.8f, 6}},
             {-12.2f, 39.5f, 13.5f},
             {5.8f, 6.5f, 7.4f}},
            {{{{4, 106, 40}, 6, 9.5f},
              {{3.7f, 97, 37}, 4.6f, 6.5f},
              {{2.8f, 74, 27}, 3.5f, 4.1f},
              {{2, 57, 19}, 3.7f, 4.3f},
              {{1.6f, 47, 14.5f}, 4.6f, 5.6f}},
             {1.4f, 42.5f, 12.8f},
             {5.5f, 6.2f, 7}},
            {{{{13.5f, 107, 33}, 5.8f, 8.5f},
              {{14, 98, 30.5f}, 4.5f, 5.6f},
              {{14.3f, 76, 22.5f}, 3.4f, 3.9f},
              {{14, 61, 16.5f}, 3.6f, 4.1f},
              {{13.8f, 53, 13}, 4.4f, 5.2f}},
             {13.7f, 48.5f, 11.8f},
             {5.3f, 6, 6.5f}},
            {{{{25, 109, 24}, 7.5f, 6.6f},
              {{25, 99, 22}, 5.6f, 5},
              {{26, 80, 16.5f}, 3.9f, 3.6f},
              {{26.5f, 67, 12.5f}, 3.9f, 3.8f},
              {{26.5f, 59, 10.8f}, 4.6f, 5}},
             {26.5f, 55, 10.3f},
             {5.4f, 5.8f, 6}}};
}

// Makes a bone from its base to its head, waisted between.
Solid phalanx(vec3 base, vec3 head, float wide, float high, float taper)
{
    return tube({{base, wide, high},
                 {glm::mix(base, head, .22f), wide * .74f, high * .8f},
                 {glm::mix(base, head, .6f), wide * .58f * taper, high * .62f * taper},
                 {glm::mix(base, head, .85f), wide * .78f * taper, high * .7f * taper},
                 {head, wide * .8f * taper, high * .66f * taper}});
}

void add_toe(Tissue& out, vec3 base, float drift, float proximal, float middle, float distal,
             float r)
{
    const vec3 a = base + vec3(drift * .5f, -proximal, .2f);
    const vec3 b = a + vec3(0, -4.2f, -1.1f), c = b + vec3(drift * .2f, -middle, -2.2f);
    const vec3 d = c + vec3(0, -4, -1.3f), e = d + vec3(0, -distal, -1.9f);
    add(out, phalanx(base, a, r, r * .92f, .92f), {});
    add(out, phalanx(b, c, r * .8f, r * .7f, 1.05f), {});
    add(out, phalanx(d, e, r * .74f, r * .58f, .85f), {});
}

} // namespace

Tissue foot_bones()
{
    Tissue out;
    const Solid heel = calcaneus(), ankle = talus();
    add(out, heel, {});
    add(out, ankle, {heel}, 3.2f);
    const Solid navicular = joined({blob({-15, 125, 48}, {18.5f, 8.5f, 13}, -10, {0, 0, 1}),
                                    blob({-31, 126, 41}, {6.5f, 7.5f, 7})},
                                   4);
    add(out, navicular, {ankle});
    const Solid cuboid = joined(
        {block({16, 126, 29}, {11.5f, 16, 11.5f}, 6, -8), blob({13, 134, 22}, {8, 7, 6})}, 4);
    add(out, cuboid, {heel, navicular});
    const Solid medial = block({-21.5f, 108, 40}, {8, 12.5f, 15}, 5.5f, 14, {0, 1, 0}),
                intermediate = block({-8, 111, 49}, {7.2f, 9, 9.5f}, 4.5f),
                lateral = block({4, 112, 43.5f}, {6.6f, 10.5f, 11}, 4.5f, -10, {0, 1, 0});
    add(out, medial, {navicular}, 2.8f);
    add(out, intermediate, {navicular, medial}, 2.7f);
    add(out, lateral, {navicular, intermediate, cuboid}, 2.7f);
    std::vector<Solid> before{medial, intermediate, lateral, cuboid};
    for (const Metatarsal& m : metatarsals()) {
        std::vector<Solid> pieces{tube(m.shaft), blob(m.head, m.head_radii, 0)};
        if (m.head.x > 20)
            pieces.push_back(tube({{{28, 107, 22}, 4.5f, 4.5f}, {{33.5f, 117, 18}, 3.2f, 3.4f}}));
        const Solid bone = joined(pieces, 3);
        add(out, bone, before, 2.7f);
        before.push_back(tube({m.shaft[0], m.shaft[1]}));
    }
    for (const float x : {-33.6f, -24.2f})
        out.part().join(blob({x, 45, 1.2f}, {3.8f, 5.2f, 3})); // sesamoids
    add(out, phalanx({-29, 26, 12.5f}, {-29.6f, 4, 11.5f}, 9.2f, 7.6f, 1), {});
    add(out,
        joined({phalanx({-29.8f, -4, 10.8f}, {-30.2f, -16, 9}, 8.4f, 5.4f, .85f),
                blob({-30.3f, -18, 8.4f}, {6.2f, 3, 2.6f})},
               2),
        {});
    add_toe(out, {-12.4f, 28, 13.2f}, -1, 19.5f, 6.5f, 5.5f, 5.3f);
    add_toe(out, {1.2f, 31.5f, 12.5f}, -.4f, 18.5f, 6, 5, 5);
    add_toe(out, {13.5f, 38, 11.4f}, -.8f, 17.5f, 5, 5, 4.8f);
    add_toe(out, {26.4f, 44.5f, 10}, -2, 16.5f, 4, 4.6f, 4.6f);
    const Solid tibia = joined(
        {tube({{{-6, 172, 145}, 12, 12.5f},
               {{-5.5f, 171, 118}, 12.5f, 13},
               {{-4.5f, 170, 102}, 15.5f, 15.5f},
               {{-3, 169, 90}, 21, 19.5f},
               {{-3, 169, 80}, 21.5f, 20}},
              {0, 1, 0}),
         tube({{{-19, 167, 90}, 8, 11}, {{-21, 165, 74}, 5.6f, 10}, {{-21, 166, 64}, 4, 6.5f}},
              {0, 1, 0})},
        4);
    add(out, tibia, {ankle}, 3.4f);
    add(out,
        tube({{{19, 177, 145}, 6, 7},
              {{19.5f, 177, 105}, 5.6f, 6.6f},
              {{21, 175, 84}, 7.4f, 9.5f},
              {{21.5f, 172, 66}, 6.8f, 10},
              {{20.5f, 174, 52}, 4.2f, 6}},
             {0, 1, 0}),
        {ankle, tibia});
    return out;
}

} // namespace make
