// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string>

namespace trivar {

// Writes .glb, .obj (with .mtl and pictures), .ply, .stl or .off by extension, through a temporary
// file beside it that is renamed at the end: a failure leaves the previous file as it was. glTF and
// OBJ are written Y up, the others Z up. Formats keep what they can hold: GLB the nodes and every
// attribute and material, its faces cut to triangles; OBJ polygons, normals, one UV set, materials
// and groups; PLY polygons, normals, one UV set and colours; OFF polygons; STL triangles. Throws
// Rejected, also where the file would hold nothing that can be read (core/files/writable.h).
void write_model(const Model& model, const std::string& path);

// Throws Rejected where the name ends as none of these.
void check_model_name(const std::string& path);

} // namespace trivar
