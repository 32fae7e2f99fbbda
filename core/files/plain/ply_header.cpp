// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/plain/ply_header.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace trivar {
namespace {

std::optional<PlyType> type_named(std::string_view name)
{
    static const std::map<std::string_view, PlyType> types{
        {"char", PlyType::i8},    {"int8", PlyType::i8},     {"uchar", PlyType::u8},
        {"uint8", PlyType::u8},   {"short", PlyType::i16},   {"int16", PlyType::i16},
        {"ushort", PlyType::u16}, {"uint16", PlyType::u16},  {"int", PlyType::i32},
        {"int32", PlyType::i32},  {"uint", PlyType::u32},    {"uint32", PlyType::u32},
        {"float", PlyType::f32},  {"float32", PlyType::f32}, {"double", PlyType::f64},
        {"float64", PlyType::f64}};
    const auto at = types.find(name);
    return at == types.end() ? std::nullopt : std::optional(at->second);
}

// HeaderLines splits a header into lines. The data after it may be binary, so the first line
// decides whether '\r' alone ends a line, as on old Macs and in some present programs, or "\n\r"
// does.
class HeaderLines {
public:
    explicit HeaderLines(std::string_view text) : rest_(text)
    {
        const std::size_t end = text.find_first_of("\r\n");
        const std::string_view both = text.substr(std::min(end, text.size()), 2);
        if (both.starts_with('\r') && both != "\r\n") mark_ = '\r';
        mark_bytes_ = both == "\n\r" ? 2 : 1;
    }
    bool done() const { return rest_.empty(); }
    std::string_view next()
    {
        const std::size_t end = std::min(rest_.find(mark_), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + mark_bytes_, rest_.size()));
        return line;
    }
    std::size_t left() const { return rest_.size(); }

private:
    std::string_view rest_;
    char mark_ = '\n';
    std::size_t mark_bytes_ = 1;
};

} // namespace

std::size_t size_of(PlyType type)
{
    static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name)
{
    PlyHeader header{};
    HeaderLines lines(bytes);
    int line = 0;
    bool format_said = false;
    const auto fail = [&](const std::string& what) {
        throw Rejected(fmt::format("{}: line {}: {}", name, line, what));
    };
    for (;;) {
        ++line;
        if (lines.done()) fail("the file ends before the header's end_header");
        TextScan words(lines.next());
        const std::string_view keyword = words.word();
        if (line == 1) {
            if (keyword != "ply") fail("the file does not begin with 'ply'");
        } else if (keyword == "format") {
            const std::string_view format = words.word();
            using Format = PlyHeader::Format;
            if (format == "ascii")
                header.format = Format::ascii;
            else if (format == "binary_little_endian")
                header.format = Format::little_endian;
            else if (format == "binary_big_endian")
                header.format = Format::big_endian;
            else
                fail(fmt::format("'{}' is not a PLY format; use ascii, binary_little_endian or "
                                 "binary_big_endian",
                                 shown(format)));
            format_said = true;
        } else if (keyword == "element") {
            PlyElement element;
            element.name = words.word();
            words.skip_blanks();
            const auto count = words.integer();
            if (!count || *count < 0)
                fail(fmt::format(
                    "the number of elements {} must be a whole number from 0 to 999999999",
                    shown(element.name)));
            element.count = static_cast<std::size_t>(*count);
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty()) fail("a property comes before any element");
            PlyProperty property;
            std::string_view type = words.word();
            if (type == "list") {
                const auto count_type = type_named(words.word());
                if (!count_type || *count_type == PlyType::f32 || *count_type == PlyType::f64)
                    fail("the length of a list must be a whole number, such as uchar or int");
                property.list = true;
                property.count_type = *count_type;
                type = words.word();
            }
            const auto known = type_named(type);
            if (!known)
                fail(fmt::format("'{}' is not a PLY type; use char, uchar, short, ushort, int, "
                                 "uint, float or double",
                                 shown(type)));
            property.type = *known;
            property.name = words.word();
            header.elements.back().properties.push_back(std::move(property));
        } else if (keyword == "end_header") {
            break;
        } else if (keyword == "comment") {
            if (words.word() == "TextureFile") header.pictures.emplace_back(words.rest());
        } else if (keyword != "obj_info" && !keyword.empty()) {
            fail(fmt::format("'{}' does not belong in a PLY header", shown(keyword)));
        }
    }
    if (!format_said) fail("the header has no line such as 'format ascii 1.0'");
    header.size = bytes.size() - lines.left();
    return header;
}

} // namespace trivar
