// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/targets.h"

#include <epoxy/gl.h>

namespace trivar::gpu {

Targets::Targets(glm::ivec2 size)
    : size_px(size),
      depth(GL_DEPTH_COMPONENT32F, size),
      surfaces(GL_RGBA32UI, size),
      ids_depths(GL_RG32UI, size),
      occlusion_noisy(GL_RGBA32F, (size + 1) / 2),
      occlusion(GL_RGBA32F, (size + 1) / 2),
      color(GL_SRGB8_ALPHA8, size),
      color_bytes(color.view(GL_RGBA8)),
      kept(GL_RGBA8, size, true),
      sum(GL_RGBA16F, size),
      mask(GL_R8, size, true),
      to_surfaces({&surfaces, &ids_depths}, &depth),
      to_ids({&ids_depths}, &depth),
      to_occlusion_noisy({&occlusion_noisy}, nullptr),
      to_occlusion({&occlusion}, nullptr),
      to_color({&color}, &depth),
      to_bytes({&color_bytes}, nullptr),
      to_sum({&sum}, nullptr),
      to_mask({&mask}, &depth),
      to_encoded({&color_bytes}, &depth)
{
}

} // namespace trivar::gpu
