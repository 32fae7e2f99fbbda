// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/deep_image.h"
#include "core/mesh/model.h"
#include "gpu/framebuffer.h"

#include <vector>

namespace trivar::gpu {

// Targets are the textures of one picture size, and the framebuffers over them. Deep ones have 16
// bits per channel where others have 8.
struct Targets {
    explicit Targets(glm::ivec2 size_px, bool deep = false);

    glm::ivec2 size_px;
    bool deep;
    Texture2D depth;      // 32-bit float
    Texture2D surfaces;   // pack.glsl
    Texture2D ids_depths; // instance id, bits of the distance along the view direction
    Texture2D occlusion_noisy, occlusion; // half size: occlusion.frag
    Texture2D color;                      // sRGB; deep: linear, half floats
    Texture2D color_bytes; // the same texels as plain bytes; deep: a texture of its own, encoded
    Texture2D kept;        // the last whole picture while the next is drawn
    Texture2D sum;         // average of the samples so far, linear
    Texture2D mask;        // of highlighted instances, and of what curves cover

    Framebuffer to_surfaces, to_ids, to_occlusion_noisy, to_occlusion, to_color, to_bytes, to_sum,
        to_mask;
    Framebuffer to_encoded; // the colour's bytes: blending there mixes encoded colours
};

// The picture, with row 0 on top.
Image read_back(const Targets& targets);
DeepImage read_back_deep(const Targets& targets);
// The ids in a rectangle of the picture, ascending and without 0; the first pixel is top left.
std::vector<int> ids_in(const Targets& targets, glm::ivec2 first_px, glm::ivec2 size_px);
// The id at a pixel of the picture. If a curve is within reach, and the surface at the pixel does
// not lie clearly in front of it, the id of the nearest curve. 0: none.
int id_near(const Targets& targets, glm::ivec2 p_px, double reach_px);

} // namespace trivar::gpu
