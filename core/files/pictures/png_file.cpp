// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/pixels.h"

#include <bit>
#include <csetjmp>
#include <png.h>

namespace trivar {
namespace {

void leave_png_file(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}
void warn_of_nothing(png_structp, png_const_charp) {}

void keep_png_bytes(png_structp png, png_bytep bytes, std::size_t count)
{
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(bytes), count);
}

template <class Channel>
bool write_rows(png_structp png, png_infop info, const EncodeTask& task,
                std::span<const Channel> rgba, std::vector<png_text_struct>& texts)
{
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const auto wide = static_cast<png_uint_32>(task.size_px.x);
    png_set_IHDR(png, info, wide, static_cast<png_uint_32>(task.size_px.y), 8 * sizeof(Channel),
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
    if (sizeof(Channel) == 2 && std::endian::native == std::endian::little) png_set_swap(png);
    for (std::size_t at = 0; at < rgba.size(); at += 4 * std::size_t{wide})
        png_write_row(png, reinterpret_cast<png_const_bytep>(rgba.data() + at));
    png_write_end(png, info);
    return true;
}

} // namespace

std::string png_file(const EncodeTask& task)
{
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_png_file, warn_of_nothing);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    std::string bytes;
    std::vector<png_text_struct> texts;
    for (const auto& [tag, words] : task.tags) {
        png_text_struct text{};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(tag.c_str());
        text.text = const_cast<char*>(words.c_str());
        text.text_length = words.size();
        texts.push_back(text);
    }
    bool written = false;
    if (info) {
        png_set_write_fn(png, &bytes, keep_png_bytes, nullptr);
        written = task.deep.empty() ? write_rows(png, info, task, task.rgba, texts)
                                    : write_rows(png, info, task, task.deep, texts);
    }
    png_destroy_write_struct(&png, &info);
    return written ? bytes : std::string();
}

} // namespace trivar
