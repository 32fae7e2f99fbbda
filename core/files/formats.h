// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/model.h"

#include <string>
#include <string_view>

namespace trivar {

// A FileText is what every reader gets: the whole file, and its name for the user.
struct FileText {
    std::string_view bytes;
    std::string name;
    std::string folder; // the folder from which other files may be read; empty: none
    // Taken from every position before that is rounded to single precision, in the file's axes and
    // units; formats that store double precision or text keep their detail far from 0 so.
    glm::dvec3 origin{0};
};

// There is one reader per format. Each gives positions, faces and attributes as the file has them,
// in the file's units and axes, with every index checked; repairs and missing normals come later. A
// face has at most this many corners: cutting concave ones is quadratic.
inline constexpr std::size_t max_face_corners = 8192;

Model read_obj(const FileText& file, const Progress& progress);
Model read_ply(const FileText& file, const Progress& progress);
Model read_stl(const FileText& file, const Progress& progress);
Model read_off(const FileText& file, const Progress& progress);
Model read_gltf(const FileText& file, bool binary, const Progress& progress);

// An Mtl holds the materials of a Wavefront material library, in the order of the file, with a
// sentence for everything that could not be taken over.
struct Mtl {
    std::vector<Material> materials;
    std::vector<std::string> notices;
};
Mtl read_mtl(const FileText& file);

// These functions give the bytes of one file of each format.
struct GlbOptions {
    bool instances = false; // equal meshes once, and repeated_nodes() by EXT_mesh_gpu_instancing
};
std::string write_glb(const Model& model, GlbOptions options = {});
struct ObjFiles {
    std::string obj, mtl, mtl_name; // the last one: of the file that the OBJ names
    std::vector<std::pair<std::string, Ref<Image>>> images; // file name to picture
};
ObjFiles write_obj(const Model& model, const std::string& stem);
std::string write_ply(const Model& model);
std::string write_stl(const Model& model);
std::string write_off(const Model& model);

} // namespace trivar
