// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>

namespace trivar {
namespace {

// Of the polynomial of ISO 3309, as PNG's annex D has it.
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
    if (!bytes.starts_with(begin)) return "its first bytes are not those of a PNG";
    bool pixels = false;
    for (std::size_t at = begin.size();;) {
        if (bytes.size() - at < around) return "it is cut short";
        const std::size_t length = number_at(bytes, at);
        const std::string_view name = bytes.substr(at + 4, 4);
        if (!is_name(name)) return "it is damaged: what should be a chunk has no name";
        if (length > bytes.size() - at - around) return "it is cut short";
        if (at == begin.size() && name != "IHDR") return "it does not begin with its size";
        if (crc_of(bytes.substr(at + 4, 4 + length)) != number_at(bytes, at + 8 + length))
            return fmt::format("it is damaged: its chunk {} differs from its checksum", name);
        pixels = pixels || name == "IDAT";
        if (name == "IEND") return pixels ? "" : "it has no pixels";
        at += around + length;
    }
}

} // namespace trivar
