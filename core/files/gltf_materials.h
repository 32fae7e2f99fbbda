// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf_file.h"
#include "core/mesh/model.h"

namespace trivar {

// The file's materials with their pictures decoded. References to what is not there, and pictures
// that cannot be read, are notices and no textures.
std::vector<Material> gltf_materials(GltfFile& file, CountedNotices& notices);

} // namespace trivar
