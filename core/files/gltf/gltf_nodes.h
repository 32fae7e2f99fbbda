// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_file.h"
#include "core/mesh/extent.h"
#include "core/mesh/model.h"

namespace trivar {

// GltfNodes are the nodes of the scene that a glTF file shows, each after its parent; `mesh` is the
// number of a mesh in the file. Where the scene shows no mesh all nodes are taken, and where these
// show none either, each mesh gets a node: everything in a file is shown.
struct GltfNodes {
    std::vector<Node> nodes;
    std::vector<int> node_of; // by node of the file: where it is in the list, or -1
};
// Throws Rejected where the nodes are no trees or lie out of range.
GltfNodes gltf_nodes(GltfFile& file, CountedNotices& notices);

} // namespace trivar
