// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf_accessor.h"
#include "core/mesh/model.h"

namespace trivar {

// The skins of a glTF file, to a model that has its nodes and meshes; `node_of`: where each of the
// file's nodes is in it, or -1. A skin that lacks something is left out with a notice. Throws
// Rejected where a vertex names a joint that its skin does not have.
void add_gltf_skins(Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
                    CountedNotices& notices);

// Leaves skins and weights of morph targets out, with notices, where they take a mesh out of reach
// (most_coordinate), and throws Rejected where it is there without.
void check_gltf_reach(Model& model, const std::string& file_name, CountedNotices& notices);

} // namespace trivar
