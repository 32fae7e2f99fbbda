// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/framebuffer.h"

#include "core/base/mistake.h"

#include <epoxy/gl.h>
#include <utility>
#include <vector>

namespace trivar::gpu {

Framebuffer::Framebuffer(std::initializer_list<const Texture2D*> colors, const Texture2D* depth)
{
    glGenFramebuffers(1, &name_);
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
    std::vector<GLenum> targets;
    for (const Texture2D* color : colors) {
        const auto at = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(targets.size());
        glFramebufferTexture(GL_FRAMEBUFFER, at, color->name(), 0);
        targets.push_back(at);
        size_px_ = color->size_px();
    }
    if (depth) {
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth->name(), 0);
        size_px_ = depth->size_px();
    }
    if (targets.empty() && !depth) {
        size_px_ = {1, 1};
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
    }
    if (targets.empty()) targets.push_back(GL_NONE);
    glDrawBuffers(static_cast<GLsizei>(targets.size()), targets.data());
    if (targets.front() == GL_NONE) glReadBuffer(GL_NONE);
    ensure(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
           "a picture cannot be drawn into");
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      size_px_(std::exchange(other.size_px_, glm::ivec2(0)))
{
}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(size_px_, other.size_px_);
    return *this;
}

Framebuffer::~Framebuffer()
{
    if (name_) glDeleteFramebuffers(1, &name_);
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
    glViewport(0, 0, size_px_.x, size_px_.y);
}

} // namespace trivar::gpu
