// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/walk.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// A wave of the body that runs to the tail and grows on its way; the head nods against it.
void swim(Model& m)
{
    const std::vector<float> x{.66f, .50f, .36f, .22f, .10f};
    const std::vector<float> swing{.05f, .07f, .11f, .17f, .30f}; // radians
    constexpr float height = .125f;
    int parent = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const vec3 at = k == 0 ? vec3(x[0], height, 0) : vec3(x[k] - x[k - 1], 0, 0);
        parent = m.node("spine_" + std::to_string(k), parent, at);
        m.skin.joints.push_back(parent);
    }
    m.skin.at = [x](vec3 p) { return along_x(x, p); };
    Clip c;
    c.name = "swim";
    constexpr int keys = 24;
    constexpr float seconds = 1.6f;
    for (const int joint : m.skin.joints) c.channels.push_back({joint, {}, {}});
    for (int key = 0; key <= keys; ++key) {
        const float u = float(key) / keys;
        c.times_s.push_back(seconds * u);
        for (std::size_t k = 0; k < x.size(); ++k)
            c.channels[k].rotations.push_back(
                glm::angleAxis(swing[k] * std::sin(2 * pi * u - .8f * float(k)), vec3(0, 0, 1)));
    }
    m.clips.push_back(c);
}

} // namespace

Model whale()
{
    Model m;
    int skin = m.material("skin", vec3(1), .35f), eye = m.material("eye", srgb(0x0d0f12), .08f);
    Loft body({{.035f, .150f, .010f, .012f, .012f, 2},
               {.10f, .146f, .0165f, .022f, .024f, 2},
               {.20f, .138f, .032f, .042f, .046f, 2},
               {.32f, .131f, .059f, .067f, .075f, 2.05f},
               {.45f, .127f, .088f, .086f, .100f, 2.1f},
               {.58f, .125f, .108f, .095f, .117f, 2.1f},
               {.70f, .124f, .116f, .093f, .122f, 2.15f},
               {.80f, .122f, .109f, .081f, .116f, 2.2f},
               {.89f, .119f, .086f, .060f, .096f, 2.2f},
               {.94f, .117f, .071f, .045f, .078f, 2.25f},
               {.968f, .116f, .060f, .036f, .062f, 2.2f}});
    auto flukes = smooth_loop({{.072f, 0},
                               {.060f, .030f},
                               {.022f, .085f},
                               {-.018f, .132f},
                               {-.048f, .152f},
                               {-.050f, .146f},
                               {-.030f, .100f},
                               {-.016f, .050f},
                               {-.020f, .020f},
                               {-.006f, .0f},
                               {-.020f, -.020f},
                               {-.016f, -.050f},
                               {-.030f, -.100f},
                               {-.050f, -.146f},
                               {-.048f, -.152f},
                               {-.018f, -.132f},
                               {.022f, -.085f},
                               {.060f, -.030f}});
    auto flipper = smooth_loop({{.775f, .04f},
                                {.770f, .115f},
                                {.730f, .185f},
                                {.672f, .245f},
                                {.640f, .262f},
                                {.634f, .254f},
                                {.655f, .205f},
                                {.680f, .150f},
                                {.690f, .095f},
                                {.680f, .04f}});
    auto dorsal = smooth_loop({{.405f, .175f},
                               {.365f, .208f},
                               {.315f, .246f},
                               {.292f, .256f},
                               {.290f, .249f},
                               {.300f, .222f},
                               {.288f, .198f},
                               {.270f, .165f},
                               {.34f, .15f}});
    auto foil = [](float d2, float y, float T, float w) {
        float t = T * std::sqrt(saturate(-d2 / w));
        return d2 > 0 ? std::sqrt(d2 * d2 + y * y) - .0016f : (std::abs(y) - t) * .8f - .0016f;
    };
    auto f = [=](vec3 p0) {
        vec3 p = mirror_z(p0);
        vec3 back = srgb(0x2f4a63), mid = srgb(0x4c6d88), pale = srgb(0xdfe7ea);
        float bd = body(p), th = std::atan2(p.z, p.y - .124f);
        float line = .085f + .020f * std::sin(p.x * 9.f - .6f) + .05f * smooth_step(.5f, .1f, p.x) +
                     .010f * noise(p0 * 22.f);
        vec3 k = glm::mix(pale, mid, smooth_step(line - .012f, line + .014f, p.y));
        k = glm::mix(k, back,
                     smooth_step(line + .01f, line + .10f, p.y + .015f * noise(p0 * 16.f + 3.f)));
        float pleat = smooth_step(.50f, .62f, p.x) * smooth_step(.115f, .085f, p.y) *
                      smooth_step(.995f, .93f, p.x);
        Sample s{bd + .0042f * pleat * (.35f - std::pow(std::abs(std::cos(th * 15.f)), .7f)),
                 glm::mix(k, srgb(0x8fa6b3),
                          pleat * .75f * std::pow(std::abs(std::sin(th * 15.f)), 6.f))};
        float yf = .150f + .10f * p.z * p.z - .01f;
        add(s, foil(polygon({p.x, p0.z}, flukes), p.y - yf, .0125f, .030f),
            glm::mix(pale, back, smooth_step(-.004f, .004f, p.y - yf + .004f * noise(p0 * 30.f))),
            .018f);
        vec3 q = p - vec3(0, .075f - .32f * (p.z - .09f) + .4f * (p.z - .09f) * (p.z - .09f), 0);
        add(s, foil(polygon({p.x, p.z}, flipper), q.y, .0145f, .028f),
            glm::mix(pale, mid, smooth_step(-.006f, .006f, q.y)), .022f);
        add(s, foil(polygon({p.x, p.y}, dorsal), p0.z, .0150f, .035f), back, .018f);
        float mouth = path_distance(
            {p.x, p.y},
            {{.835f, .078f}, {.865f, .092f}, {.90f, .104f}, {.95f, .112f}, {1.05f, .118f}});
        cut(s, groove(s.distance, mouth, .0022f, .005f), srgb(0x1d2d3c), .004f);
        add(s, ellipsoid(p, {.838f, .105f, .0985f}, {.020f, .014f, .010f}), .012f);
        cut(s, ball(p, {.838f, .1045f, .1085f}, .0052f), .004f);
        cut(s, ellipsoid(p, {.835f, .2015f, .006f}, {.010f, .006f, .0022f}), srgb(0x16222d),
            .004f); // blowholes
        return s;
    };
    Mesh b = surface(f, {-.06f, -.005f, -.29f}, {1.02f, .275f, .29f}, {.0054f, true, 8});
    wrap_about_x(b, .124f);
    auto& P = m.root().parts;
    P.push_back(b.mat(skin));
    both(P, ball_mesh(.0068f, 6).move({.838f, .1045f, .1045f}).mat(eye));
    swim(m);
    return m;
}

} // namespace make
