// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/codec/decode.h"

#include "core/files/codec/grey.h"
#include "core/files/color.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace trivar {
namespace {

// Converts gray, gray-alpha, RGB or more channels to RGBA.
template <class T>
std::vector<T> to_rgba(const std::vector<T>& pixels, std::size_t channels, T full)
{
    std::vector<T> rgba(pixels.size() / channels * 4);
    for (std::size_t i = 0; 4 * i < rgba.size(); ++i) {
        const T* p = pixels.data() + i * channels;
        const bool gray = channels < 3;
        rgba[4 * i] = p[0];
        rgba[4 * i + 1] = gray ? p[0] : p[1];
        rgba[4 * i + 2] = gray ? p[0] : p[2];
        rgba[4 * i + 3] = channels == 2 ? p[1] : channels > 3 ? p[3] : full;
    }
    return rgba;
}

std::vector<std::uint8_t> display_bytes(const std::vector<float>& linear)
{
    std::vector<std::uint8_t> bytes(linear.size());
    for (std::size_t i = 0; i < linear.size(); ++i) {
        float value = linear[i] > 0 ? std::min(linear[i], 1.0f) : 0.0f; // NaN becomes 0
        if (i % 4 != 3) value = srgb_from_linear(value);
        bytes[i] = static_cast<std::uint8_t>(std::lround(value * 255));
    }
    return bytes;
}

// Number of rows per step: only these are in memory besides the picture itself.
constexpr int scanlines_at_a_time = 64;

template <class T>
bool read_rows(OIIO::ImageInput& input, T full, OIIO::TypeDesc type, bool numbers,
               const TakeRows& take)
{
    const OIIO::ImageSpec spec = input.spec();
    const int channels = std::min(spec.nchannels, 4), bottom = spec.y + spec.height;
    const int step = spec.tile_width > 0 ? spec.tile_height : scanlines_at_a_time;
    const auto row = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels);
    std::vector<T> pixels;
    for (int y = spec.y, end; y < bottom; y = end) {
        end = std::min(y + step, bottom);
        pixels.resize(row * static_cast<std::size_t>(end - y));
        const bool read =
            spec.tile_width > 0
                ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, y, end, spec.z, spec.z + 1, 0,
                                   channels, type, pixels.data())
                : input.read_scanlines(0, 0, y, end, spec.z, 0, channels, type, pixels.data());
        if (!read) return false;
        if constexpr (std::is_same_v<T, float>)
            if (numbers) { // integers fill 0 to 1 already
                take(grey_bytes<float>(pixels, static_cast<std::size_t>(channels), 1));
                continue;
            }
        const std::vector<T> rgba = to_rgba(pixels, static_cast<std::size_t>(channels), full);
        if constexpr (std::is_same_v<T, float>)
            take(display_bytes(rgba));
        else
            take(rgba);
    }
    return true;
}

} // namespace

DecodeResult decode_picture(const DecodeTask& task, const TakeRows& take)
try {
    OIIO::Filesystem::IOMemReader memory(task.bytes.data(), task.bytes.size());
    const auto input = OIIO::ImageInput::create(task.format, false);
    OIIO::ImageSpec hints, spec;
    hints.attribute("oiio:UnassociatedAlpha", 1); // the alpha of glTF is not premultiplied
    if (!input || !input->supports("ioproxy")) return {};
    OIIO::Filesystem::IOProxy* proxy = &memory;
    hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    input->set_ioproxy(proxy);
    if (!input->open("picture", spec, hints)) {
        input->geterror(); // clears the message
        return {};
    }
    if (glm::ivec2(spec.width, spec.height) != task.size_px || spec.depth > 1 || spec.nchannels < 1)
        return {};
    DecodeResult decoded{true, static_cast<int>(8 * spec.format.size()), {}};
    for (const std::string& tag : task.tags)
        if (const std::string words(spec.get_string_attribute(tag)); !words.empty())
            decoded.tags.emplace_back(tag, words);
    decoded.whole = task.numbers || spec.format.is_floating_point()
                        ? read_rows(*input, 1.0f, OIIO::TypeDesc::FLOAT, task.numbers, take)
                        : read_rows(*input, std::uint8_t{255}, OIIO::TypeDesc::UINT8, false, take);
    if (!decoded.whole) input->geterror();
    return decoded;
} catch (const std::exception&) { // of the library, or out of memory
    return {};
}

} // namespace trivar
