// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/formats.h"
#include "core/files/source_files.h"
#include "core/mesh/model.h"

#include <string>

namespace trivar {

// Writes .glb, .obj (with .mtl and pictures), .ply, .stl or .off by extension, each as a
// GrowingFile: a failure leaves the previous file as it was. glTF and
// OBJ are written Y up, the others Z up; a model far from the origin in double precision, but for
// STL. Formats keep what they can hold: GLB the nodes and every attribute and material, its faces
// cut to triangles, and curves; OBJ polygons, normals, one UV set, materials, groups and curves;
// PLY polygons, normals, one UV set and colours; OFF polygons; STL triangles. Throws Rejected,
// before anything is written where the model has nothing of what the format can hold or is too
// large to be worked with, and where one of its files would take the place of one of the sources.
void write_model(const Model& model, const std::string& path, const SourceFiles& sources = {},
                 GlbOptions glb = {});

// Returns a sentence if a file of that name cannot hold the curves of the model, or the detail that
// it has far from the origin; empty: it holds all.
std::string what_is_lost(const Model& model, const std::string& path);

// Throws Rejected where the name ends as none of these.
void check_model_name(const std::string& path);

} // namespace trivar
