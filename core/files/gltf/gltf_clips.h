// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_accessor.h"
#include "core/mesh/model.h"

namespace trivar {

// Adds the animations of a glTF file to a model that has its nodes and meshes. `node_of` gives for
// each of the file's nodes its number in the model, or -1. A track that cannot be played is left
// out with a notice.
void add_gltf_clips(Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
                    CountedNotices& notices);

} // namespace trivar
