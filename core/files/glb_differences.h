// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// Numbers may differ by this share of the one expected, and by this much where it is below 1: what
// another compiler's last bits come to.
inline constexpr double glb_number_tolerance = 1e-6;

// What a viewer may show otherwise of a GLB file than of the one that was expected, which
// write_glb() made: a sentence each, at most a handful; none: nothing. Everything counts, whether
// a viewer has to heed it or not, but the file's `extras`: nodes, meshes and their data number by
// number, materials, images, and whatever Trivar does not write (animations, skins, morph targets,
// sparse values ...). Throws Rejected where the file is no GLB.
std::vector<std::string> glb_differences(const std::string& found, const std::string& expected);

} // namespace trivar
