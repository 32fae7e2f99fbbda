// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// The relative tolerance of numbers, and the absolute one below 1: the size of another compiler's
// rounding.
inline constexpr double glb_number_tolerance = 1e-6;

// The visible differences of a GLB file from the expected one, which write_glb() made: a sentence
// each, at most a handful; empty: none. Everything counts except the file's `extras`: nodes, meshes
// and their data number by number, materials, images, and all features that Trivar does not write
// (animations, skins, morph targets, sparse values ...). Throws Rejected where the file is no GLB.
std::vector<std::string> glb_differences(const std::string& found, const std::string& expected);

} // namespace trivar
