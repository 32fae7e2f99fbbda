// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/pane.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

Model painted(unsigned color)
{
    Model m;
    int paint = m.material("paint", srgb(color), .18f),
        glass = m.material("glass", srgb(0x141b22), .05f),
        trim = m.material("trim", srgb(0x1d1e20), .6f),
        rim = m.material("rim", srgb(0xb9bec4), .25f, .7f),
        tyre = m.material("tyre", srgb(0x1a1a1b), .9f),
        lamp = m.material("lamp", srgb(0xf4f1e4), .08f),
        tail = m.material("tail", srgb(0x8e0f16), .12f),
        amber = m.material("amber", srgb(0xe88a1e), .2f),
        chrome = m.material("chrome", srgb(0xd5d9dd), .15f, .9f);
    const float front_x = .800f, rear_x = .225f, R = .0745f, arch = .0845f;
    Loft lower({{.012f, .128f, .132f, .046f, .060f, 2.8f},
                {.035f, .127f, .166f, .062f, .074f, 3.1f},
                {.10f, .124f, .190f, .072f, .08f, 3.3f},
                {.22f, .120f, .201f, .074f, .08f, 3.4f},
                {.36f, .118f, .197f, .072f, .08f, 3.4f},
                {.50f, .115f, .194f, .070f, .08f, 3.4f},
                {.65f, .114f, .194f, .066f, .08f, 3.4f},
                {.80f, .112f, .195f, .055f, .08f, 3.2f},
                {.90f, .110f, .182f, .044f, .072f, 3.f},
                {.955f, .108f, .155f, .035f, .060f, 2.7f},
                {.98f, .106f, .128f, .026f, .048f, 2.5f}});
    Loft cabin({{.05f, .165f, .095f, .030f, .03f, 2.3f},
                {.12f, .168f, .122f, .052f, .03f, 2.4f},
                {.22f, .17f, .144f, .086f, .03f, 2.5f},
                {.33f, .17f, .157f, .113f, .03f, 2.6f},
                {.43f, .17f, .162f, .123f, .03f, 2.7f},
                {.51f, .17f, .163f, .118f, .03f, 2.7f},
                {.58f, .17f, .162f, .094f, .03f, 2.7f},
                {.64f, .17f, .160f, .060f, .03f, 2.7f},
                {.70f, .168f, .155f, .024f, .03f, 2.6f},
                {.75f, .158f, .140f, .004f, .02f, 2.4f}});
    Limb fender({{.62f, .140f, .150f, .028f},
                 {.72f, .149f, .154f, .033f},
                 {.81f, .154f, .156f, .036f},
                 {.90f, .146f, .149f, .034f},
                 {.945f, .137f, .141f, .031f}},
                10),
        haunch({{.44f, .135f, .158f, .026f},
                {.34f, .145f, .164f, .036f},
                {.24f, .151f, .166f, .043f},
                {.13f, .146f, .150f, .038f},
                {.07f, .143f, .130f, .028f}},
               10);
    Distance shell = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        float d = smin(lower(p), fender(p), .028f);
        d = smin(d, haunch(p), .030f);
        d = smin(d, cabin(p), .016f);
        d = smin(d,
                 box(turned(p, {.052f, .196f, 0}, 8, {0, 0, 1}), {.052f, .1935f, 0},
                     {.036f, .0065f, .118f}, .006f),
                 .022f);                                                               // ducktail
        d = smin(d, box(p, {.50f, .052f, .176f}, {.20f, .016f, .018f}, .012f), .012f); // sill
        return smax(d, .040f - p.y, .014f);
    };
    auto wells = [=](vec3 p) {
        float c = std::min(glm::length(vec2(p.x - front_x, p.y - R)),
                           glm::length(vec2(p.x - rear_x, p.y - R))) -
                  arch;
        return smax(c, .105f - p.z, .01f);
    };
    m.nodes.clear();
    int root = m.node("car");
    auto& B = m.nodes[root].parts;
    Mesh body = surface(
        [=](vec3 p0) {
            vec3 p = mirror_z(p0);
            float d = shell(p0);
            for (float x : {front_x, rear_x}) {
                float q = glm::length(vec2(glm::length(vec2(p.x - x, p.y - R)) - arch - .003f,
                                           p.z - .192f)) -
                          .0105f;
                d = smin(d, smax(q, .078f - p.y, .022f), .012f);
            }
            d = smax(d, -wells(p), .009f);
            return Sample{d, vec3(1)};
        },
        {0, .03f, -.23f}, {1.02f, .31f, .23f}, {.0063f, true, 10});
    body.colors.clear();
    B.push_back(body.mat(paint));
    const vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);
    // The body is a mesh and lies up to a quarter of a cell off its own formula: so much higher
    // panes of glass show none of it.
    constexpr float proud = .0042f;
    Place side = [](vec2 t) { return vec3(t.x, t.y, .30f); },
          above = [](vec2 t) { return vec3(t.x, .40f, t.y); },
          front = [](vec2 t) { return vec3(1.15f, t.y, t.x); },
          rear = [](vec2 t) { return vec3(-.15f, t.y, t.x); };
    auto sym = [](std::vector<vec2> half, float r) {
        std::vector<vec2> poly = half;
        for (int i = int(half.size()) - 1; i >= 0; i--)
            if (half[i].y > 1e-5f) poly.push_back({half[i].x, -half[i].y});
        return fillet(poly, r, 5);
    };
    auto slab = [](float cx, float cy, float w, float hh, float r) {
        return fillet({{cx - w, cy - hh}, {cx + w, cy - hh}, {cx + w, cy + hh}, {cx - w, cy + hh}},
                      r, 6);
    };
    auto pane2 = [&](const std::vector<vec2>& o, const Place& at, vec3 dir, float out, int mat) {
        both(B, pane(shell, o, at, dir, out, 5).mat(mat));
    };
    std::vector<vec2> door = {{.655f, .197f},  {.610f, .234f},  {.552f, .266f},
                              {.475f, .2765f}, {.418f, .2755f}, {.404f, .196f}},
                      quarter = {{.388f, .197f},  {.402f, .2745f}, {.350f, .2655f},
                                 {.288f, .2425f}, {.243f, .213f},  {.262f, .203f}};
    pane2(fillet(door, .016f, 6), side, -Z, proud, glass);
    pane2(fillet(quarter, .016f, 6), side, -Z, proud, glass);
    B.push_back(pane(shell,
                     sym({{.700f, .0f},
                          {.694f, .075f},
                          {.668f, .130f},
                          {.560f, .108f},
                          {.546f, .05f},
                          {.543f, .0f}},
                         .022f),
                     above, -Y, proud, 8)
                    .mat(glass));
    B.push_back(
        pane(shell,
             sym({{.322f, .0f}, {.319f, .055f}, {.305f, .096f}, {.195f, .072f}, {.186f, .0f}},
                 .022f),
             above, -Y, proud, 8)
            .mat(glass));
    B.push_back(pane(shell, slab(0, .151f, .160f, .0105f, .010f), rear, X, .0030f, 5).mat(tail));
    B.push_back(pane(shell, slab(0, .151f, .055f, .0115f, .004f), rear, X, .0042f, 4).mat(trim));
    B.push_back(pane(shell, slab(0, .082f, .118f, .022f, .012f), rear, X, .0030f, 5).mat(trim));
    B.push_back(pane(shell, slab(0, .104f, .042f, .012f, .004f), rear, X, .0050f, 3).mat(lamp));
    for (int i = 0; i < 6; i++)
        B.push_back(pane(shell, slab(.098f + .0145f * i, 0, .0042f, .062f, .004f), above, -Y,
                         .0016f, 3, .0015f)
                        .mat(trim));
    B.push_back(pane(shell, slab(0, .080f, .088f, .0175f, .012f), front, -X, .0022f, 6).mat(trim));
    pane2(slab(.128f, .080f, .024f, .0145f, .010f), front, -X, .0022f, trim);
    pane2(slab(.112f, .110f, .020f, .0065f, .006f), front, -X, .0026f, amber);
    for (int i = -1; i <= 1; i++)
        B.push_back(pane(shell, slab(0, .080f + .0105f * i, .078f, .0017f, .0015f), front, -X,
                         .0044f, 2, .0010f)
                        .mat(chrome));
    both(B, gap(shell,
                {{.672f, .190f},
                 {.662f, .165f},
                 {.656f, .120f},
                 {.648f, .085f},
                 {.625f, .068f},
                 {.560f, .066f},
                 {.470f, .066f},
                 {.420f, .068f},
                 {.396f, .088f},
                 {.388f, .125f},
                 {.390f, .165f},
                 {.398f, .192f}},
                side, -Z, .0013f)
                .mat(trim));
    B.push_back(gap(shell,
                    {{.715f, -.128f},
                     {.80f, -.114f},
                     {.90f, -.096f},
                     {.948f, -.066f},
                     {.962f, 0},
                     {.948f, .066f},
                     {.90f, .096f},
                     {.80f, .114f},
                     {.715f, .128f}},
                    above, -Y, .0012f)
                    .mat(trim));
    B.push_back(gap(shell,
                    {{.052f, -.100f},
                     {.10f, -.098f},
                     {.150f, -.088f},
                     {.172f, -.055f},
                     {.175f, 0},
                     {.172f, .055f},
                     {.150f, .088f},
                     {.10f, .098f},
                     {.052f, .100f}},
                    above, -Y, .0012f)
                    .mat(trim));
    both(B, pane(shell, slab(.428f, .160f, .020f, .0042f, .004f), side, -Z, .0050f, 3).mat(chrome));
    Mesh ring;
    {
        std::vector<vec4> r;
        for (int i = 0; i < 28; i++) {
            float a = 2 * pi * i / 28;
            r.push_back({0, .0285f * std::sin(a), .0275f * std::cos(a), .0038f});
        }
        ring = tube(r, 8, true);
    }
    Mesh lens = ball_mesh(.027f, 7).scale({.62f, 1.04f, 1});
    for (auto* q : {&ring, &lens})
        q->turn(38, {0, 0, 1}).turn(-14, {0, 1, 0}).move({.960f, .153f, .141f});
    both(B, lens.mat(lamp));
    both(B, ring.mat(paint));
    Mesh mirror = ball_mesh(.02f, 8).scale({.85f, .72f, 1.05f}).move({.608f, .212f, .192f}),
         stalk = tube({{.618f, .192f, .160f, .005f}, {.610f, .206f, .186f, .006f}}, 10),
         mglass = ball_mesh(.0165f, 8).scale({.25f, .70f, 1.f}).move({.5935f, .212f, .192f});
    both(B, mirror.mat(paint));
    both(B, stalk.mat(trim));
    both(B, mglass.mat(chrome));
    for (float z : {.052f, .078f})
        both(
            B,
            tube({{-.004f, .058f, z, .0125f}, {.05f, .058f, z, .0125f}}, 16, false, 1).mat(chrome));
    // wheels: a tyre, a dished rim, five spokes and a hub, turning about z
    for (int i = 0; i < 4; i++) {
        bool leading = i < 2;
        float s = i % 2 ? -1.f : 1.f, w = leading ? .024f : .027f;
        int n = m.node(std::string("wheel_") + (leading ? "f" : "r") + (s > 0 ? "l" : "r"), root,
                       {leading ? front_x : rear_x, R, s * (leading ? .166f : .168f)});
        auto& P = m.nodes[n].parts;
        auto put = [&](Mesh k, int mat) {
            k.turn(90, {1, 0, 0});
            if (s < 0) k = mirrored(k);
            P.push_back(k.mat(mat));
        };
        std::vector<vec2> t = fillet({{.050f, -w * .8f},
                                      {.066f, -w},
                                      {R, -w * .78f},
                                      {R, w * .78f},
                                      {.066f, w},
                                      {.050f, w * .8f}},
                                     .005f, 3);
        put(lathe(t, 72, true), tyre);
        put(lathe(fillet({{.0505f, -w * .8f},
                          {.0535f, -w * .8f},
                          {.0535f, w * .86f},
                          {.0500f, w * .92f},
                          {.0455f, w * .84f},
                          {.0470f, -w * .1f}},
                         .0015f, 2),
                  72, true),
            rim);
        put(cylinder(.047f, .047f, .006f, .001f, 24).move({0, -w * .2f, 0}), trim);
        for (int k = 0; k < 5; k++) {
            Mesh sp = prism_mesh(
                fillet({{.010f, -.0085f}, {.047f, -.0060f}, {.0475f, .0060f}, {.010f, .0085f}},
                       .002f, 2),
                .0048f, .002f);
            sp.turn(-90, {1, 0, 0}).move({0, w * .62f, 0}).turn(72.f * k + 18, {0, 1, 0});
            put(sp, rim);
        }
        put(cylinder(.0135f, .0110f, .012f, .003f, 24).move({0, w * .45f, 0}), chrome);
    }
    m.extras = {{"wheel_radius", std::to_string(R)}};
    return m;
}

} // namespace

Model car()
{
    return painted(0xc51f2b);
}

Model car_blue()
{
    return painted(0x2c5d99);
}

Model car_cream()
{
    return painted(0xe3d9bd);
}

} // namespace make
