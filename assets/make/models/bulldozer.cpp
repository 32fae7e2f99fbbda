// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/pane.h"

#include <algorithm>
#include <cmath>

namespace make {

Model bulldozer()
{
    Model m;
    int yellow = m.material("yellow", srgb(0xf0b01f), .42f),
        dark = m.material("steel", srgb(0x3a3d40), .55f, .4f),
        track = m.material("track", srgb(0x2a2a2b), .75f),
        glass = m.material("glass", srgb(0x1f3440), .06f),
        grey = m.material("blade", srgb(0x8d9296), .4f, .6f),
        lamp = m.material("lamp", srgb(0xfff3cf), .1f),
        amber = m.material("beacon", srgb(0xf07a14), .2f);
    int root = m.node("bulldozer");
    auto beam = [](vec3 a, vec3 b, float hy, float hz, float bev) {
        vec3 d = b - a;
        float l = glm::length(d);
        Mesh k = bevel_box({l / 2, hy, hz}, bev, 2, {4, 1, 1});
        float yaw = std::atan2(-d.z, d.x), pitch = std::asin(d.y / l);
        return k.turn(glm::degrees(pitch), {0, 0, 1})
            .turn(glm::degrees(yaw), {0, 1, 0})
            .move((a + b) * .5f);
    };
    auto rod = [](vec3 a, vec3 b, float r) {
        return tube({vec4(a, r), vec4(glm::mix(a, b, .5f), r), vec4(b, r)}, 16, false, 1);
    };
    // tracks: their pads go round once in the clip "drive", and the blade nods
    constexpr int pads = 38, keys = 2 * pads;
    Clip drive;
    drive.name = "drive";
    for (int key = 0; key <= keys; ++key) drive.times_s.push_back(2 * float(key) / keys);
    const float x0 = .215f, x1 = .665f, yc = .112f, r = .092f;
    for (int s : {1, -1}) {
        int n = m.node(s > 0 ? "track_l" : "track_r", root, {0, 0, s * .190f});
        float straight = x1 - x0, len = 2 * straight + 2 * pi * r;
        auto at = [&](float u, float& a) {
            u = std::fmod(u, len);
            if (u < straight) {
                a = 0;
                return vec2(x0 + u, yc + r);
            }
            u -= straight;
            if (u < pi * r) {
                a = -u / r;
                return vec2(x1 + r * std::sin(u / r), yc + r * std::cos(u / r));
            }
            u -= pi * r;
            if (u < straight) {
                a = pi;
                return vec2(x1 - u, yc - r);
            }
            u -= straight;
            a = pi - u / r;
            return vec2(x0 - r * std::sin(u / r), yc - r * std::cos(u / r));
        };
        for (int i = 0; i < pads; i++) {
            const int pad = m.node("pad_" + std::to_string(i) + (s > 0 ? "_l" : "_r"), n);
            Channel moves{pad, {}, {}}, turns{pad, {}, {}};
            for (int key = 0; key <= keys; ++key) {
                float a;
                const vec2 c = at(len * (float(i) / pads + float(key) / keys), a);
                moves.translations.push_back({c.x, c.y, 0});
                turns.rotations.push_back(glm::angleAxis(a, vec3(0, 0, 1)));
            }
            m.nodes[pad].translation = moves.translations[0];
            m.nodes[pad].rotation = turns.rotations[0];
            drive.channels.insert(drive.channels.end(), {moves, turns});
            Mesh plate = bevel_box({len / pads * .47f, .0065f, .062f}, .0025f, 1, {1, 1, 3});
            plate.add(
                bevel_box({.0042f, .008f, .062f}, .002f, 1, {1, 1, 3}).move({-.008f, .010f, 0}));
            m.nodes[pad].parts.push_back(plate.mat(track));
        }
        auto& P = m.nodes[n].parts;
        Mesh belt;
        const int K = 84;
        for (int i = 0; i < K; i++) {
            float a;
            vec2 c = at(len * i / K, a), nrm(-std::sin(a), std::cos(a));
            for (int k = 0; k < 4; k++) {
                vec2 q = c + nrm * (k == 0 || k == 3 ? -.017f : -.004f);
                belt.points.push_back({q.x, q.y, k < 2 ? -.030f : .030f});
            }
        }
        for (int i = 0; i < K; i++)
            for (int k = 0; k < 4; k++) {
                int j = (i + 1) % K, k1 = (k + 1) % 4;
                belt.faces.push_back({i * 4 + k, j * 4 + k, j * 4 + k1, i * 4 + k1});
            }
        P.push_back(belt.mat(dark));
        auto wheel = [&](float x, float y, float R, float w, int mat) {
            P.push_back(cylinder(R, R, 2 * w, .005f, R > .04f ? 28 : 16)
                            .turn(90, {1, 0, 0})
                            .move({x, y, -w})
                            .mat(mat));
        };
        wheel(x0, yc, .071f, .030f, dark);
        wheel(x0, yc, .048f, .050f, yellow);
        wheel(x0, yc, .022f, .058f, dark);
        wheel(x1, yc, .071f, .030f, dark);
        wheel(x1, yc, .048f, .050f, yellow);
        wheel(x1, yc, .022f, .058f, dark);
        for (int k = 0; k < 5; k++) {
            wheel(mix(.30f, .58f, k / 4.f), .050f, .029f, .034f, dark);
            wheel(mix(.30f, .58f, k / 4.f), .050f, .012f, .046f, yellow);
        }
        for (float x : {.36f, .52f}) wheel(x, .176f, .014f, .030f, dark);
        P.push_back(prism_mesh(fillet({{.285f, .085f},
                                       {.595f, .085f},
                                       {.615f, .112f},
                                       {.590f, .150f},
                                       {.290f, .150f},
                                       {.265f, .112f}},
                                      .012f, 4),
                               .040f, .006f)
                        .mat(yellow));
    }
    auto& B = m.nodes[root].parts;
    B.push_back(prism_mesh(fillet({{.16f, .135f},
                                   {.74f, .135f},
                                   {.78f, .17f},
                                   {.78f, .235f},
                                   {.14f, .235f},
                                   {.14f, .16f}},
                                  .015f, 4),
                           .112f, .010f)
                    .mat(dark));
    B.push_back(
        prism_mesh(
            fillet({{.455f, .215f}, {.795f, .215f}, {.800f, .350f}, {.770f, .385f}, {.455f, .408f}},
                   .020f, 5),
            .092f, .014f)
            .mat(yellow));
    B.push_back(
        bevel_box({.012f, .066f, .074f}, .006f, 2, {1, 4, 4}).move({.797f, .288f, 0}).mat(track));
    for (int i = -3; i <= 3; i++)
        B.push_back(bevel_box({.007f, .0045f, .074f}, .003f, 2, {1, 1, 4})
                        .move({.808f, .288f + i * .017f, 0})
                        .mat(yellow));
    for (int i = 0; i < 5; i++)
        both(B, bevel_box({.006f, .040f, .003f}, .0025f, 2, {1, 3, 1})
                    .move({.60f + .030f * i, .320f, .0925f})
                    .mat(track));
    both(B, bevel_box({.135f, .0035f, .003f}, .0025f).move({.63f, .262f, .0925f}).mat(dark));
    for (int s : {1, -1})
        B.push_back(prism_mesh(fillet({{.15f, .225f},
                                       {.655f, .225f},
                                       {.72f, .205f},
                                       {.72f, .222f},
                                       {.660f, .243f},
                                       {.15f, .243f}},
                                      .006f, 3),
                               .070f, .004f)
                        .move({0, 0, s * .178f})
                        .mat(yellow)); // fenders over the tracks
    B.push_back(prism_mesh(fillet({{.135f, .225f}, {.460f, .225f}, {.460f, .345f}, {.135f, .345f}},
                                  .016f, 4),
                           .118f, .010f)
                    .mat(yellow));
    B.push_back(bevel_box({.052f, .050f, .108f}, .018f, 3).move({.115f, .270f, 0}).mat(yellow));
    B.push_back(prism_mesh(fillet({{.175f, .335f}, {.445f, .335f}, {.425f, .575f}, {.195f, .575f}},
                                  .010f, 3),
                           .104f, .006f)
                    .mat(glass));
    for (float z : {.100f, -.100f}) {
        B.push_back(beam({.443f, .335f, z}, {.421f, .585f, z}, .0115f, .0105f, .004f).mat(yellow));
        B.push_back(beam({.178f, .335f, z}, {.197f, .585f, z}, .0115f, .0105f, .004f).mat(yellow));
        B.push_back(beam({.318f, .335f, z}, {.312f, .585f, z}, .008f, .0095f, .003f).mat(yellow));
        B.push_back(beam({.180f, .345f, z}, {.440f, .345f, z}, .010f, .0105f, .004f).mat(yellow));
    }
    B.push_back(prism_mesh(fillet({{.150f, .575f},
                                   {.468f, .575f},
                                   {.475f, .590f},
                                   {.440f, .612f},
                                   {.180f, .612f},
                                   {.145f, .592f}},
                                  .010f, 4),
                           .128f, .010f)
                    .mat(yellow));
    both(B, cylinder(.017f, .019f, .016f, .003f, 20)
                .turn(-90, {0, 0, 1})
                .move({.468f, .594f, .085f})
                .mat(lamp));
    B.push_back(cylinder(.016f, .012f, .026f, .005f, 20).move({.25f, .610f, .06f}).mat(amber));
    both(B, cylinder(.018f, .020f, .018f, .003f, 20)
                .turn(-90, {0, 0, 1})
                .move({.768f, .402f, .052f})
                .mat(dark));
    both(B, cylinder(.0155f, .0155f, .006f, .002f, 20)
                .turn(-90, {0, 0, 1})
                .move({.784f, .402f, .052f})
                .mat(lamp));
    B.push_back(cylinder(.017f, .017f, .10f, .004f, 24, 3).move({.665f, .388f, .040f}).mat(dark));
    B.push_back(cylinder(.0105f, .0105f, .11f, .003f, 20, 3).move({.665f, .470f, .040f}).mat(grey));
    B.push_back(tube(curve({{.665f, .575f, .040f, .0108f},
                            {.660f, .590f, .040f, .0108f},
                            {.645f, .603f, .040f, .0108f}},
                           4),
                     16)
                    .mat(grey));
    B.push_back(cylinder(.022f, .022f, .060f, .008f, 24, 2).move({.575f, .395f, -.045f}).mat(dark));
    // ripper
    B.push_back(
        bevel_box({.018f, .022f, .105f}, .008f, 2, {1, 1, 4}).move({.055f, .215f, 0}).mat(yellow));
    for (float z : {-.07f, .07f}) {
        B.push_back(beam({.15f, .225f, z}, {.050f, .215f, z}, .012f, .010f, .004f).mat(dark));
    }
    for (float z : {-.08f, 0.f, .08f})
        B.push_back(prism_mesh(fillet({{.042f, .245f},
                                       {.070f, .245f},
                                       {.066f, .120f},
                                       {.080f, .068f},
                                       {.050f, .085f},
                                       {.038f, .130f}},
                                      .006f, 3),
                               .009f, .003f)
                        .move({0, 0, z})
                        .mat(grey));
    // blade, hinged at the trunnions
    int bl = m.node("blade", root, {.46f, .112f, 0});
    auto& D = m.nodes[bl].parts;
    vec3 o(-.46f, -.112f, 0);
    std::vector<vec2> arc, back;
    for (int i = 0; i <= 16; i++) {
        float a = glm::radians(mix(128, 236, i / 16.f));
        arc.push_back({1.055f + .185f * std::cos(a), .172f + .185f * std::sin(a)});
        back.push_back({1.055f + .207f * std::cos(a), .172f + .207f * std::sin(a)});
    }
    std::reverse(back.begin(), back.end());
    auto prof = arc;
    prof.insert(prof.end(), back.begin(), back.end());
    D.push_back(prism_mesh(prof, .275f, .003f, 12).move(o).mat(yellow));
    D.push_back(
        prism_mesh(fillet({{.935f, .028f}, {.957f, .0f}, {.972f, .0f}, {.950f, .036f}}, .002f, 2),
                   .278f, .002f, 8)
            .move(o)
            .mat(grey));
    std::vector<vec2> cheek = arc;
    cheek.push_back({.995f, .012f});
    cheek.push_back({.975f, .17f});
    cheek.push_back({.965f, .30f});
    for (int s : {1, -1})
        D.push_back(prism_mesh(cheek, .006f, .001f).move(o + vec3(0, 0, s * .274f)).mat(yellow));
    for (float y : {.115f, .235f})
        D.push_back(bevel_box({.012f, .014f, .262f}, .005f, 2, {1, 1, 6})
                        .move(o + vec3(.848f, y, 0))
                        .mat(dark));
    for (int s : {1, -1}) {
        D.push_back(beam(o + vec3(.46f, .112f, s * .275f), o + vec3(.70f, .100f, s * .275f), .024f,
                         .014f, .006f)
                        .mat(yellow));
        D.push_back(beam(o + vec3(.685f, .1005f, s * .275f), o + vec3(.885f, .085f, s * .262f),
                         .022f, .013f, .006f)
                        .mat(yellow));
        D.push_back(cylinder(.026f, .026f, .040f, .005f, 24)
                        .turn(90, {1, 0, 0})
                        .move(o + vec3(.46f, .112f, s * .272f - .02f))
                        .mat(dark));
    }
    both(B, rod({.715f, .335f, .118f}, {.80f, .285f, .120f}, .0165f).mat(yellow));
    both(B, rod({.78f, .297f, .120f}, {.862f, .248f, .121f}, .009f).mat(grey));
    both(B, bevel_box({.028f, .030f, .016f}, .008f).move({.705f, .335f, .104f}).mat(dark));
    Channel nod{bl, {}, {}};
    for (int key = 0; key <= keys; ++key)
        nod.rotations.push_back(
            glm::angleAxis(.06f * (1 - std::cos(2 * pi * float(key) / keys)), vec3(0, 0, 1)));
    drive.channels.push_back(nod);
    m.clips.push_back(drive);
    m.extras = {{"track_length", std::to_string(2 * (x1 - x0) + 2 * pi * r)}};
    return m;
}

} // namespace make
