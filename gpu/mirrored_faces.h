// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "gpu/buffer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trivar::gpu {

// MirroredFaces are the faces of a mesh on the GPU: triangles sorted by material.
struct MirroredFaces {
    struct Part {
        std::uint32_t material = 0;
        int first = 0, count = 0; // of the indices
    };
    Buffer indices;
    std::vector<Part> parts;
    bool closed = false; // is_closed_body(), which is asked only for meshes of triangles
};

// A FacesMirror uploads faces. Meshes of equal triangles share them, with any vertices: a mesh that
// is deformed or posed anew for every picture uploads no faces. (How a polygon with more corners is
// cut depends on the places of its corners.)
class FacesMirror {
public:
    std::shared_ptr<const MirroredFaces> operator()(const Mesh& mesh);
    // Frees faces that nobody has held since the last call, so that the next frame still finds
    // those of the previous one.
    void drop_dead();

private:
    std::map<std::string, std::shared_ptr<const MirroredFaces>> shared_; // by digest
};

} // namespace trivar::gpu
