// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <epoxy/gl.h>

namespace trivar::gpu::testing {
namespace {

void report(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
            const void*)
{
    const bool bad = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                     severity == GL_DEBUG_SEVERITY_HIGH;
    if (bad) ADD_FAILURE() << "OpenGL: " << message;
}

} // namespace

WithContext::WithContext()
{
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(report, nullptr);
}

WithContext::~WithContext()
{
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

} // namespace trivar::gpu::testing
