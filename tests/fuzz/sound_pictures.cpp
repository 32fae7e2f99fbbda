// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sound_pictures.h"

#include "core/files/pictures/image.h"
#include "editor/viewport/way_comparison.h"

#include <algorithm>
#include <map>

namespace trivar::testing {
namespace {

using Strings = std::vector<std::string>;

Image speckled(glm::ivec2 size_px)
{
    Image image;
    image.size_px = size_px;
    for (int i = 0; i < size_px.x * size_px.y * 4; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 - i % 64 : i * i / 7 + i));
    return image;
}

// It takes few bytes for many pixels.
Image blank(glm::ivec2 size_px)
{
    Image image;
    image.size_px = size_px;
    image.rgba.assign(4 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y),
                      255);
    return image;
}

// The ways of packing that the encoder has, as it calls them.
const std::map<std::string, std::vector<ImageTags>>& ways()
{
    static const std::map<std::string, std::vector<ImageTags>> all{
        {"png", {{}}},
        {"jpg", {{}, {{"jpeg:progressive", "1"}}}},
        {"webp", {{}, {{"compression", "lossless"}}}},
        {"exr",
         {{{"compression", "none"}},
          {{"compression", "rle"}},
          {{"compression", "zips"}},
          {{"compression", "zip"}},
          {{"compression", "piz"}},
          {{"compression", "pxr24"}},
          {{"compression", "b44a"}},
          {{"compression", "dwaa"}}}},
        {"hdr", {{}}},
        {"gif", {{}}},
        {"bmp", {{}}},
        {"tif",
         {{{"compression", "none"}},
          {{"compression", "lzw"}},
          {{"compression", "zip"}},
          {{"compression", "packbits"}}}},
        {"tga", {{}, {{"compression", "rle"}}}}};
    return all;
}

std::string chunk(const std::string& name, const std::string& data)
{
    return big(data.size(), 4) + name + data + big(png_checksum(name + data), 4);
}

// 8 x 8, gray, in the seven passes of Adam7, not packed.
std::string interlaced_png()
{
    std::string rows;
    for (const auto& [wide, high] :
         {std::pair{1, 1}, {1, 1}, {2, 1}, {2, 2}, {4, 2}, {4, 4}, {8, 4}})
        for (int row = 0; row < high; ++row) {
            rows += '\0'; // no filter
            for (int i = 0; i < wide; ++i) rows += static_cast<char>(20 * row + 30 * i);
        }
    std::size_t a = 1, b = 0; // Adler's checksum
    for (const char c : rows) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const std::string packed = "\x78\x01\x01" + little(rows.size(), 2) +
                               little(0xffff - rows.size(), 2) + rows + big(b << 16 | a, 4);
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big(8, 4) + big(8, 4) + std::string("\x08\0\0\0\1", 5)) +
           chunk("IDAT", packed) + chunk("IEND", "");
}

// 40 x 24, gray in halves, tiles of 16 x 16, not packed.
std::string tiled_exr()
{
    const auto attribute = [](const std::string& name, const std::string& type,
                              const std::string& value) {
        return name + '\0' + type + '\0' + little(value.size(), 4) + value;
    };
    const std::string window = little(0, 8) + little(39, 4) + little(23, 4);
    std::string out = "v/1\x01" + little(0x202, 4) +
                      attribute("channels", "chlist",
                                std::string("Y\0", 2) + little(1, 4) + little(0, 4) + little(1, 4) +
                                    little(1, 4) + '\0') +
                      attribute("compression", "compression", little(0, 1)) +
                      attribute("dataWindow", "box2i", window) +
                      attribute("displayWindow", "box2i", window) +
                      attribute("lineOrder", "lineOrder", little(0, 1)) +
                      attribute("pixelAspectRatio", "float", little(0x3f800000, 4)) +
                      attribute("screenWindowCenter", "v2f", little(0, 8)) +
                      attribute("screenWindowWidth", "float", little(0x3f800000, 4)) +
                      attribute("tiles", "tiledesc", little(16, 4) + little(16, 4) + '\0') + '\0';
    std::string tiles;
    const std::size_t begin = out.size() + 6 * 8;
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
            out += little(begin + tiles.size(), 8);
            const std::size_t halves = (x < 2 ? 16 : 8) * (y < 1 ? 16 : 8);
            tiles += little(x, 4) + little(y, 4) + little(0, 8) + little(2 * halves, 4);
            for (std::size_t i = 0; i < halves; ++i) tiles += little(0x3800 + 5 * i, 2);
        }
    return out + tiles;
}

std::string dds(std::uint32_t flags, const std::string& packing, const std::string& masks,
                const std::string& pixels)
{
    return "DDS " + little(124, 4) + little(0x1007, 4) + little(16, 4) + little(16, 4) +
           std::string(56, '\0') + little(32, 4) + little(flags, 4) + packing + masks +
           little(0x1000, 4) + std::string(16, '\0') + pixels;
}

// Two frames of 37 x 21 behind one another.
std::string moving_webp()
{
    const std::string still =
        encoded_image(speckled({37, 21}), ".webp", {{"compression", "lossless"}});
    const std::string pixels = still.substr(12); // one chunk, of an even length with its padding
    const std::string size = little(36, 3) + little(20, 3);
    const std::string frame = little(0, 6) + size + little(100, 3) + '\0' + pixels;
    std::string body =
        "WEBPVP8X" + little(10, 4) + little(0x12, 4) + size + "ANIM" + little(6, 4) + little(0, 6);
    for (int i = 0; i < 2; ++i) body += "ANMF" + little(frame.size(), 4) + frame;
    return "RIFF" + little(body.size(), 4) + body;
}

Strings made_by_hand(const std::string& extension)
{
    std::string ramp;
    for (int i = 0; i < 1024; ++i) ramp += static_cast<char>(i * 7);
    if (extension == "png") return {interlaced_png()};
    if (extension == "webp") return {moving_webp()};
    if (extension == "exr") return {tiled_exr()};
    if (extension == "bmp") { // 8 x 8, a table of 16 colours; plain, and packed in runs
        const auto bmp = [&](std::size_t packing, const std::string& pixels) {
            return "BM" + little(118 + pixels.size(), 4) + little(0, 4) + little(118, 4) +
                   little(40, 4) + little(8, 4) + little(8, 4) + little(1, 2) +
                   little(packing == 1 ? 8 : 4, 2) + little(packing, 4) + little(pixels.size(), 4) +
                   little(0, 8) + little(16, 4) + little(0, 4) + ramp.substr(0, 64) + pixels;
        };
        std::string runs;
        for (int row = 0; row < 8; ++row)
            runs += std::string("\x05\x03\x03\x07", 4) + '\0' + (row < 7 ? '\0' : '\1');
        return {bmp(0, ramp.substr(0, 32)), bmp(1, runs)};
    }
    if (extension == "tga") // 8 x 8, a table of 16 colours
        return {std::string("\0\1\1\0\0\x10\0\x18\0\0\0\0", 12) + little(8, 2) + little(8, 2) +
                little(8, 2) + ramp.substr(0, 48) + std::string(64, '\3')};
    if (extension == "dds") {
        const std::string none = little(0, 8) + little(0, 8),
                          bits24 = little(24, 4) + little(0xff0000, 4) + little(0xff00, 4) +
                                   little(0xff, 4) + little(0, 4);
        const std::string second =
            little(98, 4) + little(3, 4) + little(0, 4) + little(1, 4) + little(0, 4);
        return {dds(4, "DXT1", little(0, 4) + none, ramp.substr(0, 128)),
                dds(4, "DXT5", little(0, 4) + none, ramp.substr(0, 256)),
                dds(4, "ATI2", little(0, 4) + none, ramp.substr(0, 256)),
                dds(4, "DX10", little(0, 4) + none, second + ramp.substr(0, 256)),
                dds(0x40, little(0, 4), bits24, ramp.substr(0, 768))};
    }
    return {};
}

} // namespace

unsigned png_checksum(std::string_view bytes)
{
    unsigned crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1 ? 0xedb88320u : 0u) ^ crc >> 1;
    }
    return ~crc;
}

std::string little(std::size_t number, int count)
{
    std::string out;
    for (int i = 0; i < count; ++i) out += static_cast<char>(number >> 8 * i & 0xff);
    return out;
}

std::string big(std::size_t number, int count)
{
    std::string out = little(number, count);
    std::ranges::reverse(out);
    return out;
}

const Strings& picture_extensions()
{
    static const Strings all{"png", "jpg", "webp", "exr", "hdr", "gif", "bmp", "tif", "tga", "dds"};
    return all;
}

Strings sound_pictures(const std::string& extension)
{
    Strings out = made_by_hand(extension);
    if (const auto found = ways().find(extension); found != ways().end())
        for (const ImageTags& tags : found->second)
            for (const Image& image : {speckled({37, 21}), speckled({3, 40}), blank({1024, 512})})
                out.push_back(encoded_image(image, "." + extension, tags));
    return out;
}

} // namespace trivar::testing
