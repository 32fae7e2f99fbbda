// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/sample.h"

namespace trivar::gpu {

// A ShadowMap is the view of the key light: an orthographic depth map fitted to the casters. It is
// drawn anew only when casters, light or resolution change.
class ShadowMap {
public:
    ShadowMap();
    // Fits the map and fills in the frame's key_clip and shadow_map; `resolution_px` is its side.
    void fit(Frame& frame, const Scene& scene, int resolution_px);
    // Whether the map differs from the scene fitted last.
    bool stale(const Scene& scene) const;
    void draw(Tools& tools, const Scene& scene, const Quality& quality);
    void bind() const; // to the units of shadow.glsl

private:
    Texture2D depth_;
    Framebuffer target_;
    Sampler compared_, plain_;
    glm::mat4 fitted_{0}, drawn_{0};
    CasterKey drawn_from_;
};

} // namespace trivar::gpu
