// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"
#include "core/files/pictures/byte_view.h"

#include <glm/glm.hpp>
#include <string>

namespace trivar {

// A PictureHead holds the facts of a picture before a pixel of it is decoded.
struct PictureHead {
    glm::ivec2 size_px{0};
    int channels = 4;
    int bytes_a_channel = 1; // while they are decoded
};

// Reads the head of a file of one kind. With head_only the file may be incomplete; with whole,
// everything that is declared must be there. Throws Rejected, with the rest of a sentence.
enum class Look { head_only, whole };
using ReadHead = PictureHead (*)(const ByteView& file, Look look);

PictureHead png_head(const ByteView& file, Look look);
PictureHead jpeg_head(const ByteView& file, Look look);
PictureHead webp_head(const ByteView& file, Look look);
PictureHead exr_head(const ByteView& file, Look look);
PictureHead hdr_head(const ByteView& file, Look look);
PictureHead gif_head(const ByteView& file, Look look);
PictureHead bmp_head(const ByteView& file, Look look);
PictureHead tiff_head(const ByteView& file, Look look);
PictureHead dds_head(const ByteView& file, Look look);
PictureHead tga_head(const ByteView& file, Look look);

using DecodeHere = DecodeResult (*)(const DecodeTask& task, const TakeRows& take);

struct PictureKind {
    const char* word;   // PNG, JPEG, ...
    const char* format; // as OpenImageIO calls it
    const char* mime;
    ReadHead head;
    DecodeHere decode; // null: in a process of its own, which may fail without harm
};

// The kind by the first bytes: an embedded picture has no file name, and names may be wrong. TGA
// alone has no first bytes and goes by its name. Throws Rejected with a sentence.
const PictureKind& picture_kind(std::string_view bytes, const std::string& name);

// Its head, with a size that may be decoded: sides up to 16384 pixels, and pixels in some
// proportion to the bytes that say them. Throws Rejected with a sentence.
PictureHead picture_head(std::string_view bytes, const std::string& name, Look look);

} // namespace trivar
