// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/pixels.h"

#include "core/files/codec/grey.h"
#include "core/files/pictures/kinds.h"
#include "core/files/pictures/png_chunks.h"

#include <csetjmp>
#include <cstring>
#include <png.h>

namespace trivar {
namespace {

void leave_png(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}
void say_nothing(png_structp, png_const_charp) {}

void take_png_bytes(png_structp png, png_bytep to, std::size_t count)
{
    auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (count > left.size()) png_error(png, "");
    std::memcpy(to, left.data(), count);
    left.remove_prefix(count);
}

// Asks the library to convert all pixels to RGBA with 8 bits per channel; of numbers with 16.
void ask_for_rgba(png_structp png, png_infop info, bool numbers)
{
    png_set_expand(png); // palettes, fewer bits, one transparent colour
    if (numbers) {
        png_set_expand_16(png);
        png_set_swap(png);
    } else
        png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, numbers ? 0xffff : 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

// Rows of RGBA with 8 bits, or of numbers from 16 bits.
void take_png_rows(const std::vector<std::uint8_t>& rows, bool numbers, const TakeRows& take)
{
    if (!numbers) return take(rows);
    const std::span deep(reinterpret_cast<const std::uint16_t*>(rows.data()), rows.size() / 2);
    take(grey_bytes<std::uint16_t>(deep, 4, 65535));
}

// Decodes the rows. No object with a destructor is made between setjmp and code that may jump.
bool read_rows(png_structp png, png_infop info, const DecodeTask& task,
               std::vector<std::uint8_t>& rows, const TakeRows& take)
{
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    // Chunks other than size, palette, transparency and pixels are not used: profiles, dates, text.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png, info);
    ask_for_rgba(png, info, task.numbers);
    const std::size_t row = (task.numbers ? 8 : 4) * static_cast<std::size_t>(task.size_px.x);
    if (png_get_rowbytes(png, info) != row) return false;
    if (png_get_interlace_type(png, info) == PNG_INTERLACE_NONE) {
        rows.resize(row);
        for (int y = 0; y < task.size_px.y; ++y) {
            png_read_row(png, rows.data(), nullptr);
            take_png_rows(rows, task.numbers, take);
        }
    } else {
        rows.resize(row * static_cast<std::size_t>(task.size_px.y));
        constexpr int passes = 7;
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t at = 0; at < rows.size(); at += row)
                png_read_row(png, rows.data() + at, nullptr);
        take_png_rows(rows, task.numbers, take);
    }
    png_read_end(png, nullptr);
    return true;
}

} // namespace

DecodeResult png_pixels(const DecodeTask& task, const TakeRows& take)
{
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_png, say_nothing);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info) {
        png_destroy_read_struct(&png, nullptr, nullptr);
        return {};
    }
    std::string_view left = task.bytes;
    png_set_read_fn(png, &left, take_png_bytes);
    std::vector<std::uint8_t> rows;
    DecodeResult decoded;
    try {
        decoded.whole = read_rows(png, info, task, rows, take);
    } catch (...) { // of `take`
        png_destroy_read_struct(&png, &info, nullptr);
        throw;
    }
    decoded.bits = png_head({task.bytes}, Look::head_only).bytes_a_channel * 8;
    png_destroy_read_struct(&png, &info, nullptr);
    for (const std::string& tag : task.tags)
        if (const std::string words = png_text(task.bytes, tag); !words.empty())
            decoded.tags.emplace_back(tag, words);
    return decoded;
}

} // namespace trivar
