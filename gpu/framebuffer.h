// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/texture.h"

#include <initializer_list>

namespace trivar::gpu {

// A Framebuffer is a GL framebuffer object over textures of other owners; over no texture where
// only the vertices of a draw matter.
class Framebuffer {
public:
    Framebuffer() = default;
    Framebuffer(std::initializer_list<const Texture2D*> colors, const Texture2D* depth);
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;
    ~Framebuffer();

    // Makes draws go here from now on, over the whole framebuffer.
    void bind() const;
    unsigned name() const { return name_; }

private:
    unsigned name_ = 0;
    glm::ivec2 size_px_{0};
};

} // namespace trivar::gpu
