// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/tools.h"
#include "gpu/scene.h"
#include "gpu/tiles/depth_pyramid.h"
#include "gpu/tiles/device_pyramid.h"

namespace trivar::gpu {

// Occluders are what tiles may be hidden behind: all that is opaque and no tile.
class Occluders {
public:
    // Whether what they hide may be worth the time to find it: the tiles that are drawn have many
    // more vertices than they.
    static bool worthwhile(const Scene& scene, const TileCounts& tiles);
    // Draws their depths at half the size of the picture.
    void draw(Tools& tools, const Frame& frame, const Scene& scene);
    // Return the depths of the last draw: read back, which waits, or built on the graphics card.
    DepthPyramid read_back() const;
    const DevicePyramid& on_card(Tools& tools);

private:
    Texture2D depth_;
    Framebuffer target_;
    DevicePyramid pyramid_;
};

} // namespace trivar::gpu
