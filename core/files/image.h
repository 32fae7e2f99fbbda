// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/image_tags.h"
#include "core/mesh/deep_image.h"
#include "core/mesh/model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Of all pictures of a model together: 1 GiB of RGBA.
constexpr std::uint64_t max_pixels_per_model = std::uint64_t{1} << 28;

// What the head of a picture's file says; all of its pixels were read, so the file is whole.
struct ImageHead {
    glm::ivec2 size_px{0};
    int bits = 0;   // a channel
    ImageTags tags; // those that were asked for and are there
};

class ApartDecoder;
struct DecodeResult;

// Decodes pictures one after another into 8-bit RGBA: PNG and JPEG here, the other kinds in
// a process of their own that is started for the first of them (pictures/apart.h). Every function
// throws Rejected for what is no whole picture, for sides above 16384 pixels and for more pixels
// than the bytes can hold, before they are allocated.
class PictureReader {
public:
    PictureReader();
    ~PictureReader();
    PictureReader(PictureReader&&) noexcept;
    PictureReader& operator=(PictureReader&&) noexcept;

    Image read(const std::string& path);
    Image read_bytes(std::string_view bytes, const std::string& name);
    ImageHead head(const std::string& path, const std::vector<std::string>& tags);

private:
    DecodeResult decoded(std::string_view bytes, const std::string& name,
                         const std::vector<std::string>& tags,
                         const std::function<void(std::span<const std::uint8_t>)>& take);
    std::unique_ptr<ApartDecoder> apart_;
};

// A single picture, as PictureReader reads it.
Image read_image(const std::string& path);

// Width and height, by the file's head alone. Throws Rejected; what it gives may still be damaged.
glm::ivec2 picture_size(std::string_view bytes, const std::string& name);

// The bytes of a picture file of the kind that the extension (.png, .jpg, .exr, ...) names, 8 bits
// a channel or, of a deep image, 16; in EXR half floats, linear. Equal pictures and tags give equal
// bytes. Throws Rejected.
std::string encoded_image(const Image& image, const std::string& extension,
                          const ImageTags& tags = {});
std::string encoded_image(const DeepImage& image, const std::string& extension,
                          const ImageTags& tags = {});

// Throws Rejected where the name ends as no picture does that can be written.
void check_picture_name(const std::string& path);

// Writes by extension (png, jpg, exr, ...), through a temporary file. Throws Rejected.
void write_image(const Image& image, const std::string& path);

} // namespace trivar
