// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace trivar {

// A ByteView reads the bytes of a file as unsigned numbers without alignment. Throws Rejected for a
// place beyond the end: the rest of a sentence that begins with the file's name and kind.
struct ByteView {
    std::string_view bytes;
    const char* ends_early = nullptr; // said in that case, where these bytes are a part of a file

    std::size_t size() const { return bytes.size(); }
    std::string_view part(std::uint64_t at, std::uint64_t count) const;
    std::uint32_t byte(std::uint64_t at) const
    {
        return static_cast<unsigned char>(part(at, 1).front());
    }
    // A side of a picture. A number that does not fit an int becomes the largest int, which is
    // refused later.
    static int side(std::uint32_t number)
    {
        return static_cast<int>(std::min(number, 0x7fffffffu));
    }
    // The least significant byte first, as Intel has it ...
    std::uint32_t little(std::uint64_t at, int count) const
    {
        part(at, static_cast<unsigned>(count));
        std::uint32_t out = 0;
        for (int i = count; i-- > 0;) out = out << 8 | byte(at + static_cast<unsigned>(i));
        return out;
    }
    // ... or the last.
    std::uint32_t big(std::uint64_t at, int count) const
    {
        part(at, static_cast<unsigned>(count));
        std::uint32_t out = 0;
        for (int i = 0; i < count; ++i) out = out << 8 | byte(at + static_cast<unsigned>(i));
        return out;
    }
};

} // namespace trivar
