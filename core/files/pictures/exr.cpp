// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <optional>
#include <vector>

// OpenEXR (File Layout): a magic number, a version with flags, attributes up to an empty name, each
// with a name, a type, a length and a value, then the offset of each chunk of pixels.
namespace trivar {
namespace {

constexpr std::uint32_t flag_tiled = 0x200, flag_deep = 0x800, flag_parts = 0x1000;

struct ExrWindow {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
    std::int64_t wide() const { return std::int64_t{right} - left + 1; }
    std::int64_t high() const { return std::int64_t{bottom} - top + 1; }
};

struct ExrPart {
    std::optional<ExrWindow> data, display;
    std::uint32_t channels = 0, bytes_a_channel = 2, packing = 0;
    std::uint32_t tile_width = 0, tile_height = 0, tile_levels = 0, tile_rounding = 0;
    std::optional<std::uint32_t> pieces; // according to the header
};

// Returns the name up to its null byte.
std::string_view exr_name(const ByteView& file, std::uint64_t at)
{
    constexpr std::uint64_t longest = 255;
    file.part(at, 1);
    const std::string_view text = file.bytes.substr(at, longest + 1);
    const std::size_t end = text.find('\0');
    if (end == std::string_view::npos) {
        file.part(at, longest + 1); // Throws Rejected if the file ends here.
        throw Rejected("is damaged: a name in its header has no end");
    }
    return text.substr(0, end);
}

ExrWindow window_at(const ByteView& value)
{
    const auto side = [&](std::uint64_t at) {
        return static_cast<std::int32_t>(value.little(at, 4));
    };
    return {side(0), side(4), side(8), side(12)};
}

void read_channels(const ByteView& value, ExrPart& part)
{
    for (std::uint64_t at = 0; value.byte(at) != 0; ++part.channels) {
        at += exr_name(value, at).size() + 1;
        const std::uint32_t type = value.little(at, 4);
        if (type > 2 || value.little(at + 8, 4) == 0 || value.little(at + 12, 4) == 0)
            throw Rejected("is damaged: one of its channels has an unknown type");
        if (value.little(at + 8, 4) != 1 || value.little(at + 12, 4) != 1)
            throw Rejected("has channels of different sizes; save all channels at the same size");
        if (type != 1) part.bytes_a_channel = 4;
        at += 16;
    }
}

void read_attribute(std::string_view name, const ByteView& value, ExrPart& part)
{
    if (name == "channels") read_channels(value, part);
    if (name == "compression") part.packing = value.byte(0);
    if (name == "dataWindow") part.data = window_at(value);
    if (name == "displayWindow") part.display = window_at(value);
    if (name == "chunkCount") part.pieces = value.little(0, 4);
    if (name == "type" && value.bytes.starts_with("deep"))
        throw Rejected("has several depths per pixel; save it flat");
    if (name == "tiles") {
        part.tile_width = value.little(0, 4);
        part.tile_height = value.little(4, 4);
        part.tile_levels = value.byte(8) & 15;
        part.tile_rounding = value.byte(8) >> 4;
    }
}

// Reads the attributes of a part and returns where they end.
std::uint64_t read_part(const ByteView& file, std::uint64_t at, ExrPart& part)
{
    while (true) {
        const std::string_view name = exr_name(file, at);
        at += name.size() + 1;
        if (name.empty()) return at;
        at += exr_name(file, at).size() + 1;
        const std::uint32_t length = file.little(at, 4);
        read_attribute(name,
                       {file.part(at + 4, length), "is damaged: a value in its header ends early"},
                       part);
        at += 4 + std::uint64_t{length};
    }
}

// Number of rows that are compressed together, by the number of the compression.
constexpr std::array<std::uint32_t, 10> rows_a_piece{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

// Returns the number of tiles along a side for each level: the full size and its halvings.
std::vector<std::uint64_t> tiles_of_levels(std::uint64_t side, std::uint32_t tile, int levels,
                                           bool up)
{
    std::vector<std::uint64_t> out;
    for (int level = 0; level < levels; ++level) {
        const std::uint64_t rounding = up ? (std::uint64_t{1} << level) - 1 : 0;
        const std::uint64_t left = std::max<std::uint64_t>(1, (side + rounding) >> level);
        out.push_back((left + tile - 1) / tile);
    }
    return out;
}

int levels_of(std::uint64_t side, bool up)
{
    return static_cast<int>(std::bit_width(up ? 2 * side - 1 : side));
}

std::uint64_t tiles_of(const ExrPart& part)
{
    constexpr std::uint32_t most = 1 << 14;
    if (part.tile_width == 0 || part.tile_height == 0 || part.tile_width > most ||
        part.tile_height > most || part.tile_levels > 2 || part.tile_rounding > 1)
        throw Rejected("is damaged: its tiles have a wrong size");
    const auto wide = static_cast<std::uint64_t>(part.data->wide());
    const auto high = static_cast<std::uint64_t>(part.data->high());
    const bool up = part.tile_rounding == 1, each_way = part.tile_levels == 2;
    const int both = part.tile_levels == 0 ? 1 : levels_of(std::max(wide, high), up);
    const auto across =
        tiles_of_levels(wide, part.tile_width, each_way ? levels_of(wide, up) : both, up);
    const auto down =
        tiles_of_levels(high, part.tile_height, each_way ? levels_of(high, up) : both, up);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < across.size(); ++i)
        for (std::size_t j = each_way ? 0 : i; j < (each_way ? down.size() : i + 1); ++j)
            count += across[i] * down[j];
    return count;
}

std::uint64_t exr_pieces(const ExrPart& part, bool tiled)
{
    const std::uint64_t rows = rows_a_piece[part.packing];
    return tiled ? tiles_of(part)
                 : (static_cast<std::uint64_t>(part.data->high()) + rows - 1) / rows;
}

} // namespace

PictureHead exr_head(const ByteView& file, Look look)
{
    const std::uint32_t version = file.little(4, 4);
    if ((version & flag_deep) != 0) throw Rejected("has several depths per pixel; save it flat");
    if ((version & 0xff) != 2 || (version & ~0x1effu) != 0)
        throw Rejected("has an unknown version; save it as version 2");
    const bool several = (version & flag_parts) != 0;
    ExrPart part;
    std::uint64_t at = read_part(file, 8, part);
    if (!part.data || !part.display || part.channels == 0)
        throw Rejected("is damaged: its header has no windows or no channels");
    const auto side = [](std::int64_t value) {
        return static_cast<int>(std::clamp<std::int64_t>(value, -1, 1 << 30));
    };
    const PictureHead head{{side(part.data->wide()), side(part.data->high())},
                           static_cast<int>(part.channels),
                           static_cast<int>(part.bytes_a_channel)};
    if (look == Look::head_only) return head;
    // The display window may be at another place, but must not be extremely large.
    constexpr std::int64_t far = 1 << 20;
    for (const ExrWindow& window : {*part.data, *part.display})
        if (window.wide() < 1 || window.high() < 1 || std::abs(std::int64_t{window.left}) > far ||
            std::abs(std::int64_t{window.top}) > far || window.wide() > far || window.high() > far)
            throw Rejected("is damaged: its windows have a wrong size");
    if (part.packing >= rows_a_piece.size()) throw Rejected("has an unknown compression; use ZIP");
    if (several) {
        if (!part.pieces) throw Rejected("is damaged: its header does not count its chunks");
        for (std::uint32_t parts = 1; file.byte(at) != 0; ++parts) { // other parts are not read
            ExrPart other;
            at = read_part(file, at, other);
        }
        ++at;
    }
    const std::uint64_t pieces =
        exr_pieces(part, (version & flag_tiled) != 0 || (several && part.tile_width != 0));
    if (part.pieces && *part.pieces != pieces)
        throw Rejected("is damaged: its header has a wrong number of chunks");
    file.part(at, 8 * pieces);
    for (std::uint64_t piece = 0; piece < pieces; ++piece) {
        const std::uint64_t begin = file.little(at + 8 * piece, 4) |
                                    std::uint64_t{file.little(at + 8 * piece + 4, 4)} << 32;
        file.part(begin, several ? 12 : 8);
    }
    return head;
}

} // namespace trivar
