// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

#include <algorithm>
#include <cmath>

// Modelling with signed distances, negative inside: shapes, smooth joins and cuts that carry
// colour.
namespace make {

inline constexpr float pi = 3.14159265f;

struct Sample {
    float distance;
    vec3 color;
};
using Field = std::function<Sample(vec3)>;
using Distance = std::function<float(vec3)>;

inline float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}
inline float saturate(float x)
{
    return std::clamp(x, 0.f, 1.f);
}
inline float smooth_step(float a, float b, float x)
{
    const float t = saturate((x - a) / (b - a));
    return t * t * (3 - 2 * t);
}

// Minimum and maximum with a blend of width k (polynomial, after I. Quilez).
inline float smin(float a, float b, float k)
{
    if (k <= 0) return std::min(a, b);
    const float h = saturate(.5f + .5f * (b - a) / k);
    return mix(b, a, h) - k * h * (1 - h);
}
inline float smax(float a, float b, float k)
{
    return -smin(-a, -b, k);
}

Sample join(Sample a, Sample b, float k);
void add(Sample& body, float distance, vec3 color, float k);
void add(Sample& body, float distance, float k); // keeps the colour
void cut(Sample& body, float distance, float k);
void cut(Sample& body, float distance, vec3 color, float k);

float ball(vec3 p, vec3 center, float radius);
float ellipsoid(vec3 p, vec3 center, vec3 radii); // first-order distance, exact for a ball
float capsule(vec3 p, vec3 a, vec3 b, float radius_a, float radius_b);
float box(vec3 p, vec3 center, vec3 half, float round);
float tilted(vec3 p, vec3 center, vec3 radii, float angle_deg, vec3 axis); // a turned ellipsoid
vec3 turned(vec3 p, vec3 center, float angle_deg, vec3 axis); // space turned the other way round
float prism(float outline, float along, float half, float round); // a 2D distance, extruded
float groove(float skin, float line, float radius, float depth);  // follows a line, skin-deep
float noise(vec3 p);                                              // smooth value noise, -1..1

vec3 slope(const Distance& field, vec3 p);         // unit gradient
vec3 onto(const Distance& body, vec3 p, vec3 dir); // first hit along dir, within 0.6
inline vec3 mirror_z(vec3 p)
{
    return {p.x, p.y, std::abs(p.z)};
}

} // namespace make
