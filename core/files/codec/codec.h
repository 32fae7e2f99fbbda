// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/pictures/image_tags.h"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

// This header is the interface of the plugin that holds OpenImageIO: trivar-codec.so, which is
// opened when the first picture is decoded or encoded (pictures/codec_plugin.h). The library brings
// 250 others, which take a seventh of a second and 110 MB to load and which few runs of the program
// need.
namespace trivar {

struct DecodeTask {
    std::string_view bytes;
    std::string format; // as OpenImageIO calls it
    glm::ivec2 size_px; // as the head says
    std::vector<std::string> tags;
    bool numbers = false; // rows are numbers (grey.h), not colours
};

// A TakeRows takes whole rows from the top: RGBA, 8 bits per channel, colours of floating point as
// sRGB; or one float for each pixel, which has four bytes, too.
using TakeRows = std::function<void(std::span<const std::uint8_t>)>;

struct DecodeResult {
    bool whole = false; // false: it is damaged, or has another size
    int bits = 0;       // per channel of the file
    ImageTags tags;     // the requested ones that exist
};

struct EncodeTask {
    glm::ivec2 size_px;
    std::span<const std::uint8_t> rgba;  // either this
    std::span<const std::uint16_t> deep; // or this
    std::string extension;               // with the dot
    const ImageTags& tags;
};

struct Codec {
    DecodeResult (*decode)(const DecodeTask& task, const TakeRows& take);
    std::string (*encode)(const EncodeTask& task); // empty: it could not
    bool (*writes)(const std::string& extension);
    void (*keep_to_one_thread)(); // from now on, in the whole process
};

} // namespace trivar

extern "C" const trivar::Codec trivar_codec; // the symbol that the plugin exports
