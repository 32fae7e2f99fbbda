// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// Where the two chunks of a GLB file are in it. The data may be missing, and may be empty; chunks
// of other kinds are passed over, as the format wants it.
struct GlbViews {
    std::string_view json;
    std::optional<std::string_view> binary;
};

// Throws Rejected, without the file's name, where the file or a chunk is cut off or is none of glTF
// 2, or the JSON is nested too deep to be read.
GlbViews glb_views(std::string_view bytes);

// The chunks to be changed and written again.
struct GlbChunks {
    std::string json, binary;
};

// As glb_views(). Whether all else is as the format has it, glb_container() of the same chunks
// tells.
GlbChunks glb_chunks(std::string_view bytes);

// The file of two chunks, each filled up to a multiple of four bytes. Throws Rejected above 4 GB.
std::string glb_container(const GlbChunks& chunks);

} // namespace trivar
