// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/volume_options.h"

#include <string>
#include <string_view>

namespace trivar {

// Reads a volume. The format is found by the first bytes, of files without a head by the name:
// NRRD (.nrrd, .nhdr), NIfTI-1 and -2 (.nii, .nii.gz, .hdr with .img), MetaImage (.mha, .mhd),
// legacy VTK structured points (.vtk), VTK image data (.vti), DICOM, raw. A folder is a DICOM
// series, or else a stack of pictures; of a DICOM file with one slice its whole series in the
// folder is read. docs/volumes.md has what is kept and what is refused. Takes memory for the
// samples of the part that is asked for and for a few slices; more where the format cannot be read
// bit by bit: numbers in words or in base64, a DICOM file with many frames. All samples are numbers
// then, and no value is beyond 1e30. Throws Rejected with one sentence, having changed nothing.
// Of several volumes in a file, or slices at one place in a series, which are times, echoes or
// layers, that with the number `time` is read, from 1.
ReadVolume read_volume(const std::string& path, const ReadVolumeOptions& options = {},
                       const Progress& progress = {}, int time = 1);

// Whether a file is a volume, by its first bytes, or by its name if it has no head. No more is
// read.
bool is_volume_file(const std::string& path);

// The same of bytes in memory: `name` is the file's and tells raw files from others; other files
// are read from `folder`, none if it is empty.
ReadVolume read_volume_bytes(std::string_view bytes, const std::string& name,
                             const std::string& folder, const ReadVolumeOptions& options = {},
                             const Progress& progress = {});

} // namespace trivar
