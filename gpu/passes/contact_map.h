// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/tools.h"

namespace trivar::gpu {

// A ContactMap says how much of the sky each place of the ground sees past the things on it; it is
// the ambient part of the shadow and depends on the geometry alone.
class ContactMap {
public:
    // Whether the map does not show this scene at this resolution (its side).
    bool stale(const Frame& frame, const Scene& scene, int resolution_px) const;
    bool drawn() const { return open_.name() != 0; }
    void draw(Tools& tools, const Frame& frame, const Scene& scene, int resolution_px);
    void bind() const; // to unit 0, of shade.glsl and backdrop.frag

private:
    Texture2D lowest_, highest_, noisy_, open_;
    Framebuffer to_lowest_, to_highest_, to_noisy_, to_open_;
    glm::vec4 drawn_at_{0};
    CasterKey drawn_from_;
};

} // namespace trivar::gpu
