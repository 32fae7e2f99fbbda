// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar::gpu {

// A ProgramName is one program: the names of its files gpu/shaders/VERTEX.vert.glsl,
// GEOMETRY.geom.glsl, FRAGMENT.frag.glsl or COMPUTE.comp.glsl, where given, and what its variant
// defines, each "NAME" or "NAME VALUE".
struct ProgramName {
    std::string vertex, fragment;
    std::vector<std::string> defines;
    std::string compute = {};
    // outputs of the vertex shader that are written to buffers
    std::vector<std::string> captured = {};
    std::string geometry = {};
    auto operator<=>(const ProgramName&) const = default;
};

// A ShaderStage is a stage of a program, "vert", "geom", "frag" or "comp", and its file.
struct ShaderStage {
    std::string kind, file;
};
std::vector<ShaderStage> stages(const ProgramName& name);

// The text of a file of gpu/shaders or core/kernel as embedded at build.
std::optional<std::string_view> shader_file(std::string_view name);

// Texts by file name that replace embedded ones.
using ShaderTexts = std::map<std::string, std::string, std::less<>>;

// A ShaderSource is the compiler's input for a file: version, defines, and the text with every
// included file pasted once, at its first inclusion. A file that two branches of an #ifdef need
// must be included before it.
struct ShaderSource {
    struct Place { // of a line of the text
        std::string file;
        int line = 0; // 1 is the first
    };
    std::string text;
    std::vector<Place> places;
    bool operator==(const ShaderSource& other) const { return text == other.text; }
};
// Throws Rejected where an included file does not exist. For an OpenGL older than 43 the text
// enables the extensions that lacking() asks for.
ShaderSource shader_source(const std::string& file, const std::vector<std::string>& defines,
                           const ShaderTexts* texts = nullptr, int gl_version = 43);

// Returns the first error in a compiler's log, or else its first line, as "FILE:LINE: fault", with
// the file in which that line stands.
std::string first_error(const std::string& log, const ShaderSource& source);

} // namespace trivar::gpu
