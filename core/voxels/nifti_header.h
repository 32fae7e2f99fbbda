// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A NiftiHeader is the head of a NIfTI file.
struct NiftiHeader {
    SampleBlock block;
    std::uint64_t volumes = 1; // behind one another: times
    ByteOrder order = ByteOrder::little;
    bool detached = false;         // the samples are in the .img beside the .hdr
    std::uint64_t data_offset = 0; // of the samples in their file
    double slope = 1, intercept = 0;
    VolumeFrame frame;          // LPS, in the file's unit
    double metres_per_unit = 0; // 0: not said
    std::vector<std::string> notices;
};

// Bytes that the longer of both heads has.
inline constexpr std::size_t nifti2_head_bytes = 540;

// Whether bytes begin as the head of a NIfTI-1 (348 bytes) or NIfTI-2 file (540 bytes) does.
bool is_nifti(std::string_view bytes);

// Reads the head of a file for which is_nifti() holds. Where it has a general matrix (sform) that
// spans space, that is taken, else the turn and distances (qform), else the distances alone; a
// notice says where the first two differ. Throws Rejected for anything but one real number at each
// point of a grid of three axes, and of time.
// Source: the NIfTI-1 and NIfTI-2 headers of the NIfTI Data Format Working Group.
NiftiHeader read_nifti_header(std::string_view bytes, const std::string& name);

} // namespace trivar
