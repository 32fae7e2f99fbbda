// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf_accessor.h"
#include "core/mesh/model.h"

namespace trivar {

// Appends the file's materials with their pictures decoded; a picture that cannot be read is a
// notice and no texture.
void add_gltf_materials(Model& model, const tinygltf::Model& gltf, const GltfAccessors& accessors,
                        const std::string& name);

} // namespace trivar
