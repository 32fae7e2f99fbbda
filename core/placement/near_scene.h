// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/strip_index.h"
#include "core/rays/ray_scene.h"

#include <array>
#include <cstdint>

namespace trivar {

// NearScene holds the triangles of the scene that may come near the strip in the picture, with
// their vertices projected once. All lie in front of the camera: a triangle that reaches behind it
// is cut. `skip_back_faces` keeps only triangles that face the camera, as rays do. Parallel; a few
// nanoseconds per triangle of the scene, for whole blocks are rejected at once.
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
