// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/program.h"

#include <cassert>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

namespace trivar::gpu {
namespace {

GLuint compiled(GLenum stage, const std::string& file, const std::vector<std::string>& defines)
{
    const std::string source = shader_source(file, defines);
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        std::string why(8192, '\0');
        glGetShaderInfoLog(shader, static_cast<GLsizei>(why.size()), nullptr, why.data());
        fmt::print(stderr, "{} ({}): {}\n", file, fmt::join(defines, ", "), why.c_str());
    }
    assert(good && "a shader of ours does not compile");
    return shader;
}

} // namespace

Program::Program(const ProgramName& name) : name_(glCreateProgram())
{
    const std::string vertex = name.vertex + ".vert.glsl", fragment = name.fragment + ".frag.glsl";
    for (const GLuint shader : {compiled(GL_VERTEX_SHADER, vertex, name.defines),
                                compiled(GL_FRAGMENT_SHADER, fragment, name.defines)}) {
        glAttachShader(name_, shader);
        glDeleteShader(shader); // lives on with the program
    }
    glLinkProgram(name_);
    GLint good = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &good);
    if (!good) {
        std::string why(8192, '\0');
        glGetProgramInfoLog(name_, static_cast<GLsizei>(why.size()), nullptr, why.data());
        fmt::print(stderr, "{} + {}: {}\n", vertex, fragment, why.c_str());
    }
    assert(good && "a program of ours does not link");
}

Program::Program(Program&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      locations_(std::move(other.locations_))
{
}

Program& Program::operator=(Program&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(locations_, other.locations_);
    return *this;
}

Program::~Program()
{
    if (name_) glDeleteProgram(name_);
}

void Program::use() const
{
    glUseProgram(name_);
}

int Program::location(const char* uniform) const
{
    const auto found = locations_.find(uniform);
    if (found != locations_.end()) return found->second;
    return locations_[uniform] = glGetUniformLocation(name_, uniform);
}

void Program::set(const char* uniform, int value) const
{
    glUniform1i(location(uniform), value);
}
void Program::set(const char* uniform, unsigned value) const
{
    glUniform1ui(location(uniform), value);
}
void Program::set(const char* uniform, float value) const
{
    glUniform1f(location(uniform), value);
}
void Program::set(const char* uniform, glm::vec2 value) const
{
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) const
{
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, std::span<const glm::vec4> values) const
{
    glUniform4fv(location(uniform), static_cast<GLsizei>(values.size()),
                 glm::value_ptr(values.front()));
}
void Program::set(const char* uniform, const glm::mat3& value) const
{
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const
{
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

const Program& Programs::use(const ProgramName& name)
{
    auto found = compiled_.find(name);
    if (found == compiled_.end()) found = compiled_.emplace(name, Program(name)).first;
    found->second.use();
    return found->second;
}

} // namespace trivar::gpu
