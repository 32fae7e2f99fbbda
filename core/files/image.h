// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/deep_image.h"
#include "core/mesh/model.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trivar {

// Decodes any format OpenImageIO knows into 8-bit RGBA. Throws Rejected; refuses sides above
// 16384 pixels before allocating.
Image read_image(const std::string& path);
Image read_image_bytes(std::string_view bytes, const std::string& name);

// Width and height, by the file's head alone. Throws Rejected; what it gives may still be damaged.
glm::ivec2 picture_size(std::string_view bytes, const std::string& name);

// What a picture's file says beside its pixels: names and words.
using ImageTags = std::vector<std::pair<std::string, std::string>>;

// The bytes of a picture file of the kind that the extension (.png, .jpg, .exr, ...) names, 8 bits
// a channel or, of a deep image, 16; in EXR half floats, linear. Equal pictures and tags give equal
// bytes. Throws Rejected.
std::string encoded_image(const Image& image, const std::string& extension,
                          const ImageTags& tags = {});
std::string encoded_image(const DeepImage& image, const std::string& extension,
                          const ImageTags& tags = {});

// What the head of a picture's file says; all of its pixels were read, so the file is whole.
struct ImageHead {
    glm::ivec2 size_px{0};
    int bits = 0;   // a channel
    ImageTags tags; // those that were asked for and are there
};
ImageHead image_head(const std::string& path, const std::vector<std::string>& tags);

// Throws Rejected where the name ends as no picture does that can be written.
void check_picture_name(const std::string& path);

// Writes by extension (png, jpg, exr, ...), through a temporary file. Throws Rejected.
void write_image(const Image& image, const std::string& path);

} // namespace trivar
