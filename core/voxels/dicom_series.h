// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/volume_options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Reads the series of a folder that has the most slices, or the one that is asked for; the others
// are named in a notice. `names` are the files of the folder. Nothing where none is a DICOM file
// with pixels. Slices lie as slice_order.h says; values that are scaled differently from slice to
// slice become floats. Throws Rejected.
std::optional<ReadVolume> read_dicom_folder(const std::string& folder,
                                            const std::vector<std::string>& names,
                                            const ReadVolumeOptions& options,
                                            const Progress& progress);

// Reads a DICOM file: its frames, or where it has a single one its series in the folder.
ReadVolume read_dicom_bytes(std::string_view bytes, const std::string& name,
                            const std::string& folder, const ReadVolumeOptions& options,
                            const Progress& progress);

} // namespace trivar
