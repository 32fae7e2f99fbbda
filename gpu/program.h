// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "gpu/shader_source.h"

#include <glm/glm.hpp>
#include <map>
#include <span>

namespace trivar::gpu {

// A Program is a linked GL program. Its uniforms are set by name while it is in use; a name that
// the compiler dropped is ignored, as GL does.
class Program {
public:
    // Throws Rejected where a driver does not accept it.
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

// Programs holds the programs compiled so far; each is compiled once, when it is first needed.
class Programs {
public:
    // Makes the program current and returns it.
    const Program& use(const ProgramName& name);

    // Replaces the embedded texts; null: none is replaced. Programs whose texts change are compiled
    // anew; where that fails, the earlier program or the embedded text stays in use.
    void take(const Ref<ShaderTexts>& texts);
    // A sentence that says why a program does not follow the texts; empty: all do.
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
