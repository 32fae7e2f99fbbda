// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar::testing {

// png, jpg, webp, exr, hdr, gif, bmp, tif, tga and dds, as files of these kinds end.
const std::vector<std::string>& picture_extensions();

// Small whole pictures of a kind: what our own encoder makes of one in several ways of packing it,
// and a few made by hand of what it does not write (interlaced, tiled, with a table of colours).
std::vector<std::string> sound_pictures(const std::string& extension);

// The checksum of ISO 3309, which ends the chunks of a PNG.
unsigned png_checksum(std::string_view bytes);

// A number as so many bytes, the least significant first or last.
std::string little(std::size_t number, int count);
std::string big(std::size_t number, int count);

} // namespace trivar::testing
