// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"
#include "core/voxels/volume_readers.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

std::string in_capitals(std::string_view word)
{
    std::string out(word);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

// Reads a legacy VTK file with structured points: lines of words up to LOOKUP_TABLE, then samples.
// Source: "VTK File Formats", the legacy format.
class LegacyVtk {
public:
    LegacyVtk(VolumeSource& source, const ReadVolumeOptions& options)
        : source_(source),
          options_(options),
          scan_(source.head())
    {
    }

    ReadVolume volume()
    {
        read_head();
        while (!read_samples_) read_line();
        const auto count = static_cast<std::uint64_t>(block_.bytes() / size_of(block_.type));
        if (points_ != count)
            source_.refuse(fmt::format("its POINT_DATA is of {} points; {} x {} x {} are {}",
                                       with_commas(points_), block_.size[0], block_.size[1],
                                       block_.size[2], with_commas(count)));
        const VolumeFrame frame = upright_frame(spacing_, origin_);
        if (!spans_space(frame))
            source_.refuse("its SPACING should be three numbers that are not 0");
        PartTaker taker(block_, options_, source_.name(), source_.progress());
        take_samples(taker);
        return volume_of(source_, taker, block_.type, frame, metres_per_unit(options_, 0));
    }

private:
    void read_head()
    {
        scan_.line(); // its version
        scan_.line(); // its title
        while (!scan_.done() && scan_.rest().empty()) scan_.line();
        const std::string kind = in_capitals(scan_.word());
        scan_.line();
        if (kind != "ASCII" && kind != "BINARY")
            source_.refuse(
                fmt::format("its third line is '{}'; it should be ASCII or BINARY", shown(kind)));
        binary_ = kind == "BINARY";
    }

    void read_line()
    {
        if (scan_.done())
            source_.refuse("this VTK file has no samples; it should have POINT_DATA and SCALARS");
        const std::string word = in_capitals(scan_.word());
        if (word == "DATASET") {
            const std::string_view set = scan_.word();
            if (in_capitals(set) != "STRUCTURED_POINTS")
                source_.refuse(
                    fmt::format("its DATASET is {}; a volume is STRUCTURED_POINTS", shown(set)));
        } else if (word == "DIMENSIONS") {
            for (std::int64_t& size : block_.size) size = whole("DIMENSIONS");
        } else if (word == "SPACING" || word == "ASPECT_RATIO") {
            for (int k = 0; k < 3; ++k) spacing_[k] = real("SPACING");
        } else if (word == "ORIGIN") {
            for (int k = 0; k < 3; ++k) origin_[k] = real("ORIGIN");
        } else if (word == "POINT_DATA") {
            points_ = static_cast<std::uint64_t>(std::max<std::int64_t>(0, whole("POINT_DATA")));
        } else if (word == "SCALARS") {
            read_scalars();
        } else if (word == "CELL_DATA") {
            source_.refuse("its numbers belong to cells; a volume has one at each point "
                           "(POINT_DATA)");
        } else if (word == "VECTORS" || word == "TENSORS" || word == "NORMALS" ||
                   word == "COLOR_SCALARS" || word == "FIELD" || word == "TEXTURE_COORDINATES") {
            source_.refuse(fmt::format("its numbers are {}; a volume has one number at each point "
                                       "(SCALARS)",
                                       word));
        } else if (word == "METADATA") { // up to an empty line
            while (!scan_.done() && !scan_.rest().empty()) scan_.line();
        } else if (!word.empty()) {
            source_.refuse(fmt::format("'{}' does not belong in a VTK file with STRUCTURED_POINTS",
                                       shown(word)));
        }
        if (!read_samples_) scan_.line();
    }

    void read_scalars()
    {
        const std::map<std::string_view, SampleType> types{{"char", SampleType::i8},
                                                           {"signed_char", SampleType::i8},
                                                           {"unsigned_char", SampleType::u8},
                                                           {"short", SampleType::i16},
                                                           {"unsigned_short", SampleType::u16},
                                                           {"int", SampleType::i32},
                                                           {"unsigned_int", SampleType::u32},
                                                           {"long", SampleType::i64},
                                                           {"unsigned_long", SampleType::u64},
                                                           {"vtktypeint64", SampleType::i64},
                                                           {"vtktypeuint64", SampleType::u64},
                                                           {"float", SampleType::f32},
                                                           {"double", SampleType::f64}};
        scan_.word(); // their name
        const std::string_view said = scan_.word(), components = scan_.word();
        const auto type = types.find(said);
        if (type == types.end())
            source_.refuse(fmt::format("its SCALARS are of type '{}'; char, short, int and long, "
                                       "also unsigned, float and double are read",
                                       shown(said)));
        if (!components.empty() && components != "1")
            source_.refuse(fmt::format("it has {} values at each point; a volume has one number at "
                                       "each point",
                                       shown(components)));
        block_.type = type->second;
        scan_.line();
        if (in_capitals(scan_.word()) != "LOOKUP_TABLE")
            source_.refuse("a line 'LOOKUP_TABLE default' should follow its SCALARS");
        scan_.line();
        check_block(block_, source_.name());
        read_samples_ = true;
    }

    void take_samples(PartTaker& taker)
    {
        const auto from = static_cast<std::uint64_t>(scan_.at - source_.head().data());
        if (!binary_) {
            // Words come after the numbers where the file has more than these.
            const std::string_view all = source_.bytes().substr(static_cast<std::size_t>(from));
            std::size_t end = 0;
            while (end < all.size() && !begins_word(all, end)) ++end;
            check_rest(from + end);
            if (taker.wants_samples())
                taker.take(taken_words(all.substr(0, end), block_, source_.name()));
            return;
        }
        const std::uint64_t needed = block_.bytes(), bytes = source_.size() - from;
        if (bytes < needed) check_bytes(block_, bytes, source_.name());
        check_rest(from + needed);
        if (taker.wants_samples())
            taker.take(stream_of(source_.file(), from, needed), ByteOrder::big);
    }

    // Whether a word of capitals begins here, at the beginning of a line.
    static bool begins_word(std::string_view text, std::size_t at)
    {
        return (at == 0 || text[at - 1] == '\n') && text[at] >= 'A' && text[at] <= 'Z' &&
               at + 1 < text.size() && text[at + 1] >= 'A' && text[at + 1] <= 'Z';
    }

    // Behind the samples may stand an end of line, and other data, which are left out.
    void check_rest(std::uint64_t from)
    {
        constexpr std::uint64_t at_once = std::uint64_t{1} << 16;
        const std::uint64_t bytes = source_.size() - from;
        std::string buffer;
        std::string_view rest;
        do {
            rest = source_.file().part(from, at_once, buffer);
            const std::size_t before = rest.size();
            while (!rest.empty() && (is_blank(rest[0]) || rest[0] == '\n')) rest.remove_prefix(1);
            if (before == 0) return;
            from += before - rest.size();
        } while (rest.empty());
        rest = source_.file().part(from, at_once, buffer);
        TextScan scan(rest.substr(0, 40));
        const std::string word(scan.word());
        for (const char* known :
             {"METADATA", "SCALARS", "COLOR_SCALARS", "VECTORS", "NORMALS", "TENSORS", "FIELD",
              "TEXTURE_COORDINATES", "LOOKUP_TABLE", "CELL_DATA", "POINT_DATA"})
            if (word == known) {
                if (word != "METADATA")
                    source_.say(fmt::format("only its first SCALARS were read; {} and what follows "
                                            "were left out",
                                            word));
                return;
            }
        source_.refuse(fmt::format("{} bytes more than its {} x {} x {} voxels of {} bits need "
                                   "follow its SCALARS",
                                   with_commas(bytes), block_.size[0], block_.size[1],
                                   block_.size[2], 8 * size_of(block_.type)));
    }

    std::int64_t whole(const char* what)
    {
        scan_.skip_blanks();
        constexpr double most = 9e15;
        const auto number = scan_.number();
        if (!number || *number != static_cast<double>(
                                      static_cast<std::int64_t>(std::clamp(*number, -most, most))))
            source_.refuse(fmt::format("its {} should be whole numbers", what));
        return static_cast<std::int64_t>(*number);
    }

    double real(const char* what)
    {
        const auto number = scan_.number();
        if (!number) source_.refuse(fmt::format("its {} should be three numbers", what));
        return *number;
    }

    VolumeSource& source_;
    const ReadVolumeOptions& options_;
    TextScan scan_;
    SampleBlock block_;
    glm::dvec3 spacing_{1}, origin_{0};
    std::uint64_t points_ = 0;
    bool binary_ = false, read_samples_ = false;
};

} // namespace

ReadVolume read_legacy_vtk(VolumeSource& source, const ReadVolumeOptions& options)
{
    return LegacyVtk(source, options).volume();
}

} // namespace trivar
