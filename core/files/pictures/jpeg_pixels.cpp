// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/pixels.h"

#include "core/files/codec/grey.h"
#include "core/files/pictures/byte_view.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio> // needed by jpeglib.h
#include <jerror.h>
#include <jpeglib.h>

namespace trivar {
namespace {

struct JpegErrors {
    jpeg_error_mgr manager{}; // must be the first member
    std::jmp_buf out{};
    bool damaged = false, ended = false;
};

void leave_jpeg(j_common_ptr jpeg)
{
    std::longjmp(reinterpret_cast<JpegErrors*>(jpeg->err)->out, 1);
}

// Notes that data is wrong or missing: the decoder fills such places with gray or other colours,
// which must not pass for the picture. Other messages are ignored.
void note_jpeg(j_common_ptr jpeg, int level)
{
    auto& errors = *reinterpret_cast<JpegErrors*>(jpeg->err);
    if (level >= 0) return;
    const int code = errors.manager.msg_code;
    errors.ended = errors.ended || code == JWRN_JPEG_EOF;
    errors.damaged = errors.damaged || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
                     code == JWRN_MUST_RESYNC;
}

// Converts inks to RGB. An ink is inverted, from 255, none, to 0, full, as all programs write it
// since the first one that did.
void rgba_from_inks(const std::vector<std::uint8_t>& inks, std::vector<std::uint8_t>& rgba)
{
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            rgba[i + c] = static_cast<std::uint8_t>(inks[i + c] * inks[i + 3] / 255);
        rgba[i + 3] = 255;
    }
}

struct JpegRows {
    std::vector<std::uint8_t> read, rgba; // one row each, four channels
};

// Decodes the rows. No object with a destructor is made between setjmp and code that may jump.
bool read_jpeg_rows(jpeg_decompress_struct& jpeg, JpegErrors& errors, const DecodeTask& task,
                    JpegRows& rows, const TakeRows& take)
{
    if (setjmp(errors.out) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(task.bytes.data()),
                 static_cast<unsigned long>(task.bytes.size()));
    if (jpeg_read_header(&jpeg, TRUE) != JPEG_HEADER_OK) return false;
    const bool inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    jpeg.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
    const bool several_scans = jpeg_has_multiple_scans(&jpeg) != 0;
    jpeg_start_decompress(&jpeg);
    if (glm::ivec2(jpeg.output_width, jpeg.output_height) != task.size_px ||
        jpeg.output_components != 4)
        return false;
    while (jpeg.output_scanline < jpeg.output_height && !errors.damaged) {
        std::uint8_t* row = rows.read.data();
        jpeg_read_scanlines(&jpeg, &row, 1);
        if (inks) rgba_from_inks(rows.read, rows.rgba);
        const std::vector<std::uint8_t>& row_rgba = inks ? rows.rgba : rows.read;
        if (task.numbers)
            take(grey_bytes<std::uint8_t>(row_rgba, 4, 255));
        else
            take(row_rgba);
    }
    if (!errors.damaged) jpeg_finish_decompress(&jpeg);
    return !errors.damaged && !(errors.ended && several_scans);
}

} // namespace

DecodeResult jpeg_pixels(const DecodeTask& task, const TakeRows& take)
{
    JpegErrors errors;
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = leave_jpeg;
    errors.manager.emit_message = note_jpeg;
    JpegRows rows;
    rows.read.resize(4 * static_cast<std::size_t>(task.size_px.x));
    rows.rgba.resize(rows.read.size());
    DecodeResult decoded;
    try {
        decoded = {read_jpeg_rows(jpeg, errors, task, rows, take), 8, {}};
    } catch (...) { // of `take`
        jpeg_destroy_decompress(&jpeg);
        throw;
    }
    jpeg_destroy_decompress(&jpeg);
    if (!decoded.whole && errors.ended) ByteView{task.bytes}.part(task.bytes.size(), 1);
    return decoded;
}

} // namespace trivar
