// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "gpu/shader_source.h"

#include <glm/glm.hpp>
#include <map>
#include <span>

namespace trivar::gpu {

// A linked GL program. Its uniforms are set by name while it is in use; a name the compiler has
// dropped is ignored, as GL does.
class Program {
public:
    // Throws Rejected where a driver does not take it.
    explicit Program(const ProgramName& name, const ShaderTexts* texts = nullptr);
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;
    ~Program();

    void use() const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, unsigned value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, glm::vec2 value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    void set(const char* uniform, std::span<const glm::vec4> values) const; // an array
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;

private:
    unsigned name_ = 0;
    int location(const char* uniform) const;
    mutable std::map<std::string, int, std::less<>> locations_;
};

// The programs compiled so far, each once and when it is first wanted.
class Programs {
public:
    // Makes the program current and returns it.
    const Program& use(const ProgramName& name);

    // Texts in place of the embedded ones; null: none. What they change is compiled anew, and what
    // then does not compile stays as it was, or is taken from the embedded text.
    void take(const Ref<ShaderTexts>& texts);
    // Why something is not as the texts say, in a sentence; empty: all is.
    std::string trouble() const;

private:
    struct CompiledProgram {
        Program program;
        Ref<ShaderTexts> from;
        std::string trouble = {};
    };
    CompiledProgram compiled(const ProgramName& name) const;
    Ref<ShaderTexts> texts_;
    std::map<ProgramName, CompiledProgram> compiled_;
};

} // namespace trivar::gpu
