// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/glb_content.h"

namespace trivar {

// Reads with tinygltf the content of a GLB file of Trivar, in the form of glb_content_of(): if both
// readers agree, no mistake of our own hides in reading. Throws Rejected, without the file's name.
std::vector<GlbContent::Node> nodes_by_tinygltf(const std::string& bytes);

} // namespace trivar
