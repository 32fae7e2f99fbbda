// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/volume_options.h"

#include <string>
#include <vector>

namespace trivar {

// The pictures of a folder in the order of the last number in their names (slice2.png before
// slice10.png), and by name where that is the same.
std::vector<std::string> pictures_in_order(std::vector<std::string> names);

// Whether a name ends as one of a picture that can be a slice: png, tif, jpg, bmp, exr, ...
bool may_be_slice(const std::string& name);

// Reads pictures in a folder as the slices of a volume, the first at z = 0. All have the size and
// the depth of the first, 8 or 16 bits or floating point, and are grey. Throws Rejected.
ReadVolume read_image_stack(const std::string& folder, const std::vector<std::string>& names,
                            const ReadVolumeOptions& options, const Progress& progress);

} // namespace trivar
