// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/stages/stage.h"
#include "core/stages/step.h"

#include <optional>
#include <vector>

namespace trivar {

// A MeshAnchor is a point of a mesh as barycentric weights of three vertices, so that it can be
// found in any pose.
struct MeshAnchor {
    glm::uvec3 vertices{0};
    glm::dvec3 shares{1, 0, 0};
};
// The place on the mesh that is nearest to a point. O(number of triangles), most of them passed
// over in blocks.
MeshAnchor nearest_anchor(const RayMesh& mesh, const glm::dvec3& p);

// A mesh of a shape before a pose moves its vertices; null: it has none of that slot.
Ref<Mesh> rest_mesh(const Shape& shape, int slot);

// A AnchorPlace is the present place of a sample on its host, in the host's own space.
struct AnchorPlace {
    glm::dvec3 p{0}, normal{0};
};

// Finds the places of samples on their hosts, however these are posed and bent; keeps where on the
// mesh at rest they are.
class MeshAnchors {
public:
    // Finds the place; nothing if the host does not show that mesh.
    std::optional<AnchorPlace> operator()(const AttachedSample& sample, std::size_t index,
                                          const EvaluatedObject& host,
                                          const std::vector<Part>& parts, const StepInput& input);

private:
    // A SampleAnchor is where on a mesh at rest a sample is; it holds for this mesh and place
    // alone.
    struct SampleAnchor {
        glm::dvec3 rest{0};
        Ref<Mesh> mesh;
        MeshAnchor anchor;
    };
    std::vector<std::optional<SampleAnchor>> known_; // by sample
};

} // namespace trivar
