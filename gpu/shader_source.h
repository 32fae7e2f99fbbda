// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar::gpu {

// One program: files gpu/shaders/VERTEX.vert.glsl, GEOMETRY.geom.glsl, FRAGMENT.frag.glsl or
// COMPUTE.comp.glsl, those that are named, and the names its variant defines, each "NAME" or "NAME
// VALUE".
struct ProgramName {
    std::string vertex, fragment;
    std::vector<std::string> defines;
    std::string compute = {};
    std::vector<std::string> captured = {}; // outputs of the vertex shader to write to buffers
    std::string geometry = {};
    auto operator<=>(const ProgramName&) const = default;
};

// The stages of a program: "vert", "geom", "frag" or "comp", and the file.
struct ShaderStage {
    std::string kind, file;
};
std::vector<ShaderStage> stages(const ProgramName& name);

// The text of a file of gpu/shaders or core/kernel as embedded at build.
std::optional<std::string_view> shader_file(std::string_view name);

// Texts by the files' names, which take the place of those embedded.
using ShaderTexts = std::map<std::string, std::string, std::less<>>;

// What the compiler is given for a file: version, defines, and the text with every file it includes
// pasted once, where it is first named: what two branches of an #ifdef need is included before it.
struct ShaderSource {
    struct Place { // of a line of the text
        std::string file;
        int line = 0; // 1 is the first
    };
    std::string text;
    std::vector<Place> places;
    bool operator==(const ShaderSource& other) const { return text == other.text; }
};
// Throws Rejected where a file that is included is nowhere. For OpenGL `gl_version`: what is older
// than 43 is told of the extensions that lacking() asks for.
ShaderSource shader_source(const std::string& file, const std::vector<std::string>& defines,
                           const ShaderTexts* texts = nullptr, int gl_version = 43);

// A compiler's log as "FILE:LINE: what is wrong", and in what file that one is pasted: of its first
// error, or else its first line.
std::string first_error(const std::string& log, const ShaderSource& source);

} // namespace trivar::gpu
