// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// The other files that reading a model would open: buffers and images of a .gltf, material
// libraries of an .obj with their textures. Named as from the model's folder, in which all of them
// lie; each once, sorted. What is missing is left out. Throws Rejected where the model cannot be
// read at all.
std::vector<std::string> companions_of(const std::string& path);

} // namespace trivar
