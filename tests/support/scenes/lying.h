// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rays/ray_scene.h"
#include "core/stages/evaluated.h"
#include "core/steps/laying/mesh_anchor.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace trivar::testing {

// The place on the surface of an object that is nearest to a point of the world, exactly so where
// its parts are scaled evenly.
struct NearestPlace {
    double off = 1e300; // metres
    glm::dvec3 rest{0}; // on the mesh before a pose or a volume moves it
    glm::dvec3 p_world{0};
};
// Answers for many points of one evaluated object.
class NearestOn {
public:
    explicit NearestOn(EvaluatedObject object) : object_(std::move(object))
    {
        for (const Part& part : object_.parts)
            meshes_.push_back(std::make_unique<RayMesh>(part.mesh()));
    }
    NearestPlace operator()(const glm::dvec3& p) const
    {
        NearestPlace best;
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const Part& part = object_.parts[i];
            const MeshAnchor at =
                nearest_anchor(*meshes_[i], glm::inverse(part.to_world) * glm::dvec4(p, 1));
            const auto mixed = [&](const Mesh& mesh) {
                glm::dvec3 sum(0);
                for (int k = 0; k < 3; ++k)
                    sum += at.shares[k] * glm::dvec3(mesh.positions[at.vertices[k]]);
                return sum;
            };
            const glm::dvec3 here = part.to_world * glm::dvec4(mixed(*part.mesh()), 1);
            if (const double off = glm::distance(here, p); off < best.off)
                best = {off, mixed(*rest_mesh(*object_.shape, part.key.mesh)), here};
        }
        return best;
    }

private:
    EvaluatedObject object_;
    std::vector<std::unique_ptr<RayMesh>> meshes_;
};

// Every vertex of an object, in the world.
inline std::vector<glm::dvec3> world_points(const EvaluatedObject& object)
{
    std::vector<glm::dvec3> out;
    for (const Part& part : object.parts)
        for (const glm::vec3& p : part.mesh()->positions)
            out.emplace_back(part.to_world * glm::dvec4(glm::dvec3(p), 1));
    return out;
}

// The largest distance between points and others where a matrix takes these; 1e300 where they are
// not as many, or none.
inline double furthest_off(const std::vector<glm::dvec3>& points,
                           const std::vector<glm::dvec3>& before,
                           const glm::dmat4& by = glm::dmat4(1))
{
    if (points.size() != before.size() || points.empty()) return 1e300;
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        most = std::max(most, glm::distance(points[i], glm::dvec3(by * glm::dvec4(before[i], 1))));
    return most;
}

} // namespace trivar::testing
