// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/program.h"
#include "gpu/texture.h"

namespace trivar::gpu {

// A DevicePyramid is a DepthPyramid that the graphics card makes and keeps.
class DevicePyramid {
public:
    // Makes it of a depth buffer, or of a texture whose first component is depths, in a dispatch a
    // level. What runs after it may read it. Needs OpenGL 4.3.
    void write(Programs& programs, const Texture2D& depths);
    glm::ivec2 size_px() const { return size_px_; } // 0: there is none
    const Buffer& depths() const { return depths_; }

private:
    glm::ivec2 size_px_{0};
    Buffer depths_;
};
std::vector<ProgramName> pyramid_programs();

} // namespace trivar::gpu
