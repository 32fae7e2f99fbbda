// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_uri.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace trivar {
namespace {

constexpr std::string_view data_scheme = "data:", base64_mark = ";base64";
constexpr std::uint8_t no_digit = 64;

constexpr std::array<std::uint8_t, 256> base64_digits()
{
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> out{};
    out.fill(no_digit);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        out[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    return out;
}

// Decodes base64, six bits per digit. Line ends are skipped; '=' ends the text.
std::optional<std::string> base64_bytes(std::string_view text)
{
    static constexpr std::array<std::uint8_t, 256> digits = base64_digits();
    std::string out;
    out.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0, count = 0;
    bool ended = false;
    for (const char c : text) {
        if (c == '\n' || c == '\r' || c == ' ') continue;
        ended |= c == '=';
        if (c == '=') continue;
        const std::uint8_t digit = digits[static_cast<unsigned char>(c)];
        if (ended || digit == no_digit) return {};
        bits = bits << 6 | digit;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        out += static_cast<char>(bits >> count & 0xff);
    }
    if (count >= 6) return {}; // a single digit is no byte
    return out;
}

} // namespace

bool is_data_uri(std::string_view uri)
{
    return uri.starts_with(data_scheme);
}

std::optional<std::string> data_uri_bytes(std::string_view uri)
{
    const std::size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == uri.npos) return {};
    const std::string_view kind = uri.substr(0, comma), text = uri.substr(comma + 1);
    if (!kind.ends_with(base64_mark)) return without_escapes(text);
    return text.find('%') == text.npos ? base64_bytes(text) : base64_bytes(without_escapes(text));
}

std::string without_escapes(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        unsigned char byte = 0;
        const char *const hex = text.data() + 1, *const end = hex + 2;
        const bool escape = text.size() >= 3 && text.front() == '%' &&
                            std::from_chars(hex, end, byte, 16).ptr == end;
        out += escape ? static_cast<char>(byte) : text.front();
        text.remove_prefix(escape ? 3 : 1);
    }
    return out;
}

} // namespace trivar
