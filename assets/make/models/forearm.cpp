// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace make {
namespace {

// A finger: three bones that bend down more and more, from a knuckle. Angles in degrees.
struct Finger {
    vec3 knuckle;
    float length, radius, spread, bend;
};
constexpr std::array<float, 4> share{.46f, .29f, .25f, 0};

struct FingerPoints {
    std::array<vec3, 4> at;
    vec3 nail, up; // the middle of the nail and where it looks
};
FingerPoints points_of(const Finger& finger)
{
    FingerPoints points;
    vec3 at = finger.knuckle;
    float down = finger.bend * .35f;
    for (std::size_t bone = 0; bone < 4; ++bone) {
        points.at[bone] = at;
        const float a = glm::radians(down), s = glm::radians(finger.spread);
        const vec3 along(std::cos(a) * std::cos(s), -std::sin(a), std::cos(a) * std::sin(s));
        if (bone == 2) {
            points.up = vec3(std::sin(a) * std::cos(s), std::cos(a), std::sin(a) * std::sin(s));
            points.nail = at + along * finger.length * .21f + points.up * finger.radius * .72f;
        }
        at += along * finger.length * share[bone];
        down += finger.bend;
    }
    return points;
}

constexpr std::array<Finger, 4> fingers{{
    {{.372f, .018f, .066f}, .225f, .0250f, 4, 16}, // from the index finger to the little one
    {{.386f, .024f, .020f}, .250f, .0255f, 0, 15},
    {{.374f, .020f, -.026f}, .228f, .0240f, -3, 17},
    {{.346f, .010f, -.068f}, .178f, .0210f, -8, 20},
}};

float finger_distance(vec3 p, const FingerPoints& points, float r)
{
    float d = capsule(p, points.at[0], points.at[1], r * 1.06f, r);
    d = smin(d, capsule(p, points.at[1], points.at[2], r, r * .92f), .006f);
    d = smin(d, capsule(p, points.at[2], points.at[3], r * .92f, r * .80f), .006f);
    return smin(d, ball(p, points.at[1], r * 1.06f), .012f); // the joint
}

// Fingernails are set into the tip: how far p is from the almond that they cover.
float nail_distance(vec3 p, const FingerPoints& points, float r)
{
    const vec3 along = glm::normalize(points.at[3] - points.at[2]);
    const vec3 aside = glm::cross(along, points.up), q = p - points.nail;
    const vec3 local(glm::dot(q, along), glm::dot(q, points.up), glm::dot(q, aside));
    return ellipsoid(local, vec3(0), {r * .80f, r * .50f, r * .66f});
}

} // namespace

// A right forearm and hand that lie with the back of the hand up: the elbow at -0.62, the tip of
// the middle finger at 0.62, about twice as large as life.
Model forearm()
{
    const vec3 skin = srgb(0xe6b497), rose = srgb(0xd58f78), nail = srgb(0xf0cdbd);
    std::array<FingerPoints, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = points_of(fingers[i]);
    const FingerPoints thumb = points_of({{.205f, -.022f, .100f}, .205f, .0290f, 30, 6});
    const auto field = [=](vec3 p) {
        float d = ellipsoid(p, {-.40f, .000f, .000f}, {.38f, .098f, .110f}); // muscles
        d = smin(d, capsule(p, {-.72f, 0, -.004f}, {-.45f, 0, 0}, .094f, .092f), .08f);
        d = smin(d, ellipsoid(p, {-.41f, .030f, .062f}, {.26f, .068f, .060f}), .06f);
        d = smin(d, ellipsoid(p, {-.40f, -.020f, -.058f}, {.27f, .070f, .058f}), .06f);
        d = smin(d, capsule(p, {-.40f, .004f, -.030f}, {.13f, .004f, -.034f}, .076f, .047f), .07f);
        d = smin(d, capsule(p, {-.40f, .004f, .035f}, {.13f, -.002f, .034f}, .076f, .049f), .07f);
        d = smin(d, ball(p, {.085f, .034f, -.062f}, .024f), .030f); // the ulna's head
        d = smin(d, box(p, {.245f, -.002f, .000f}, {.105f, .030f, .074f}, .028f), .055f); // palm
        d = smin(d, ellipsoid(p, {.21f, -.025f, .062f}, {.095f, .044f, .046f}), .035f); // its ball
        for (std::size_t i = 0; i < 4; ++i) {
            const float r = fingers[i].radius;
            d = smin(d, ball(p, fingers[i].knuckle + vec3(-.004f, .004f, 0), r * 1.14f), .022f);
            d = smin(d, finger_distance(p, at[i], r), .012f);
            const vec3 root(.165f, .030f, .030f - .020f * float(i));
            d = smin(d, capsule(p, root, fingers[i].knuckle + vec3(0, .014f, 0), .006f, .011f),
                     .022f); // a tendon
        }
        d = smin(d, finger_distance(p, thumb, .029f), .030f);
        float bare = 1;
        for (std::size_t i = 0; i < 4; ++i)
            bare = std::min(bare, nail_distance(p, at[i], fingers[i].radius));
        bare = std::min(bare, nail_distance(p, thumb, .029f));
        d = smax(d, -std::max(bare, -(d + .0035f)), .002f);
        d = smax(d, -.62f - p.x, .018f); // ends flat at the elbow
        float red = .45f * smooth_step(.34f, .60f, p.x);
        for (const FingerPoints& finger : at)
            red += .35f * smooth_step(.030f, .008f, glm::length(p - finger.at[0]));
        red += .12f * noise(p * 14.f);
        vec3 color = glm::mix(skin, rose, saturate(red));
        color = glm::mix(color, nail, smooth_step(.003f, -.001f, bare));
        return Sample{d, color};
    };
    Model m;
    const int material = m.material("skin", vec3(1), .5f);
    Mesh body = surface(field, {-.66f, -.20f, -.20f}, {.68f, .20f, .24f}, {.0082f, false, 10});
    wrap_about_x(body, 0);
    m.root().parts.push_back(body.mat(material));
    return m;
}

} // namespace make
