// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A MetaHeader is the head of a MetaImage.
struct MetaHeader {
    SampleBlock block;
    std::uint64_t volumes = 1; // behind one another: times
    ByteOrder order = ByteOrder::little;
    bool binary = true, packed = false; // packed: by zlib
    std::int64_t header_bytes = 0; // before the samples of a file; -1: these are its last bytes
    double slope = 1, intercept = 0;
    VolumeFrame frame;                   // LPS, as ITK understands it
    std::vector<std::string> data_files; // none: the samples follow the head
    std::size_t size = 0;                // bytes of the head
    std::vector<std::string> notices;
};

// Whether bytes begin as such a head does.
bool is_meta_image(std::string_view bytes);

// Throws Rejected for anything but one number at each point of a grid of three axes.
// Source: the MetaIO documentation of ITK.
MetaHeader read_meta_header(std::string_view bytes, const std::string& name);

} // namespace trivar
