// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/shapes.h"

#include "assets/make/outline.h"

#include <memory>

namespace make {
namespace {

struct TubeStation {
    vec3 at, tangent;
    float across, along;
};

// Catmull-Rom in one number or vector.
template <class T> T between(T a, T b, T c, T d, float t)
{
    return .5f * (2.f * b + (c - a) * t + (2.f * a - 5.f * b + 4.f * c - d) * (t * t) +
                  (3.f * (b - c) + d - a) * (t * t * t));
}

std::vector<TubeStation> stations_along(const std::vector<Section>& s, int segments)
{
    std::vector<TubeStation> out;
    const int last = int(s.size()) - 1;
    const auto at = [&](int k) { return s[std::size_t(std::clamp(k, 0, last))]; };
    for (int i = 0; i <= last; ++i) {
        const Section a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        for (int k = 0; k < (i == last ? 1 : segments); ++k) {
            const float t = float(k) / float(segments);
            out.push_back({between(a.at, b.at, c.at, d.at, t), vec3(0),
                           between(a.across, b.across, c.across, d.across, t),
                           between(a.along, b.along, c.along, d.along, t)});
        }
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].tangent =
            glm::normalize(out[std::min(i + 1, out.size() - 1)].at - out[i == 0 ? 0 : i - 1].at);
    return out;
}

float elliptic(vec3 q, vec3 radii)
{
    return ellipsoid(q, vec3(0), radii);
}

float to_tube(const std::vector<TubeStation>& s, vec3 up, vec3 p)
{
    float best = 1e30f, t = 0;
    std::size_t segment = 0;
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        const vec3 d = s[i + 1].at - s[i].at, w = p - s[i].at;
        const float along = saturate(glm::dot(w, d) / glm::dot(d, d));
        const vec3 off = w - d * along;
        const float far = glm::dot(off, off);
        if (far < best) {
            best = far;
            t = along;
            segment = i;
        }
    }
    const TubeStation &a = s[segment], &b = s[segment + 1];
    const vec3 q = p - glm::mix(a.at, b.at, t);
    const vec3 z = glm::normalize(glm::mix(a.tangent, b.tangent, t));
    const vec3 y = glm::normalize(up - z * glm::dot(up, z)), x = glm::cross(y, z);
    const float across = mix(a.across, b.across, t), along = mix(a.along, b.along, t);
    return elliptic({glm::dot(q, x), glm::dot(q, y), glm::dot(q, z)},
                    {across, along, .7f * std::min(across, along)});
}

mat3 turn_back(float angle_deg, vec3 axis)
{
    return mat3(glm::rotate(mat4(1), glm::radians(-angle_deg), axis));
}

} // namespace

Solid tube(const std::vector<Section>& sections, vec3 up, int segments)
{
    const auto spine =
        std::make_shared<std::vector<TubeStation>>(stations_along(sections, segments));
    vec3 lo(1e9f), hi(-1e9f);
    for (const TubeStation& each : *spine) {
        const float r = std::max(each.across, each.along);
        lo = glm::min(lo, each.at - r);
        hi = glm::max(hi, each.at + r);
    }
    return {lo, hi, [spine, up](vec3 p) { return to_tube(*spine, up, p); }};
}

Solid blob(vec3 center, vec3 radii, float angle_deg, vec3 axis)
{
    const float r = std::max({radii.x, radii.y, radii.z});
    const mat3 back = turn_back(angle_deg, axis);
    return {center - r, center + r, [=](vec3 p) { return elliptic(back * (p - center), radii); }};
}

Solid block(vec3 center, vec3 half, float round, float angle_deg, vec3 axis)
{
    const float r = glm::length(half);
    const mat3 back = turn_back(angle_deg, axis);
    return {center - r, center + r,
            [=](vec3 p) { return box(back * (p - center), vec3(0), half, round); }};
}

Solid plate(vec3 origin, vec3 x, vec3 y, const std::vector<vec2>& outline, float half, float round)
{
    const auto loop = std::make_shared<std::vector<vec2>>(smooth_loop(outline, 5));
    const vec3 z = glm::cross(x, y);
    vec3 lo(1e9f), hi(-1e9f);
    for (const vec2& c : *loop) {
        const vec3 p = origin + x * c.x + y * c.y;
        lo = glm::min(lo, p - half);
        hi = glm::max(hi, p + half);
    }
    return {lo, hi, [=](vec3 p) {
                const vec3 q = p - origin;
                return prism(polygon({glm::dot(q, x), glm::dot(q, y)}, *loop), glm::dot(q, z), half,
                             round);
            }};
}

Solid ring(vec3 center, vec3 axis, float radius, float thickness)
{
    return {center - radius - thickness, center + radius + thickness, [=](vec3 p) {
                const vec3 q = p - center;
                const float up = glm::dot(q, axis), out = glm::length(q - axis * up) - radius;
                return std::sqrt(up * up + out * out) - thickness;
            }};
}

Solid solid(vec3 lo, vec3 hi, Distance distance)
{
    return {lo, hi, std::move(distance)};
}

Solid joined(const std::vector<Solid>& solids, float blend)
{
    vec3 lo(1e9f), hi(-1e9f);
    for (const Solid& each : solids) {
        lo = glm::min(lo, each.lo);
        hi = glm::max(hi, each.hi);
    }
    return {lo, hi, [solids, blend](vec3 p) {
                float d = 1e6f;
                for (const Solid& each : solids) d = smin(d, each.distance(p), blend);
                return d;
            }};
}

Solid grown(const Solid& s, float by)
{
    return {s.lo - by, s.hi + by, [f = s.distance, by](vec3 p) { return f(p) - by; }};
}

Solid mirrored(const Solid& s)
{
    return {{-s.hi.x, s.lo.y, s.lo.z}, {-s.lo.x, s.hi.y, s.hi.z}, [f = s.distance](vec3 p) {
                return f({-p.x, p.y, p.z});
            }};
}

} // namespace make
