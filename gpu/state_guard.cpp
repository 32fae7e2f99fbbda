// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/state_guard.h"

#include "gpu/passes/tools.h"

#include <epoxy/gl.h>

namespace trivar::gpu {

StateGuard::StateGuard()
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    encodes_ = glIsEnabled(GL_FRAMEBUFFER_SRGB);
}

StateGuard::~StateGuard()
{
    set_state({});
    glDepthMask(GL_TRUE);
    if (!encodes_) glDisable(GL_FRAMEBUFFER_SRGB);
    for (unsigned unit = 0; unit < 16; ++unit) glBindSampler(unit, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(0);
    glUseProgram(0);
    glFrontFace(GL_CCW);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

} // namespace trivar::gpu
