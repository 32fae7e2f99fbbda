// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/glb_content.h"

namespace trivar {

// What tinygltf finds in a GLB file as Trivar writes them, in the way of glb_content_of(): what
// both readers find was not read by one mistake of our own. Throws Rejected, without the file's
// name.
std::vector<GlbContent::Node> nodes_by_tinygltf(const std::string& bytes);

} // namespace trivar
