// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string>
#include <string_view>

namespace trivar {

// Decodes any format OpenImageIO knows into 8-bit RGBA. Throws Rejected; refuses sides above
// 16384 pixels before allocating.
Image read_image(const std::string& path);
Image read_image_bytes(std::string_view bytes, const std::string& name);

// The bytes of a picture file of the kind that the extension (.png, .jpg, .exr, ...) names. Throws
// Rejected.
std::string encoded_image(const Image& image, const std::string& extension);

// Throws Rejected where the name ends as no picture does that can be written.
void check_picture_name(const std::string& path);

// Writes by extension (png, jpg, exr, ...), through a temporary file. Throws Rejected.
void write_image(const Image& image, const std::string& path);

} // namespace trivar
