// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"
#include "gpu/scene.h"
#include "gpu/studio.h"

namespace trivar::gpu {

// A Frame is the uniform block of shaders/frame.glsl, field by field in std140 order; that file
// states the units.
struct Frame {
    glm::mat4 view, clip, view_clip, from_view, key_clip;
    glm::vec4 eye, size_px, key_dir, key_light;
    std::array<glm::vec4, 9> ambient;
    std::array<glm::vec4, 3> box_dir, box_right, box_up, box_light;
    glm::vec4 zenith, horizon, floor_light, ground, contact, shadow_map, scene;
    std::array<glm::vec4, 3> backdrop;
    glm::vec4 centre, ground_share;
    std::array<glm::vec4, 4> grid_lines;
    glm::vec4 grid_at, grid_u, grid_v;
};
static_assert(sizeof(Frame) == 5 * 64 + 16 * (4 + 9 + 12 + 7 + 3 + 2 + 4 + 3));

// All fields but key_clip and shadow_map, which the shadow map fills in. Throws Rejected for a
// camera that looks nowhere.
Frame frame_of(const Picture& picture, const Camera& camera, const Scene& scene, const Look& look,
               const Studio& studio);

// The frame of sample `index` of `count`: shifted inside the pixel by a Hammersley point, with
// other noise. A single sample lies in the pixel's middle.
Frame sample_of(const Frame& frame, int index, int count);

} // namespace trivar::gpu
