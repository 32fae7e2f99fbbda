// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/base64.h"

#include <cstdint>

namespace trivar {
namespace {

int base64_value(char c)
{
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    if (c == '/') return 63;
    return -1;
}

} // namespace

std::optional<std::string> from_base64(std::string_view text)
{
    std::string out;
    out.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int waiting = 0;
    bool ended = false;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') {
            ended = true;
            continue;
        }
        const int value = base64_value(c);
        if (value < 0 || ended) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        waiting += 6;
        if (waiting >= 8) {
            waiting -= 8;
            out += static_cast<char>(bits >> waiting & 0xff);
        }
    }
    if (waiting == 6) return {}; // a single character stands for no byte
    return out;
}

} // namespace trivar
