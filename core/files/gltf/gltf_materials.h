// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_file.h"
#include "core/mesh/model.h"

namespace trivar {

// The file's materials with decoded pictures. References to missing things, and unreadable
// pictures, become notices and no textures.
std::vector<Material> gltf_materials(GltfFile& file, CountedNotices& notices);

} // namespace trivar
