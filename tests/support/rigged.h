// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar::testing {

// A square bar of 4 x 1 x 1 along x, with tangents. A skin of two joints, "root" at x = 0 and "tip"
// at x = 2, bends it in the middle; a morph target makes it thicker there. Clips of one second:
// "bend" turns the tip by a right angle about z, "swell" takes the weight of the target from 0
// to 1.
Model rigged_model();

// A model's first mesh with skins, targets and clips as glTF text; channels of rotations and
// weights only.
std::string gltf_text(const Model& model);
std::string base64(const std::string& bytes);

} // namespace trivar::testing
