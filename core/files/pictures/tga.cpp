// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <fmt/format.h>

// TGA (Truevision, TGA File Format Specification 2.0).
namespace trivar {
namespace {

constexpr std::uint64_t head_bytes = 18, foot_bytes = 26; // the footer is optional

// Throws Rejected if a block that the footer names is outside the file: dates and names of the
// author, a thumbnail.
void check_foot(const ByteView& file)
{
    if (file.size() < head_bytes + foot_bytes ||
        !file.bytes.ends_with(std::string_view("TRUEVISION-XFILE.\0", 18)))
        return;
    const std::uint32_t more = file.little(file.size() - foot_bytes, 4);
    if (more == 0) return;
    file.part(more, 495);
    if (const std::uint32_t small = file.little(more + 486, 4); small != 0) {
        const std::uint64_t pixels = file.byte(small) * file.byte(small + 1);
        file.part(small + 2, pixels * ((file.byte(16) + 7) / 8));
    }
}

} // namespace

PictureHead tga_head(const ByteView& file, Look look)
{
    const std::uint32_t type = file.byte(2), bits = file.byte(16), with_table = file.byte(1);
    const bool packed = type >= 9;
    if (type % 8 < 1 || type % 8 > 3 || type > 11 || with_table > 1 ||
        (type % 8 == 1 && with_table == 0))
        throw Rejected("is damaged: its header names no kind of TGA");
    if (bits != 8 && bits != 15 && bits != 16 && bits != 24 && bits != 32)
        throw Rejected(fmt::format("is damaged: colours of {} bits do not exist", bits));
    const PictureHead head{{file.little(12, 2), file.little(14, 2)}, 4, 1};
    if (look == Look::head_only) return head;
    const std::uint64_t table =
        with_table * std::uint64_t{file.little(5, 2)} * ((file.byte(7) + 7) / 8);
    const std::uint64_t pixels = std::uint64_t{file.little(12, 2)} * file.little(14, 2);
    const std::uint64_t each = (bits + 7) / 8, most_a_packet = 128;
    file.part(head_bytes + file.byte(0) + table,
              packed ? (pixels + most_a_packet - 1) / most_a_packet * (1 + each) : pixels * each);
    check_foot(file);
    return head;
}

} // namespace trivar
