// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

enum class UpAxis { automatic, y, z }; // automatic: glTF and OBJ are Y up, the others Z up

struct ReadOptions {
    UpAxis up = UpAxis::automatic;
    double scale = 1; // file units to metres
    // Whether meshes get the normals that their file does not give, which may split vertices.
    bool normals_of_faces = true;
    std::uintmax_t max_bytes = std::uintmax_t{4} << 30;
};

// Reads .obj, .ply, .stl, .off, .gltf or .glb. The file is taken to be hostile: every size is
// checked against the bytes that are there. Throws Rejected (one sentence: file, line or element,
// what is wrong) or Cancelled. What was repaired is said in Model::notices.
Model read_model(const std::string& path, const ReadOptions& options = {},
                 const Progress& progress = {});

// The same from bytes already in memory. `name` gives the format by its extension and appears in
// messages; `folder` is where other files (MTL, textures, buffers) may be read from, empty:
// nowhere.
Model read_model_bytes(std::string_view bytes, const std::string& name, const std::string& folder,
                       const ReadOptions& options = {}, const Progress& progress = {});

} // namespace trivar
