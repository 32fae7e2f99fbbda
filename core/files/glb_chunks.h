// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// The two chunks of a GLB file. The data may be missing.
struct GlbChunks {
    std::string json, binary;
};

// Throws Rejected where a chunk is cut off or the JSON is nested too deep to be read. Whether
// all else is as the format has it, glb_container() of the same chunks tells.
GlbChunks glb_chunks(std::string_view bytes);

// The file of two chunks, each filled up to a multiple of four bytes. Throws Rejected above 4 GB.
std::string glb_container(const GlbChunks& chunks);

} // namespace trivar
