// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/inflate.h"
#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

enum class NrrdEncoding { raw, gzip, bzip2, ascii, hex };

// An NrrdHeader is the head of an NRRD file.
struct NrrdHeader {
    SampleBlock block;
    std::uint64_t volumes = 1; // times or layers,
    std::uint64_t in_turn = 1; // so many samples of each in turn
    NrrdEncoding encoding = NrrdEncoding::raw;
    ByteOrder order = ByteOrder::little;
    VolumeFrame frame;          // LPS where the file tells its space, else as the file has it
    double metres_per_unit = 0; // 0: not said
    std::size_t line_skip = 0;  // before the data of each file
    std::int64_t byte_skip =
        0; // after lines and unpacking; -n: so that n - 1 bytes stay at the end
    std::vector<std::string> data_files; // names; none: the data follow the head
    std::size_t size = 0;                // bytes of the head, with the empty line at its end
    std::vector<std::string> notices;    // sentences without the name of the file
};

// Reads the head with teem, which opens no other file here. Throws Rejected for anything but one
// number at each point of a grid of three axes.
NrrdHeader read_nrrd_header(std::string_view bytes, const std::string& name);

} // namespace trivar
