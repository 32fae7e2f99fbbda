// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/shader_source.h"

#include <set>
#include <sstream>

namespace trivar::gpu {
namespace {

std::string pasted(std::string_view name, std::set<std::string, std::less<>>& seen)
{
    if (!seen.emplace(name).second) return {};
    std::istringstream in{std::string(shader_file(name))};
    std::string out, line;
    while (std::getline(in, line)) {
        if (line.starts_with("#include")) {
            const auto from = line.find('"') + 1;
            out += pasted(line.substr(from, line.rfind('"') - from), seen);
        } else {
            out += line + '\n';
        }
    }
    return out;
}

} // namespace

std::vector<ShaderStage> stages(const ProgramName& name)
{
    std::vector<ShaderStage> out;
    const auto add = [&](const std::string& base, const char* kind) {
        if (!base.empty()) out.push_back({kind, base + '.' + kind + ".glsl"});
    };
    add(name.vertex, "vert");
    add(name.geometry, "geom");
    add(name.fragment, "frag");
    add(name.compute, "comp");
    return out;
}

std::string shader_source(const std::string& file, const std::vector<std::string>& defines)
{
    std::string out = "#version 430 core\n";
    for (const std::string& define : defines) out += "#define " + define + '\n';
    std::set<std::string, std::less<>> seen;
    return out + pasted(file, seen);
}

} // namespace trivar::gpu
