// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

const std::vector<std::string>& volume_extensions(); // of files that may be volume data
// Whether it may be volume data: a folder, or a file by its name or by its first bytes.
bool is_volume(const std::string& path);
// Whether a file has no head that says how its samples lie, by its name.
bool is_raw_volume(const std::string& path);
// Returns the name of an object that is read from a file: "anatomical" for "anatomical.nii.gz".
std::string volume_name(const std::string& path);

} // namespace trivar
