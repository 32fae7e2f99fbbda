// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A VtiHeader is the description, in the XML of a VTK image data file, of the array that is its
// volume.
struct VtiHeader {
    enum class Format { ascii, base64, appended_raw, appended_base64 };
    SampleBlock block;
    ByteOrder order = ByteOrder::little;
    bool packed = false;         // by zlib, in blocks
    std::size_t count_bytes = 4; // of the numbers before the data: 4 or 8
    Format format = Format::ascii;
    std::string text;         // the samples where they stand in the XML
    std::uint64_t offset = 0; // where they begin in the appended data
    std::size_t appended = 0; // where these begin in the file, behind '_'
    VolumeFrame frame;
    std::vector<std::string> notices;
};

// Whether bytes begin as such a file does.
bool is_vti(std::string_view bytes);

// Throws Rejected for anything but one number at each point of a grid of three axes in one piece.
VtiHeader read_vti_header(std::string_view bytes, const std::string& name);

} // namespace trivar
