// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/vti_header.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"

#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <pugixml.hpp>

namespace trivar {
namespace {

class VtiHead {
public:
    VtiHead(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    VtiHeader header()
    {
        parse();
        const pugi::xml_node file = xml_.child("VTKFile"), image = file.child("ImageData");
        if (std::strcmp(file.attribute("type").value(), "ImageData") != 0 || !image)
            refuse(fmt::format("its VTKFile is of type '{}'; a volume is ImageData",
                               shown(file.attribute("type").value())));
        const pugi::xml_node piece = image.child("Piece");
        if (!piece || piece.next_sibling("Piece")) refuse("its ImageData should have one Piece");
        take_file(file);
        take_sizes(image, piece);
        take_array(piece.child("PointData"));
        take_frame(image);
        return std::move(out_);
    }

private:
    [[noreturn]] void refuse(std::string_view reason) const
    {
        throw Rejected(fmt::format("{}: {}", name_, reason));
    }

    // The bytes of appended data are no XML: the file is read as if they were not there.
    void parse()
    {
        std::string text(bytes_);
        if (const std::size_t at = bytes_.find("<AppendedData"); at != bytes_.npos) {
            const std::size_t end = bytes_.find('>', at);
            const std::size_t mark = end == bytes_.npos ? end : bytes_.find('_', end);
            if (mark == bytes_.npos) refuse("its AppendedData should begin with '_'");
            out_.appended = mark + 1;
            text = std::string(bytes_.substr(0, end + 1)) + "</AppendedData></VTKFile>";
        }
        const pugi::xml_parse_result result =
            xml_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!result)
            refuse(fmt::format("its XML is damaged at byte {}: {}", result.offset,
                               result.description()));
    }

    void take_file(const pugi::xml_node& file)
    {
        const std::string_view order = file.attribute("byte_order").value();
        if (order != "LittleEndian" && order != "BigEndian")
            refuse(fmt::format("its byte_order is '{}'; it should be LittleEndian or BigEndian",
                               shown(order)));
        out_.order = order == "BigEndian" ? ByteOrder::big : ByteOrder::little;
        const std::string_view count = file.attribute("header_type").value();
        if (!count.empty() && count != "UInt32" && count != "UInt64")
            refuse(fmt::format("its header_type is '{}'; it should be UInt32 or UInt64",
                               shown(count)));
        out_.count_bytes = count == "UInt64" ? 8 : 4;
        const std::string_view compressor = file.attribute("compressor").value();
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            refuse(fmt::format("it is packed by {}, which is not read; write it with "
                               "vtkZLibDataCompressor or not packed",
                               shown(compressor)));
        out_.packed = !compressor.empty();
    }

    std::vector<double> numbers(const pugi::xml_node& node, const char* attribute,
                                std::size_t count) const
    {
        const std::string_view text = node.attribute(attribute).value();
        TextScan scan(text);
        std::vector<double> out;
        while (const auto number = scan.number()) out.push_back(*number);
        scan.skip_blanks();
        if (!text.empty() && (out.size() != count || !scan.done()))
            refuse(fmt::format("its {} is '{}'; it should be {} numbers", attribute, shown(text),
                               count));
        return out;
    }

    void take_sizes(const pugi::xml_node& image, const pugi::xml_node& piece)
    {
        const auto whole = numbers(image, "WholeExtent", 6);
        auto extent = numbers(piece, "Extent", 6);
        if (whole.empty()) refuse("its ImageData does not say its WholeExtent");
        if (extent.empty()) extent = whole;
        if (extent != whole) refuse("its Piece is a part of the volume; it should be all of it");
        constexpr double most = 4e9;
        for (std::size_t k = 0; k < 3; ++k) {
            const double lo = extent[2 * k], hi = extent[2 * k + 1];
            if (!(std::abs(lo) < most && std::abs(hi) < most) || lo != std::floor(lo) ||
                hi != std::floor(hi))
                refuse("its WholeExtent should be six whole numbers");
            out_.block.size[k] = static_cast<std::int64_t>(hi - lo) + 1;
            first_[static_cast<int>(k)] = lo;
        }
    }

    // The array that is named as scalars, else the first one.
    void take_array(const pugi::xml_node& data)
    {
        pugi::xml_node array = data.child("DataArray");
        const std::string_view scalars = data.attribute("Scalars").value();
        for (const pugi::xml_node& each : data.children("DataArray"))
            if (!scalars.empty() && scalars == each.attribute("Name").value()) {
                array = each;
                break;
            }
        if (!array) refuse("it has no PointData with a DataArray, the numbers at its points");
        const std::string_view components = array.attribute("NumberOfComponents").value();
        if (!components.empty() && components != "1" && components != "0")
            refuse(fmt::format("it has {} values at each point; a volume has one number at each "
                               "point",
                               shown(components)));
        take_type(array.attribute("type").value());
        take_format(array);
        if (data.child("DataArray").next_sibling("DataArray"))
            out_.notices.push_back(fmt::format("has several arrays; '{}' was read",
                                               shown(array.attribute("Name").value())));
    }

    void take_type(std::string_view said)
    {
        const std::map<std::string_view, SampleType> types{
            {"Int8", SampleType::i8},    {"UInt8", SampleType::u8},   {"Int16", SampleType::i16},
            {"UInt16", SampleType::u16}, {"Int32", SampleType::i32},  {"UInt32", SampleType::u32},
            {"Int64", SampleType::i64},  {"UInt64", SampleType::u64}, {"Float32", SampleType::f32},
            {"Float64", SampleType::f64}};
        const auto type = types.find(said);
        if (type == types.end())
            refuse(fmt::format("its array is of type '{}'; Int8 to Int64, UInt8 to UInt64, Float32 "
                               "and Float64 are read",
                               shown(said)));
        out_.block.type = type->second;
        check_block(out_.block, name_);
    }

    void take_format(const pugi::xml_node& array)
    {
        const std::string_view format = array.attribute("format").value();
        if (format == "ascii" || format == "binary") {
            out_.format = format == "ascii" ? VtiHeader::Format::ascii : VtiHeader::Format::base64;
            out_.text = array.child_value();
            return;
        }
        if (format != "appended")
            refuse(fmt::format("the format of its array is '{}'; it should be ascii, binary or "
                               "appended",
                               shown(format)));
        const std::string_view encoding =
            xml_.child("VTKFile").child("AppendedData").attribute("encoding").value();
        if (out_.appended == 0 || (encoding != "raw" && encoding != "base64"))
            refuse("its AppendedData should be there, with the encoding raw or base64");
        out_.format = encoding == "raw" ? VtiHeader::Format::appended_raw
                                        : VtiHeader::Format::appended_base64;
        const auto offset = numbers(array, "offset", 1);
        constexpr double most = 9e15;
        if (offset.empty() || !(offset[0] >= 0 && offset[0] < most) ||
            offset[0] != std::floor(offset[0]))
            refuse("the offset of its array should be a whole number from 0 on");
        out_.offset = static_cast<std::uint64_t>(offset[0]);
    }

    void take_frame(const pugi::xml_node& image)
    {
        const auto spacing = numbers(image, "Spacing", 3), origin = numbers(image, "Origin", 3);
        const auto direction = numbers(image, "Direction", 9); // rows of a matrix
        VolumeFrame& frame = out_.frame;
        if (spacing.empty())
            out_.notices.push_back("it does not say how far its samples are apart; 1 was taken");
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            if (!origin.empty()) frame.origin[k] = origin[axis];
            for (std::size_t j = 0; j < 3 && !direction.empty(); ++j)
                frame.steps[k][static_cast<int>(j)] = direction[3 * j + axis];
            if (!spacing.empty()) frame.steps[k] *= spacing[axis];
        }
        frame.origin += frame.steps * first_; // the origin is that of the point (0, 0, 0)
        if (!spans_space(frame))
            refuse("its Spacing and Direction do not span space; they should be three distances "
                   "that are not 0 and three directions that lie in no plane");
    }

    std::string_view bytes_;
    std::string name_;
    pugi::xml_document xml_;
    glm::dvec3 first_{0}; // point of the grid at which the extent begins
    VtiHeader out_;
};

} // namespace

bool is_vti(std::string_view bytes)
{
    constexpr std::size_t far_enough = 2000;
    const std::string_view begin = bytes.substr(0, far_enough);
    return begin.find_first_not_of(" \t\r\n\xef\xbb\xbf") != begin.npos &&
           begin[begin.find_first_not_of(" \t\r\n\xef\xbb\xbf")] == '<' &&
           begin.find("<VTKFile") != begin.npos;
}

VtiHeader read_vti_header(std::string_view bytes, const std::string& name)
{
    return VtiHead(bytes, name).header();
}

} // namespace trivar
