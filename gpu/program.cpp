// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/program.h"

#include "core/base/rejected.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

namespace trivar::gpu {
namespace {

GLuint compiled_stage(const ShaderStage& stage, const ShaderSource& source)
{
    const char* text = source.text.c_str();
    const GLuint shader = glCreateShader(stage.kind == "vert"   ? GL_VERTEX_SHADER
                                         : stage.kind == "geom" ? GL_GEOMETRY_SHADER
                                         : stage.kind == "frag" ? GL_FRAGMENT_SHADER
                                                                : GL_COMPUTE_SHADER);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::string why(8192, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(why.size()), nullptr, why.data());
    glDeleteShader(shader);
    throw Rejected("The graphics driver does not compile " + first_error(why, source));
}

std::vector<ShaderSource> sources(const ProgramName& name, const ShaderTexts* texts)
{
    std::vector<ShaderSource> out;
    for (const ShaderStage& stage : stages(name))
        out.push_back(shader_source(stage.file, name.defines, texts));
    return out;
}

// Sends the outputs of the vertex shader to buffers, one each.
void capture(GLuint program, const std::vector<std::string>& outputs)
{
    std::vector<const char*> names;
    for (const std::string& name : outputs) names.push_back(name.c_str());
    glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(),
                                GL_SEPARATE_ATTRIBS);
}

} // namespace

Program::Program(const ProgramName& name, const ShaderTexts* texts) : name_(glCreateProgram())
{
    const int gl_version = epoxy_gl_version();
    try {
        if (!name.compute.empty() && gl_version < 43)
            throw Rejected(fmt::format("Computing on the graphics card needs OpenGL 4.3, this is "
                                       "{}.{}.",
                                       gl_version / 10, gl_version % 10));
        for (const ShaderStage& stage : stages(name)) {
            const GLuint shader =
                compiled_stage(stage, shader_source(stage.file, name.defines, texts, gl_version));
            glAttachShader(name_, shader);
            glDeleteShader(shader); // lives on with the program
        }
        if (!name.captured.empty()) capture(name_, name.captured);
        glLinkProgram(name_);
        GLint good = 0;
        glGetProgramiv(name_, GL_LINK_STATUS, &good);
        if (good) return;
        std::string why(8192, '\0');
        glGetProgramInfoLog(name_, static_cast<GLsizei>(why.size()), nullptr, why.data());
        throw Rejected(fmt::format("The graphics driver does not link {}: {}",
                                   stages(name).front().file, first_error(why, {})));
    } catch (const Rejected&) {
        glDeleteProgram(name_);
        throw;
    }
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
    if (found == compiled_.end()) found = compiled_.emplace(name, compiled(name)).first;
    found->second.program.use();
    return found->second.program;
}

Programs::CompiledProgram Programs::compiled(const ProgramName& name) const
{
    if (!texts_) return {Program(name), nullptr};
    try {
        return {Program(name, texts_.get()), texts_};
    } catch (const Rejected& error) {
        return {Program(name), nullptr, error.what()};
    }
}

void Programs::take(const Ref<ShaderTexts>& texts)
{
    if (texts == texts_) return;
    texts_ = texts;
    for (auto& [name, made] : compiled_) {
        made.trouble.clear();
        try {
            if (sources(name, made.from.get()) != sources(name, texts.get()))
                made = {Program(name, texts.get()), texts};
        } catch (const Rejected& error) {
            made.trouble = error.what();
        }
    }
}

std::string Programs::trouble() const
{
    for (const auto& [name, made] : compiled_)
        if (!made.trouble.empty()) return made.trouble;
    return {};
}

} // namespace trivar::gpu
