// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar::gpu {

// One program of the renderer: files gpu/shaders/VERTEX.vert.glsl and FRAGMENT.frag.glsl, and the
// names its variant defines, each "NAME" or "NAME VALUE".
struct ProgramName {
    std::string vertex, fragment;
    std::vector<std::string> defines;
    auto operator<=>(const ProgramName&) const = default;
};

// The text of a file of gpu/shaders as embedded at build; asserts that there is one.
std::string_view shader_file(std::string_view name);

// What the compiler is given for a file: version, defines, and the text with every file it includes
// pasted once, where it is first named: what two branches of an #ifdef need is included before it.
std::string shader_source(const std::string& file, const std::vector<std::string>& defines);

} // namespace trivar::gpu
