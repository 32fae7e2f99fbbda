// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/field.h"

#include <cstdint>

namespace make {

Sample join(Sample a, Sample b, float k)
{
    float h = saturate(.5f + .5f * (b.distance - a.distance) / std::max(k, 1e-6f));
    return {smin(a.distance, b.distance, k), glm::mix(b.color, a.color, h)};
}
void add(Sample& a, float d, vec3 c, float k)
{
    a = join(a, {d, c}, k);
}
void add(Sample& a, float d, float k)
{
    a.distance = smin(a.distance, d, k);
} // keeps the colour
void cut(Sample& a, float d, float k)
{
    a.distance = smax(a.distance, -d, k);
}
void cut(Sample& a, float d, vec3 c, float k)
{
    float h = saturate(.5f + .5f * (-d - a.distance) / std::max(k, 1e-6f));
    a = {smax(a.distance, -d, k), glm::mix(a.color, c, h)};
}

float ball(vec3 p, vec3 o, float r)
{
    return glm::length(p - o) - r;
}
float ellipsoid(vec3 p, vec3 o, vec3 r)
{
    p -= o;
    float a = glm::length(p / r), b = glm::length(p / (r * r));
    return b < 1e-9f ? -std::min({r.x, r.y, r.z}) : a * (a - 1) / b;
}
float capsule(vec3 p, vec3 a, vec3 b, float ra, float rb)
{
    vec3 d = b - a;
    float t = saturate(glm::dot(p - a, d) / glm::dot(d, d));
    return glm::length(p - a - d * t) - mix(ra, rb, t);
}
float box(vec3 p, vec3 o, vec3 h, float r)
{
    vec3 q = glm::abs(p - o) - h + r;
    return glm::length(glm::max(q, 0.f)) + std::min(std::max({q.x, q.y, q.z}), 0.f) - r;
}
float tilted(vec3 p, vec3 o, vec3 r, float deg, vec3 axis)
{ // an ellipsoid turned about its centre
    mat3 m(glm::rotate(mat4(1), glm::radians(-deg), axis));
    return ellipsoid(m * (p - o), vec3(0), r);
}
vec3 turned(vec3 p, vec3 o, float deg, vec3 axis)
{
    return mat3(glm::rotate(mat4(1), glm::radians(-deg), axis)) * (p - o) + o;
}
float prism(float d2, float along, float half, float r)
{ // extrude a 2D distance, rounded by r
    vec2 w(d2 + r, std::abs(along) - half + r);
    return std::min(std::max(w.x, w.y), 0.f) + glm::length(glm::max(w, 0.f)) - r;
}
float groove(float skin, float line, float radius, float depth)
{
    return std::max(line - radius, -(skin + depth));
}

namespace {
float hash(int x, int y, int z)
{
    uint32_t h = uint32_t(x) * 374761393u + uint32_t(y) * 668265263u + uint32_t(z) * 2147483647u;
    h = (h ^ (h >> 13)) * 1274126177u;
    return float((h ^ (h >> 16)) & 0xffffff) / 8388607.5f - 1;
}

} // namespace

float noise(vec3 p)
{
    vec3 f = glm::floor(p), t = p - f;
    t = t * t * (3.f - 2.f * t);
    int x = int(f.x), y = int(f.y), z = int(f.z);
    float v = 0;
    for (int i = 0; i < 8; i++)
        v += hash(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)) * (i & 1 ? t.x : 1 - t.x) *
             (i & 2 ? t.y : 1 - t.y) * (i & 4 ? t.z : 1 - t.z);
    return v;
}

vec3 slope(const Distance& f, vec3 p)
{
    const float e = .0015f;
    return glm::normalize(vec3(f(p + vec3(e, 0, 0)) - f(p - vec3(e, 0, 0)),
                               f(p + vec3(0, e, 0)) - f(p - vec3(0, e, 0)),
                               f(p + vec3(0, 0, e)) - f(p - vec3(0, 0, e))));
}

vec3 onto(const Distance& f, vec3 p, vec3 dir)
{ // first hit of the body along dir
    float t = 0;
    for (; t < .6f && f(p + dir * t) > 0; t += .004f) {
    }
    float a = t - .004f, b = t;
    for (int i = 0; i < 12; i++) {
        float m = .5f * (a + b);
        (f(p + dir * m) > 0 ? a : b) = m;
    }
    return p + dir * b;
}

} // namespace make
