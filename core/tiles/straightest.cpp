// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/straightest.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int most_crossed = 100'000;

} // namespace

SurfaceRay straightest(const TileBase& base, const SurfacePlace& start, const glm::dvec3& way)
{
    SurfaceRay ray{start};
    double rest = glm::length(way);
    if (!(rest > 0)) return ray;
    const glm::dvec3& first = base.face_normal(start.triangle);
    ray.direction = in_tangent_plane(turned_from_to(base.normal(start), first, way / rest), first);
    if (ray.direction == glm::dvec3(0)) {
        ray.left = rest;
        return ray;
    }
    glm::dvec3 p = base.position(start);
    int came = -1; // the side through which the path entered the triangle
    for (int crossed = 0; crossed < most_crossed; ++crossed) {
        const glm::uvec3& c = base.triangle(ray.at.triangle);
        const glm::dvec3& n = base.face_normal(ray.at.triangle);
        double nearest = 1e300;
        int out = -1;
        for (int e = 0; e < 3; ++e) {
            if (e == came) continue;
            const glm::dvec3& a = base.points()[c[e]];
            const glm::dvec3 inward = glm::cross(n, base.points()[c[(e + 1) % 3]] - a);
            const double speed = -glm::dot(inward, ray.direction);
            if (!(speed > 0)) continue;
            const double to_side = std::max(0.0, glm::dot(inward, p - a) / speed);
            if (to_side < nearest) nearest = to_side, out = e;
        }
        if (out < 0 || nearest >= rest) {
            p += rest * ray.direction;
            rest = 0;
            break;
        }
        p += nearest * ray.direction;
        rest -= nearest;
        const std::uint32_t behind = base.across(ray.at.triangle, out);
        if (behind == TileBase::none) break;
        const glm::dvec3& next = base.face_normal(behind / 3);
        const glm::dvec3 turned = in_tangent_plane(turned_from_to(n, next, ray.direction), next);
        if (turned == glm::dvec3(0)) break; // a triangle without area cannot be crossed
        ray.direction = turned;
        ray.at.triangle = behind / 3;
        came = static_cast<int>(behind % 3);
    }
    ray.left = rest;
    ray.at = base.place(ray.at.triangle, p);
    return ray;
}

} // namespace trivar
