// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/loft.h"
#include "assets/make/outline.h"
#include "assets/make/volumes/jaw_parts.h"
#include "assets/make/volumes/volumes.h"

#include <memory>

namespace make {
namespace {

// Seen from the side: length along the arch, and height.
std::vector<vec2> side_view()
{
    return smooth_loop(
        {{-20, 31.5f}, {-8, 31.5f},     {0, 31.5f},      {12, 31.5f},    {24, 30.8f},
         {40, 29.8f},  {56, 29},        {64, 28.8f},     {68.5f, 31},    {72.5f, 38},
         {76, 46.5f},  {79, 55},        {81.2f, 61},     {83.6f, 63.5f}, {86.5f, 61.5f},
         {89.5f, 55},  {94, 49},        {99, 48},        {104, 51.5f},   {108, 57.5f},
         {111, 62},    {114.8f, 63.6f}, {118.2f, 61.2f}, {118.2f, 56},   {116.4f, 49},
         {114.8f, 40}, {112.5f, 29},    {109.5f, 18},    {104.5f, 9},    {97, 3},
         {88, 1.2f},   {78, 3.2f},      {66, 2.6f},      {50, 1},        {35, .6f},
         {22, -.4f},   {10, -.6f},      {0, 0},          {-10, -.6f},    {-20, -.4f}},
        3);
}

struct MandibleBone {
    JawArch arch;
    std::vector<vec2> side = side_view();
    Curve half{{{-25, 5.6f},
                {0, 5.9f},
                {15, 5.4f},
                {30, 5.6f},
                {48, 6.6f},
                {62, 6.4f},
                {74, 4.6f},
                {88, 3.4f},
                {104, 3.6f},
                {125, 3.4f}}};

    float thickness(float s, float z) const
    {
        float w = half(s);
        const float body = smooth_step(74, 60, s);
        w += body *
             (.7f * smooth_step(12, 4, z) - .5f * smooth_step(8, 16, z) * smooth_step(26, 18, z));
        w += body * .5f * over_roots(s) * smooth_step(14, 26, z); // juga of the roots
        w -= 1.1f * smooth_step(44, 58, z) * smooth_step(98, 88, s);
        return w;
    }
    float middle(float s, float z) const
    {
        const float front = smooth_step(26, 6, s),
                    back = smooth_step(34, 60, s) * smooth_step(78, 64, s);
        float o = front * (1.8f * smooth_step(12, 3, z) -
                           1.3f * smooth_step(8, 17, z) * smooth_step(29, 20, z));
        o -= back * 3.2f * smooth_step(6, 28, z); // molars stand on the inner side
        o += 2.2f * smooth_step(80, 98, s) * smooth_step(22, 4, z); // the angle flares
        o -= 1.2f * smooth_step(80, 95, s) * smooth_step(10, 24, z) * smooth_step(46, 30, z);
        o += 2.f * smooth_step(100, 116, s) * smooth_step(40, 62, z);
        return o;
    }
    float operator()(vec3 p) const
    {
        const vec2 at = arch.unrolled({std::abs(p.x), p.y});
        if (std::abs(at.y) > 22) return std::abs(at.y) - 12; // far from it
        const float w = thickness(at.x, p.z);
        return prism(polygon({at.x, p.z}, side), at.y - middle(at.x, p.z), w, .96f * w);
    }
};

Tissue mandible(const std::shared_ptr<MandibleBone>& bone)
{
    const JawArch& arch = bone->arch;
    Tissue out;
    out.part().join(solid({-60, -4, -2}, {60, 118, 66}, [bone](vec3 p) { return (*bone)(p); }));
    const auto both = [&](const Solid& s, float blend, bool cuts = false) {
        for (const Solid& side : {s, mirrored(s)})
            cuts ? out.cut(side, blend) : out.join(side, blend);
    };
    out.join(blob({0, 2, 6.5f}, {7, 4.6f, 6.5f}), 6); // mental protuberance
    both(blob({11, 4.4f, 3.6f}, {5, 3.6f, 3.4f}, 30), 4);
    both(blob({2, 12.6f, 9}, {1.6f, 2, 2.2f}), 2);  // genial tubercles
    both(tube({{arch.at(76, 2.5f, 38), 2.2f, 2.2f}, // oblique line
               {arch.at(66, 3.6f, 27), 2.6f, 2.6f},
               {arch.at(56, 4.6f, 19), 2.2f, 2.2f},
               {arch.at(44, 4.2f, 13), 1.4f, 1.4f}}),
         4);
    both(tube({{arch.at(66, -5.6f, 23), 1.6f, 1.6f}, // mylohyoid line
               {arch.at(52, -5.6f, 17.5f), 1.6f, 1.6f},
               {arch.at(34, -4.6f, 11), 1.f, 1.f}}),
         3);
    const vec3 head = arch.at(115, 1.5f, 60.5f);
    both(blob(head, {9.6f, 4.1f, 4.f}, 14), 4);                       // condyle
    both(blob(head + vec3(-5, 2.6f, -5), {4, 2.4f, 5}, 14), 4);       // and what carries it
    both(blob(arch.at(110.5f, -2.4f, 53), {3.4f, 2, 3.2f}), 4, true); // pterygoid fovea
    both(tube({{arch.at(29.5f, 9, 17), 2.4f, 2.f},
               {arch.at(28, 3.5f, 15), 2.f, 1.8f},
               {arch.at(27, 1, 14), 1.2f, 1.2f}}),
         1, true);
    both(tube({{arch.at(94, -6, 37), 2.6f, 2.2f}, {arch.at(91, -1.6f, 32), 1.8f, 1.6f}}), 1.4f,
         true);
    both(blob(arch.at(91, -4.2f, 36), {1.4f, 2.2f, 2.6f}), 1.6f); // lingula
    return out;
}

} // namespace

Phantom jaw()
{
    const auto bone = std::make_shared<MandibleBone>();
    JawTeeth teeth = jaw_teeth(bone->arch);
    return {
        "jaw",
        {146, 140, 92},
        {-61.7f, -6.5f, -5.5f},
        .85f,
        {mandible(bone), std::move(teeth.crowns), std::move(teeth.roots), std::move(teeth.pulps)},
        [](vec3 p, std::span<const float> d) {
            constexpr float soft = 1.7f;
            const float cancellous = 540 + 60 * noise(p / 1.9f);
            const float marrow = inside(d[0] + 2.6f, 2);
            float v = mix(-1000, mix(1280, cancellous, marrow),
                          inside(d[0] - .12f * noise(p / 4.f), soft));
            v = mix(v, 1650, inside(d[2], soft));
            v = mix(v, mix(2500, 1700, inside(d[1] + 1.7f, soft)), inside(d[1], soft));
            return mix(v, 300, inside(d[3], 1.2f));
        },
        .9f};
}

} // namespace make
