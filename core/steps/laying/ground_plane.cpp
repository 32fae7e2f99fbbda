// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/ground_plane.h"

#include "core/mesh/primitives.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// Times the distance from the eye to the part of the ground under the stroke
constexpr double wide = 4;
// Times the nearest distance; beyond it the stroke reaches the horizon
constexpr double farthest = 1000;

} // namespace

std::optional<double> distance_to_ground(const Ray& ray)
{
    if (!(ray.origin.z > 0 && ray.direction.z < 0)) return {};
    const double distance = -ray.origin.z / ray.direction.z;
    if (!std::isfinite(distance)) return {};
    return distance;
}

GroundPlane::GroundPlane() : square_(make_ref(plane_mesh({2, 2}, {1, 1}))) {}

std::optional<Support> GroundPlane::under(const Sketch& sketch, const glm::dmat4& to_world) const
{
    const View view(sketch.camera);
    std::vector<Ray> rays;
    std::vector<double> distances;
    for (const StrokeSample& sample : sketch.samples) {
        const Ray ray = view.ray(sample.p_px);
        const Ray in_world{glm::dvec3(to_world * glm::dvec4(ray.origin, 1)),
                           glm::normalize(glm::dmat3(to_world) * ray.direction)};
        const std::optional<double> distance = distance_to_ground(in_world);
        if (!distance) continue;
        rays.push_back(in_world);
        distances.push_back(*distance);
    }
    if (rays.empty()) return {};
    const double near = std::ranges::min(distances);
    Box seen;
    double far = near;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (distances[i] > farthest * near) continue;
        seen.add(rays[i].origin + distances[i] * rays[i].direction);
        far = std::max(far, distances[i]);
    }
    const double reach = wide * (far + glm::length(seen.size()));
    Support out;
    out.part.rest = square_;
    out.part.to_world =
        glm::inverse(to_world) *
        glm::translate(glm::dmat4(1), glm::dvec3(seen.center().x, seen.center().y, 0)) *
        glm::scale(glm::dmat4(1), glm::dvec3(reach, reach, 1));
    out.part.bounds = {glm::dvec3(-1, -1, 0), glm::dvec3(1, 1, 0)};
    out.own_to_drawn = glm::inverse(to_world);
    return out;
}

} // namespace trivar
