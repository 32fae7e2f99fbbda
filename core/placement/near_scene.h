// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/ray_scene.h"
#include "core/placement/strip_index.h"

#include <array>
#include <cstdint>

namespace trivar {

// The triangles of the scene that may come near the strip in the picture, and their vertices,
// projected once. All in front of the camera: what reaches behind it is cut off. With
// `skip_back_faces` only those turned to the camera, as the rays see them. Parallel; a few
// nanoseconds for each triangle of the scene, for they are told apart in blocks.
struct NearScene {
    struct Vertex {
        glm::dvec3 p_world;
        PicturePoint at;
    };
    std::vector<Vertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

NearScene near_scene(const RayScene& scene, const View& view, const StripIndex& strip,
                     bool skip_back_faces);

} // namespace trivar
