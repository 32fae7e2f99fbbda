// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// GlbViews are the places of both chunks of a GLB file. The data may be missing or empty; chunks of
// other kinds are skipped, as the format demands.
struct GlbViews {
    std::string_view json;
    std::optional<std::string_view> binary;
};

// Throws Rejected, without the file's name, where the file or a chunk is cut off or is not glTF 2,
// or where the JSON is nested too deep to be read.
GlbViews glb_views(std::string_view bytes);

// GlbChunks are the chunks as values that can be changed and written again.
struct GlbChunks {
    std::string json, binary;
};

// Copies the chunks that glb_views() finds. To check that the rest of the file follows the format,
// compare it with glb_container() of the same chunks.
GlbChunks glb_chunks(std::string_view bytes);

// The file of two chunks, each filled up to a multiple of four bytes. Throws Rejected above 4 GB.
std::string glb_container(const GlbChunks& chunks);

} // namespace trivar
