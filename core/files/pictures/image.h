// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/pictures/image_tags.h"
#include "core/mesh/deep_image.h"
#include "core/mesh/grey_image.h"
#include "core/mesh/model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The largest number of pixels in all pictures of a model together: 1 GiB of RGBA.
constexpr std::uint64_t max_pixels_per_model = std::uint64_t{1} << 28;

// An ImageHead is the head of a picture's file; all of its pixels were read, so the file is
// complete.
struct ImageHead {
    glm::ivec2 size_px{0};
    int bits = 0;   // per channel
    ImageTags tags; // the requested ones that exist
};

class DecoderProcess;
struct DecodeResult;

// A PictureReader decodes pictures one after another into 8-bit RGBA: PNG and JPEG here, the other
// kinds in a process of their own that is started for the first of them (pictures/apart.h). Every
// function throws Rejected for anything that is no complete picture, for sides above 16384 pixels
// and for more pixels than the bytes can hold, before they are allocated.
class PictureReader {
public:
    PictureReader();
    ~PictureReader();
    PictureReader(PictureReader&&) noexcept;
    PictureReader& operator=(PictureReader&&) noexcept;

    Image read(const std::string& path);
    Image read_bytes(std::string_view bytes, const std::string& name);
    GreyImage read_grey(const std::string& path);
    GreyImage read_grey_bytes(std::string_view bytes, const std::string& name);
    ImageHead head(const std::string& path, const std::vector<std::string>& tags);

private:
    DecodeResult decoded(std::string_view bytes, const std::string& name,
                         const std::vector<std::string>& tags,
                         const std::function<void(std::span<const std::uint8_t>)>& take,
                         bool numbers = false);
    std::unique_ptr<DecoderProcess> apart_;
};

// A single picture, as PictureReader reads it.
Image read_image(const std::string& path);

// A picture as numbers and not as colours: 8 and 16 bits from 0 to 1 as they are stored, floating
// point as it is; of colours the luminance. What is no number counts as 0 and is counted. Throws
// Rejected as PictureReader does, and for more than max_grey_pixels.
constexpr std::uint64_t max_grey_pixels = std::uint64_t{1} << 26;
GreyImage read_grey_image(const std::string& path);

// Width and height from the file's head alone. Throws Rejected; the rest of the file may still be
// damaged.
glm::ivec2 picture_size(std::string_view bytes, const std::string& name);

// The bytes of a picture file of the kind that the extension (.png, .jpg, .exr, ...) names, with 8
// bits per channel, or 16 for a deep image; EXR gets half floats, linear. Equal pictures and tags
// give equal bytes. Throws Rejected.
std::string encoded_image(const Image& image, const std::string& extension,
                          const ImageTags& tags = {});
std::string encoded_image(const DeepImage& image, const std::string& extension,
                          const ImageTags& tags = {});

// Throws Rejected where the name's ending is that of no picture that can be written.
void check_picture_name(const std::string& path);

// Writes by extension (png, jpg, exr, ...), through a temporary file. Throws Rejected.
void write_image(const Image& image, const std::string& path);

} // namespace trivar
