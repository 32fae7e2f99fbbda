// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/volumes.h"

// A neck from C3 to C7. Millimetres; x to the left, y to the back, z up; the bodies of the
// vertebrae stand on a gentle curve about y = 0.
namespace make {
namespace {

float spine_y(float z) // lordosis: the middle of the neck is forward
{
    return 3 - 4.5f * std::cos((z - 46) / 46);
}

void add_both(Tissue& out, const Solid& solid, float blend)
{
    out.join(solid, blend).join(mirrored(solid), blend);
}

void cut_both(Tissue& out, const Solid& solid, float blend)
{
    out.cut(solid, blend).cut(mirrored(solid), blend);
}

// An oval drum with a waist.
Solid vertebral_body(vec3 center, float size)
{
    const auto distance = [=](vec3 p) {
        const vec3 q = p - center;
        const float waist = 1 - .12f * smooth_step(6, 0, std::abs(q.z));
        const vec2 radii = size * waist * vec2(13, 8.6f);
        const float side = ellipsoid({q.x, q.y, 0}, vec3(0), {radii, 1e3f});
        const float dish = .8f * std::exp(-(q.x * q.x + 2 * q.y * q.y) / 60);
        return smax(side, std::abs(q.z) - 6.4f + dish, 2);
    };
    return solid(center - vec3(15, 11, 7), center + vec3(15, 11, 7), distance);
}

// The fifth of them, C7, has the long spine that one feels.
void add_vertebra(Tissue& out, int number)
{
    const float z = 82 - 18.f * float(number), y = spine_y(z), size = 1 + .03f * float(number);
    const auto at = [&](float dx, float dy, float dz) {
        return vec3(dx * size, y + dy * size, z + dz);
    };
    out.part().join(vertebral_body(at(0, 0, 0), size));
    add_both(out, tube({{at(11.4f, 4, 4), 2, 3.2f}, {at(12, 0, 7), 1.7f, 3.4f}}, {0, 1, 0}),
             3);                                                                // uncinate
    add_both(out, tube({{at(9, 7, 1), 3, 3.6f}, {at(17, 12, 0), 3.2f, 4}}), 3); // pedicle
    add_both(out, block(at(19.5f, 15.5f, 0), {5.8f, 6, 7}, 3, 28, {1, 0, 0}),
             2.5f); // the pillar with its facets
    add_both(out,
             tube({{at(11, -2, -1), 2.4f, 2.2f},
                   {at(19, -4, -2), 2.2f, 1.8f},
                   {at(24.5f, -3.5f, -3.2f), 2.6f, 2.4f}}),
             3);
    add_both(out,
             tube({{at(20, 10, -1), 2.6f, 2.2f},
                   {at(25, 4, -2.6f), 2.4f, 2},
                   {at(28.5f, .5f, -3.4f), 2.6f, 2.4f}}),
             3);
    add_both(out, tube({{at(24.5f, -3, -3.2f), 1.8f, 1.6f}, {at(28, .5f, -3.4f), 1.8f, 1.6f}}),
             2.5f);
    add_both(out,
             tube({{at(18, 17.5f, -1), 2.5f, 5.5f},
                   {at(10, 24, -1.5f), 2.2f, 5.6f},
                   {at(1, 28.5f, -2.5f), 2.6f, 5.4f}}),
             3); // lamina
    const float length = number == 4 ? 20 : number == 3 ? 15 : 11;
    const float drop = number == 4 ? 10 : 8;
    const bool forked = number < 4;
    out.join(tube({{at(0, 27, -2), 3, 5.4f},
                   {at(0, 27 + .5f * length, -3 - .5f * drop), 2.4f, 4},
                   {at(0, 27 + length, -3 - drop), forked ? 2.6f : 4, forked ? 3 : 4.6f}}),
             3);
    if (forked)
        add_both(out,
                 tube({{at(1, 24 + length, -2 - drop), 2.4f, 2.6f},
                       {at(5.2f, 29.5f + length, -4 - drop), 2.2f, 2.2f}}),
                 2);
    cut_both(out, tube({{at(19.6f, 3.2f, 12), 3, 2.8f}, {at(19.6f, 3, -12), 3, 2.8f}}, {0, 1, 0}),
             1); // for the artery
    out.cut(tube({{at(0, 16.2f, 14), 11, 7.6f}, {at(0, 16.2f, -14), 11, 7.6f}}, {0, 1, 0}),
            2); // for the cord
}

Tissue spine()
{
    Tissue out;
    for (int number = 0; number < 5; ++number) add_vertebra(out, number);
    // the hyoid bone
    out.part();
    out.join(tube({{{-20, -20, 96}, 1.8f, 2},
                   {{-15, -34, 91}, 2, 2.4f},
                   {{0, -41, 89}, 2.6f, 4.2f},
                   {{15, -34, 91}, 2, 2.4f},
                   {{20, -20, 96}, 1.8f, 2}}));
    return out;
}

constexpr float ring_distance = 5.6f;

Tissue cartilage() // of the larynx and of the trachea: rings that are open behind
{
    Tissue out;
    for (int i = 0; i < 6; ++i) {
        const float z = 5 + ring_distance * float(i), y = -26 - .05f * z;
        out.part().join(tube({{{-7.6f, y + 8.4f, z + .4f}, 1.9f, 2},
                              {{-10.6f, y, z}, 1.9f, 2.1f},
                              {{-7.4f, y - 8, z}, 1.9f, 2.1f},
                              {{0, y - 11, z}, 1.9f, 2.2f},
                              {{7.4f, y - 8, z}, 1.9f, 2.1f},
                              {{10.6f, y, z}, 1.9f, 2.1f},
                              {{7.6f, y + 8.4f, z + .4f}, 1.9f, 2}}));
    }
    out.part().join(ring({0, -28, 43}, glm::normalize(vec3(0, .3f, 1)), 11.5f, 2.6f)); // cricoid
    out.join(blob({0, -17, 47}, {8, 3, 7}), 3);
    out.part(); // thyroid: two plates that meet in front at the notch
    for (const float side : {1.f, -1.f})
        out.join(plate({side * 9.5f, -33, 64}, glm::normalize(vec3(side * .62f, .78f, 0)),
                       {0, 0, 1},
                       {{-15, 3},
                        {-13, 9},
                        {-5, 12},
                        {6, 11},
                        {13, 20},
                        {15, 19},
                        {13.4f, 6},
                        {13, -12},
                        {14, -19},
                        {11.6f, -18},
                        {8, -11},
                        {-5, -10.5f},
                        {-13, -10}},
                       2.1f, 1.9f),
                 2);
    return out;
}

Tissue vessels()
{
    Tissue out;
    const auto both = [&](const std::vector<Section>& s) {
        add_both(out.part(), tube(s, {0, 1, 0}), 0);
    };
    both({{{17, -22, -8}, 3.8f, 3.8f},
          {{21, -19, 30}, 3.7f, 3.7f},
          {{24.5f, -16.5f, 58}, 4.6f, 4.4f},
          {{26, -13, 66}, 4.4f, 4.4f},
          {{25.5f, -8, 80}, 3, 3},
          {{25, -5, 100}, 2.8f, 2.8f}});
    for (const Solid& outer :
         {tube({{{25.5f, -18, 63}, 3, 3}, {{24, -23, 72}, 2.3f, 2.3f}, {{25, -25, 100}, 2, 2}},
               {0, 1, 0})})
        add_both(out, outer, 2);
    both({{{26, -23, -8}, 6.6f, 5.2f},
          {{30, -19, 28}, 6.2f, 5},
          {{33.5f, -13, 60}, 5.6f, 4.8f},
          {{33, -6, 100}, 5, 4.6f}});
    both({{{21.8f, 6, -8}, 1.9f, 1.9f},
          {{20.6f, 2.4f, 12}, 1.9f, 1.9f},
          {{20, 1.2f, 46}, 1.9f, 1.9f},
          {{20, 2.5f, 100}, 1.9f, 1.9f}});
    return out;
}

Tissue muscles()
{
    Tissue out;
    const auto both = [&](const std::vector<Section>& s, vec3 up = {0, 1, 0}) {
        add_both(out.part(), tube(s, up), 0);
    };
    both({{{14, -40, -12}, 8, 4},
          {{24, -35, 14}, 9, 5.4f},
          {{38, -20, 48}, 7.5f, 9.5f},
          {{47, 0, 84}, 5.5f, 11},
          {{49, 8, 104}, 5, 11}}); // sternocleidomastoid
    both({{{56, 38, -14}, 16, 8},
          {{44, 42, 14}, 14, 7},
          {{28, 45, 48}, 11, 6},
          {{17, 46, 84}, 9, 5.5f},
          {{13, 45, 104}, 8.5f, 5}}); // trapezius
    both({{{22, 36, -12}, 12, 7},
          {{21, 36, 30}, 12, 7.4f},
          {{21, 34, 70}, 13, 7.4f},
          {{22, 34, 104}, 12, 7}}); // splenius, semispinalis
    both({{{9, 30, -12}, 6, 7},
          {{9, 29.5f, 30}, 6, 7},
          {{9.5f, 27, 70}, 6.5f, 7},
          {{10, 28, 104}, 6.5f, 7}});
    both({{{42, 12, -12}, 8, 8},
          {{36, 12, 20}, 7, 8},
          {{32.5f, 12, 56}, 5.4f, 7.4f},
          {{33, 16, 104}, 6, 7}}); // scalenes, levator
    both({{{9, -11, -12}, 6, 3},
          {{9, -13.5f, 40}, 6.4f, 3},
          {{9, -12, 104}, 6, 3.2f}}); // longus colli
    both({{{7, -42, -10}, 7, 2.6f},
          {{8.5f, -45.5f, 30}, 7, 2.4f},
          {{9, -49, 64}, 6, 2.4f},
          {{7, -45, 88}, 5.4f, 2.4f}}); // sternohyoid
    out.part().join(tube({{{0, -13.5f, -12}, 8, 3.6f},
                          {{0, -15, 40}, 8, 3.6f},
                          {{0, -19, 80}, 13, 5},
                          {{0, -20, 104}, 15, 6}},
                         {0, 1, 0})); // oesophagus
    out.part();
    add_both(
        out,
        tube({{{14, -30, 10}, 5, 5.5f}, {{16.5f, -29, 26}, 6.5f, 8.5f}, {{15.5f, -30, 46}, 4, 5}},
             {0, 1, 0}),
        3); // thyroid gland
    out.join(tube({{{-12, -39.5f, 18}, 4, 3}, {{0, -41, 18}, 4, 2.6f}, {{12, -39.5f, 18}, 4, 3}}),
             4);
    return out;
}

Tissue airway()
{
    Tissue out;
    out.part().join(tube({{{0, -25.5f, -14}, 8.8f, 8.4f},
                          {{0, -28, 30}, 8.8f, 8.6f},
                          {{0, -29, 46}, 7.6f, 8.4f},
                          {{0, -32, 60}, 3.6f, 9},
                          {{0, -33, 68}, 6.5f, 9},
                          {{0, -27, 84}, 12, 6.5f},
                          {{0, -25, 104}, 14, 7}},
                         {0, 1, 0}));
    return out;
}

Tissue neck_skin()
{
    Tissue out;
    out.part().join(tube({{{0, 6, -40}, 74, 62},
                          {{0, 6, -12}, 64, 56},
                          {{0, 3, 14}, 57, 54},
                          {{0, 1, 48}, 54.5f, 54},
                          {{0, 2, 84}, 57, 56},
                          {{0, 2, 130}, 62, 62}},
                         {0, 1, 0}));
    out.join(blob({0, -46, 67}, {7, 8.5f, 9}), 10); // Adam's apple
    add_both(out,
             tube({{{15, -43, -12}, 8, 7},
                   {{27, -36, 14}, 9, 8},
                   {{42, -22, 48}, 8, 9},
                   {{50, 0, 84}, 8, 9}},
                  {0, 1, 0}),
             9);
    out.cut(blob({0, -62, -9}, {10, 12, 14}), 12); // jugular notch
    return out;
}

} // namespace

Phantom neck()
{
    return {"neck",
            {122, 116, 98},
            {-66, -62, -8},
            1.1f,
            {neck_skin(), muscles(), vessels(), cartilage(), spine(), airway()},
            [](vec3 p, std::span<const float> d) {
                constexpr float soft = 2.6f;
                float v = mix(-1000, -70, inside(d[0], soft));
                v = mix(v, -100 + 8 * noise(p / 5.f), inside(d[0] + 2.4f, soft));
                v = mix(v, 62 + 8 * noise(p / vec3(3, 3, 12)),
                        inside(std::max(d[1], d[0] + 3.4f), soft)); // none beyond the skin
                v = mix(v, 190, inside(d[2], soft));
                v = mix(v, 185, inside(d[3], soft));
                v = mix(v, mix(1150, 480 + 50 * noise(p / 2.f), inside(d[4] + 2.4f, soft)),
                        inside(d[4], soft));
                return mix(v, -1000, inside(d[5], soft));
            },
            .9f};
}

} // namespace make
