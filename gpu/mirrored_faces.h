// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "gpu/buffer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trivar::gpu {

// The faces of a mesh as the GPU has them: triangles sorted by material.
struct MirroredFaces {
    struct Part {
        std::uint32_t material = 0;
        int first = 0, count = 0; // of the indices
    };
    Buffer indices;
    std::vector<Part> parts;
    bool closed = false; // is_closed_body(), as far as it was looked for: of triangles alone
};

// Uploads of faces. Meshes of triangles that have equal ones share them, whatever their vertices:
// what is deformed or posed anew for every picture uploads nothing else. (How a polygon with more
// corners is cut depends on where they lie.)
class FacesMirror {
public:
    std::shared_ptr<const MirroredFaces> operator()(const Mesh& mesh);
    // Those that nobody has held since the last call, so that the next frame finds those of the
    // one before.
    void drop_dead();

private:
    std::map<std::string, std::shared_ptr<const MirroredFaces>> shared_; // by digest
};

} // namespace trivar::gpu
