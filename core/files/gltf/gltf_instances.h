// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_accessor.h"
#include "core/files/gltf/gltf_nodes.h"

namespace trivar {

// Reads EXT_mesh_gpu_instancing: a node that shows its mesh at several places hands it to as many
// new nodes below it, behind all other nodes. Returns the number of these nodes. Throws Rejected
// where attributes differ in number or kind, have numbers that are not finite or beyond 1e15, or
// ask for more nodes than the file may expand to.
std::size_t add_gltf_instances(GltfNodes& nodes, GltfAccessors& accessors, CountedNotices& notices);

// Throws Rejected where the last `instances` nodes of a model, which has its meshes, show more
// vertices together than can be worked with.
void check_instances(const Model& model, std::size_t instances, const std::string& file_name);

} // namespace trivar
