// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/volume_options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The names of ordinary files in a folder, sorted. Throws Rejected for more than 20,000.
std::vector<std::string> files_in(const std::string& folder);

// Reads the series of a folder that has the most slices, or the one that is asked for; the others
// are named in a notice. `names` are the files of the folder. Nothing where none is a DICOM file
// with pixels. Slices lie as slice_order.h says, which has what `time` is; values that are scaled
// differently from slice to slice become floats. Of a series those slices are taken that have one
// size, type, direction and distance of pixels: those that go with the file `chosen`, or else the
// most. Files that are left out or cannot be read are named in notices. Throws Rejected.
std::optional<ReadVolume> read_dicom_folder(const std::string& folder,
                                            const std::vector<std::string>& names,
                                            const ReadVolumeOptions& options, int time,
                                            const Progress& progress,
                                            const std::string& chosen = {});

// Reads a DICOM file: its frames, or where it has a single one its series in the folder.
ReadVolume read_dicom_bytes(std::string_view bytes, const std::string& name,
                            const std::string& folder, const ReadVolumeOptions& options, int time,
                            const Progress& progress);

// Describes the DICOM files of a folder, one line for each series: "skull, CT, 120 slices". Empty
// if there are none.
std::vector<std::string> dicom_series_in(const std::string& folder);

} // namespace trivar
