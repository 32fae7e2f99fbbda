// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>

namespace trivar {
namespace {

// Table of the checksum: the polynomial of ISO 3309, as in annex D of PNG.
constexpr std::array<std::uint32_t, 256> crc_of_bytes = [] {
    std::array<std::uint32_t, 256> out{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1 ? 0xedb88320u : 0u) ^ crc >> 1;
        out[byte] = crc;
    }
    return out;
}();

std::uint32_t crc_of(std::string_view bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes)
        crc = crc_of_bytes[(crc ^ static_cast<unsigned char>(c)) & 0xff] ^ crc >> 8;
    return ~crc;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t out = 0;
    for (const char c : bytes.substr(at, 4)) out = out << 8 | static_cast<unsigned char>(c);
    return out;
}

bool is_name(std::string_view name)
{
    return std::ranges::all_of(
        name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

} // namespace

std::string png_trouble(std::string_view bytes)
{
    constexpr std::string_view begin("\x89PNG\r\n\x1a\n");
    constexpr std::size_t around = 12; // a chunk's length, name and checksum
    if (!bytes.starts_with(begin)) return "is damaged: it does not begin like a PNG";
    const auto cut_off = [&] { return fmt::format("is cut off after {} bytes", bytes.size()); };
    bool pixels = false;
    for (std::size_t at = begin.size();;) {
        if (bytes.size() - at < around) return cut_off();
        const std::size_t length = number_at(bytes, at);
        const std::string_view name = bytes.substr(at + 4, 4);
        if (!is_name(name)) return "is damaged: one of its chunks has no name";
        if (length > bytes.size() - at - around) return cut_off();
        if (at == begin.size() && name != "IHDR")
            return "is damaged: it does not begin with its size";
        if (crc_of(bytes.substr(at + 4, 4 + length)) != number_at(bytes, at + 8 + length))
            return fmt::format("is damaged: its chunk {} differs from its checksum", name);
        pixels = pixels || name == "IDAT";
        if (name == "IEND") return pixels ? "" : "is damaged: it has no pixels";
        at += around + length;
    }
}

std::string png_text(std::string_view bytes, std::string_view name)
{
    const std::string begin = std::string(name) + '\0';
    for (std::size_t at = 8; bytes.substr(at + 4, 4) != "IEND";) {
        const std::size_t length = number_at(bytes, at);
        const std::string_view data = bytes.substr(at + 8, length);
        if (bytes.substr(at + 4, 4) == "tEXt" && data.starts_with(begin))
            return std::string(data.substr(begin.size()));
        at += 12 + length;
    }
    return {};
}

} // namespace trivar
