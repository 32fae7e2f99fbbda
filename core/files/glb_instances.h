// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/glb_accessors.h"
#include "core/mesh/model.h"

namespace trivar {

// Instances are nodes as EXT_mesh_gpu_instancing has them: one node, and for each of them a
// translation, a rotation and a scale in single precision relative to the middle of all.
struct WrittenInstances {
    glm::dvec3 middle{0}; // metres, in the space of their parent
    GlbEntries attributes;
};
WrittenInstances add_instances(GlbAccessors& to, const Model& model, const std::vector<int>& nodes);

} // namespace trivar
