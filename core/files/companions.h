// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// The other files that a model needs: buffers and images of a .gltf or .glb, material libraries of
// an .obj with all their pictures. They are found as the readers find them, and named by their path
// in the model's folder, with '/', so that each can be opened from there; each once, sorted.
// Missing files are left out. Throws Rejected where the model itself cannot be read.
std::vector<std::string> companions_of(const std::string& path);

} // namespace trivar
