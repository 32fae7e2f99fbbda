// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_materials.h"

namespace trivar {

Mesh with_materials_from(Mesh mesh, std::uint32_t first)
{
    if (first == 0) return mesh;
    mesh.face_material.resize(mesh.face_count(), 0);
    for (std::uint32_t& material : mesh.face_material) material += first;
    return mesh;
}

} // namespace trivar
