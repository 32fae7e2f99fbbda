// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_accessor.h"
#include "core/mesh/model.h"

namespace trivar {

// Adds the skins of a glTF file to a model that has its nodes and meshes. `node_of` gives for each
// of the file's nodes its number in the model, or -1. An incomplete skin is left out with a notice.
// Throws Rejected where a vertex names a joint that its skin does not have.
void add_gltf_skins(Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
                    CountedNotices& notices);

// Removes skins and weights of morph targets, with notices, where they take a mesh out of range
// (most_coordinate), and throws Rejected where the mesh is out of range without them.
void check_gltf_reach(Model& model, const std::string& file_name, CountedNotices& notices);

} // namespace trivar
