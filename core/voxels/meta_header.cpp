// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/meta_header.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"
#include "core/voxels/nrrd_fields.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <optional>

namespace trivar {
namespace {

constexpr std::size_t longest_meta_head = 1'000'000;

// A line "Key = value" of a head.
struct MetaLine {
    std::string_view key, value;
};

std::optional<MetaLine> meta_line(std::string_view line)
{
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return {};
    TextScan key(line.substr(0, equals)), value(line.substr(equals + 1));
    return MetaLine{key.rest(), value.rest()};
}

class MetaHead {
public:
    MetaHead(std::string_view bytes, std::string name) : name_(std::move(name)) { split(bytes); }

    MetaHeader header()
    {
        if (const auto type = find({"ObjectType"}); !type.empty() && type != "Image")
            refuse(fmt::format("its ObjectType is '{}'; it should be Image", shown(type)));
        take_sizes();
        take_type();
        const bool msb = yes({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
        out_.order = msb ? ByteOrder::big : ByteOrder::little;
        out_.binary = yes({"BinaryData"}, true);
        out_.packed = yes({"CompressedData"}, false);
        if (!find({"HeaderSize"}).empty()) out_.header_bytes = whole("HeaderSize");
        if (out_.header_bytes < -1)
            refuse(fmt::format("its HeaderSize is {}; it should be -1 or more", out_.header_bytes));
        take_scale();
        take_frame();
        take_files();
        return std::move(out_);
    }

private:
    [[noreturn]] void refuse(std::string_view reason) const
    {
        throw Rejected(fmt::format("{}: {}", name_, reason));
    }

    // Takes the lines up to the one that says where the samples are, which is the last.
    void split(std::string_view bytes)
    {
        TextScan scan(bytes);
        while (!scan.done()) {
            const auto line = meta_line(scan.line());
            out_.size = bytes.size() - static_cast<std::size_t>(scan.end - scan.at);
            if (!line || out_.size > longest_meta_head)
                refuse("the head of this MetaImage is damaged: each line should be 'Key = value', "
                       "up to ElementDataFile");
            fields_.emplace(line->key, line->value);
            if (line->key != "ElementDataFile") continue;
            if (line->value.starts_with("LIST"))
                for (; !scan.done(); scan.line())
                    if (const std::string_view file = scan.rest(); !file.empty())
                        out_.data_files.emplace_back(file);
            return;
        }
        refuse("this MetaImage has no line ElementDataFile, which says where its samples are");
    }

    std::string_view find(std::initializer_list<std::string_view> keys) const
    {
        for (const std::string_view key : keys)
            if (const auto found = fields_.find(key); found != fields_.end()) return found->second;
        return {};
    }

    std::vector<double> numbers(std::initializer_list<std::string_view> keys,
                                std::size_t count) const
    {
        const std::string_view text = find(keys);
        std::vector<double> out;
        TextScan scan(text);
        while (const auto number = scan.number()) out.push_back(*number);
        scan.skip_blanks();
        if (!text.empty() && (out.size() != count || !scan.done()))
            refuse(fmt::format("its {} is '{}'; it should be {}", *keys.begin(), shown(text),
                               counted(count, "number", "numbers")));
        return out;
    }

    std::int64_t whole(std::string_view key) const
    {
        constexpr double largest = 9e15; // of which a double holds each
        const double value = numbers({key}, 1).at(0);
        if (value != std::floor(value) || std::abs(value) > largest)
            refuse(fmt::format("its {} is {}; it should be a whole number", key, value));
        return static_cast<std::int64_t>(value);
    }

    bool yes(std::initializer_list<std::string_view> keys, bool otherwise) const
    {
        const std::string_view text = find(keys);
        if (text.empty()) return otherwise;
        return text[0] == 'T' || text[0] == 't' || text[0] == '1';
    }

    void take_sizes()
    {
        if (find({"NDims"}).empty() || find({"DimSize"}).empty())
            refuse("this MetaImage does not say NDims and DimSize, the number of its samples");
        const std::int64_t dimensions = whole("NDims");
        if (dimensions < 3 || dimensions > 4)
            refuse(fmt::format("its NDims is {}; a volume has 3", dimensions));
        const auto sizes = numbers({"DimSize"}, static_cast<std::size_t>(dimensions));
        if (dimensions == 4) {
            constexpr double most_volumes = 1e6;
            if (!(sizes[3] >= 1 && sizes[3] <= most_volumes && sizes[3] == std::floor(sizes[3])))
                refuse(fmt::format("its DimSize is '{}'; its last number should be that of the "
                                   "volumes",
                                   shown(find({"DimSize"}))));
            out_.volumes = static_cast<std::uint64_t>(sizes[3]);
        }
        constexpr double most = std::numeric_limits<std::int32_t>::max();
        for (std::size_t k = 0; k < 3; ++k) {
            if (sizes[k] != std::floor(sizes[k]) || std::abs(sizes[k]) > most + 1)
                refuse(fmt::format("its DimSize is '{}'; sizes are whole numbers up to {}",
                                   shown(find({"DimSize"})), with_commas(2'147'483'647)));
            out_.block.size[k] = static_cast<std::int64_t>(sizes[k]);
        }
        dimensions_ = static_cast<std::size_t>(dimensions);
    }

    void take_type()
    {
        const std::map<std::string_view, SampleType> types{
            {"MET_CHAR", SampleType::i8},       {"MET_UCHAR", SampleType::u8},
            {"MET_SHORT", SampleType::i16},     {"MET_USHORT", SampleType::u16},
            {"MET_INT", SampleType::i32},       {"MET_UINT", SampleType::u32},
            {"MET_LONG", SampleType::i32},      {"MET_ULONG", SampleType::u32},
            {"MET_LONG_LONG", SampleType::i64}, {"MET_ULONG_LONG", SampleType::u64},
            {"MET_FLOAT", SampleType::f32},     {"MET_DOUBLE", SampleType::f64}};
        const std::string_view said = find({"ElementType"});
        if (const auto channels = find({"ElementNumberOfChannels"});
            (!channels.empty() && channels != "1") || said.ends_with("_ARRAY"))
            refuse(fmt::format("it has {} values at each point; a volume has one number at each "
                               "point",
                               channels.empty() ? "several" : shown(channels)));
        const auto type = types.find(said);
        if (type == types.end())
            refuse(fmt::format("its ElementType is '{}'; MET_CHAR, MET_UCHAR, MET_SHORT, "
                               "MET_USHORT, MET_INT, MET_UINT, MET_FLOAT and MET_DOUBLE are read",
                               shown(said)));
        out_.block.type = type->second;
        check_block(out_.block, name_);
    }

    void take_scale()
    {
        const auto slope = numbers({"ElementToIntensityFunctionSlope"}, 1);
        const auto intercept = numbers({"ElementToIntensityFunctionOffset"}, 1);
        if (!slope.empty() && slope[0] != 0) out_.slope = slope[0];
        if (!intercept.empty()) out_.intercept = intercept[0];
    }

    void take_frame()
    {
        auto spacing = numbers({"ElementSpacing", "ElementSize"}, dimensions_);
        auto origin = numbers({"Offset", "Position", "Origin"}, dimensions_);
        const auto matrix =
            numbers({"TransformMatrix", "Rotation", "Orientation"}, dimensions_ * dimensions_);
        if (spacing.empty()) {
            spacing.assign(dimensions_, 1);
            out_.notices.push_back("it does not say how far its samples are apart; 1 was taken");
        }
        if (origin.empty()) origin.assign(dimensions_, 0);
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            out_.frame.origin[k] = origin[axis];
            // The matrix has the direction of an axis of the grid in each row.
            for (std::size_t j = 0; j < 3 && !matrix.empty(); ++j)
                out_.frame.steps[k][static_cast<int>(j)] = matrix[axis * dimensions_ + j];
            out_.frame.steps[k] *= spacing[axis];
        }
        if (!spans_space(out_.frame))
            refuse("its TransformMatrix and ElementSpacing do not span space; they should be three "
                   "directions that lie in no plane, and distances that are not 0");
    }

    void take_files()
    {
        const std::string value(find({"ElementDataFile"}));
        if (value == "LOCAL" || value == "Local" || value == "local") return;
        if (value.starts_with("LIST")) {
            if (out_.data_files.empty()) refuse("its list of data files is empty");
        } else if (value.find('%') != value.npos) {
            TextScan words(value);
            const std::string pattern(words.word());
            int number[3]{0, 0, 1};
            for (int& each : number) {
                words.skip_blanks();
                if (words.done()) break;
                each = words.integer().value_or(0);
            }
            out_.data_files = numbered_names(pattern, number[0], number[1], number[2], name_);
        } else if (value.empty()) {
            refuse("its ElementDataFile is empty; it should be LOCAL or the name of a file");
        } else {
            out_.data_files = {value};
        }
    }

    std::string name_;
    std::map<std::string_view, std::string_view> fields_;
    std::size_t dimensions_ = 3;
    MetaHeader out_;
};

} // namespace

bool is_meta_image(std::string_view bytes)
{
    TextScan scan(bytes);
    const auto line = meta_line(scan.line().substr(0, 200));
    return line && (line->key == "ObjectType" || line->key == "NDims");
}

MetaHeader read_meta_header(std::string_view bytes, const std::string& name)
{
    return MetaHead(bytes, name).header();
}

} // namespace trivar
