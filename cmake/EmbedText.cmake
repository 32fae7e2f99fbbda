# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFILES="a;b" -DOUT=x.cpp -P EmbedText.cmake: writes the files' text into a C++ source that defines
# trivar::gpu::shader_file().
set(entries "")
foreach(path ${FILES})
  file(READ ${path} text)
  get_filename_component(name ${path} NAME)
  string(APPEND entries "    if (name == \"${name}\")\n        return R\"GLSL(${text})GLSL\";\n")
endforeach()
file(WRITE ${OUT} "// Generated from gpu/shaders; edit those.
#include \"gpu/shader_source.h\"

namespace trivar::gpu {

std::optional<std::string_view> shader_file(std::string_view name)
{
${entries}    return std::nullopt;
}

} // namespace trivar::gpu
")
