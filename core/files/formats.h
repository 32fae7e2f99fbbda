// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/model.h"

#include <functional>
#include <string>
#include <string_view>

namespace trivar {

// A FileText is the input of every reader: the whole file, and its name for the user.
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

// A Model whose file may say where its only mesh is smooth: by face the smoothing group, 0: none.
struct ObjModel {
    Model model;
    std::vector<std::uint32_t> smoothing; // #F, or empty: it does not say
};
ObjModel read_obj(const FileText& file, const Progress& progress);
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
// Pictures that came from files keep their names where `is_free` lets them; others get the stem and
// a number.
using IsFree = std::function<bool(const std::string& name, const Image& image)>;
ObjFiles write_obj(const Model& model, const std::string& stem, const IsFree& is_free = {});
// Whether a picture is written as the file from which it came.
inline bool as_it_came(const Image& image)
{
    return !image.source_bytes.empty() && (image.mime == "image/png" || image.mime == "image/jpeg");
}
std::string write_ply(const Model& model);
std::string write_stl(const Model& model);
std::string write_off(const Model& model);

} // namespace trivar
