// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/nifti_header.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <optional>

namespace trivar {
namespace {

// Where the fields of both versions are. Version 1 has 16-bit sizes and 32-bit floats, version 2
// 64-bit ones of both.
struct NiftiPlaces {
    std::size_t bytes, magic, dim, datatype, bitpix, pixdim, offset, slope, intercept, qform, sform,
        quatern, qoffset, srow, units;
};
constexpr NiftiPlaces first_version{348, 344, 40,  70,  72,  76,  108, 112,
                                    116, 252, 254, 256, 268, 280, 123};
constexpr NiftiPlaces second_version{540, 4,   16,  12,  14,  104, 168, 176,
                                     184, 344, 348, 352, 376, 400, 500};

template <class T> T nifti_field(std::string_view bytes, std::size_t at, ByteOrder order)
{
    char field[sizeof(T)];
    std::memcpy(field, bytes.data() + at, sizeof(T));
    if (order == ByteOrder::big) std::reverse(field, field + sizeof(T));
    T value;
    std::memcpy(&value, field, sizeof(T));
    return value;
}

// The order of bytes in which the first number is that of the head's bytes.
std::optional<ByteOrder> order_of(std::string_view bytes, std::size_t head_bytes)
{
    if (bytes.size() < head_bytes) return {};
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
        if (nifti_field<std::int32_t>(bytes, 0, order) == static_cast<std::int32_t>(head_bytes))
            return order;
    return {};
}

bool has_magic(std::string_view bytes, const NiftiPlaces& places, std::string_view magic)
{
    return bytes.size() >= places.bytes && bytes.substr(places.magic, magic.size()) == magic;
}

bool is_version(std::string_view bytes, const NiftiPlaces& places)
{
    using namespace std::string_view_literals;
    const bool first = places.bytes == first_version.bytes;
    return order_of(bytes, places.bytes) &&
           (has_magic(bytes, places, first ? "n+1\0"sv : "n+2\0"sv) ||
            has_magic(bytes, places, first ? "ni1\0"sv : "ni2\0"sv));
}

class NiftiHead {
public:
    NiftiHead(std::string_view bytes, std::string name)
        : bytes_(bytes),
          name_(std::move(name)),
          first_(is_version(bytes, first_version)),
          places_(first_ ? first_version : second_version),
          order_(*order_of(bytes, places_.bytes))
    {
    }

    NiftiHeader header()
    {
        out_.order = order_;
        out_.detached = bytes_[places_.magic + 1] == 'i';
        take_sizes();
        take_type();
        take_offset();
        take_scale();
        take_units();
        take_frame();
        return std::move(out_);
    }

private:
    [[noreturn]] void refuse(std::string_view reason) const
    {
        throw Rejected(fmt::format("{}: {}", name_, reason));
    }
    double real(std::size_t at, std::size_t k = 0) const
    {
        return first_ ? static_cast<double>(nifti_field<float>(bytes_, at + 4 * k, order_))
                      : nifti_field<double>(bytes_, at + 8 * k, order_);
    }
    std::int64_t size(std::size_t k) const
    {
        return first_ ? nifti_field<std::int16_t>(bytes_, places_.dim + 2 * k, order_)
                      : nifti_field<std::int64_t>(bytes_, places_.dim + 8 * k, order_);
    }
    int code(std::size_t at) const
    {
        return first_ ? nifti_field<std::int16_t>(bytes_, at, order_)
                      : nifti_field<std::int32_t>(bytes_, at, order_);
    }

    void take_sizes()
    {
        const std::int64_t dimensions = size(0);
        if (dimensions < 1 || dimensions > 7)
            refuse(fmt::format("its head says {} dimensions; a volume has 3", dimensions));
        if (dimensions > 3 && size(4) > 1) out_.volumes = static_cast<std::uint64_t>(size(4));
        for (std::size_t k = 4; k <= static_cast<std::size_t>(dimensions); ++k)
            if (size(k) != 1 && (k > 4 || size(k) < 1))
                refuse(fmt::format("it has {} dimensions, {} values at each point; a volume has "
                                   "one number at each point",
                                   dimensions, size(k)));
        if (dimensions < 3)
            refuse(fmt::format("its head says {} dimensions; a volume has 3", dimensions));
        for (std::size_t k = 0; k < 3; ++k) out_.block.size[k] = size(k + 1);
    }

    void take_type()
    {
        const int type = nifti_field<std::int16_t>(bytes_, places_.datatype, order_);
        switch (type) {
        case 2: out_.block.type = SampleType::u8; break;
        case 4: out_.block.type = SampleType::i16; break;
        case 8: out_.block.type = SampleType::i32; break;
        case 16: out_.block.type = SampleType::f32; break;
        case 64: out_.block.type = SampleType::f64; break;
        case 256: out_.block.type = SampleType::i8; break;
        case 512: out_.block.type = SampleType::u16; break;
        case 768: out_.block.type = SampleType::u32; break;
        case 1024: out_.block.type = SampleType::i64; break;
        case 1280: out_.block.type = SampleType::u64; break;
        case 32:
        case 1792:
            refuse("its samples are complex numbers; a volume has one real number at each "
                   "point");
        case 128:
        case 2304: refuse("its samples are colours; a volume has one number at each point");
        default:
            refuse(fmt::format("its type of samples has the number {}, which is not known or "
                               "not read; whole numbers of 8 to 64 bits and floating point of "
                               "32 and 64 bits are",
                               type));
        }
        check_block(out_.block, name_);
        const int bits = nifti_field<std::int16_t>(bytes_, places_.bitpix, order_);
        if (bits != static_cast<int>(8 * size_of(out_.block.type)))
            refuse(fmt::format("its head says {} bits for each sample, but its type {} has {}",
                               bits, type, 8 * size_of(out_.block.type)));
    }

    void take_offset()
    {
        constexpr double largest = 1e15;
        const double offset =
            first_ ? real(places_.offset)
                   : static_cast<double>(nifti_field<std::int64_t>(bytes_, places_.offset, order_));
        const double least = out_.detached ? 0 : static_cast<double>(places_.bytes);
        if (!(offset >= least && offset <= largest && offset == std::floor(offset)))
            refuse(fmt::format("its samples begin at byte {}; they should begin at a whole number "
                               "from {} on",
                               offset, least));
        out_.data_offset = static_cast<std::uint64_t>(offset);
    }

    void take_scale()
    {
        const double slope = real(places_.slope), intercept = real(places_.intercept);
        if (slope == 0) return; // values are samples
        if (!std::isfinite(slope) || !std::isfinite(intercept)) {
            out_.notices.push_back(
                "its scale of values is not finite; samples are taken as values");
            return;
        }
        out_.slope = slope;
        out_.intercept = intercept;
    }

    void take_units()
    {
        const int units = first_ ? static_cast<unsigned char>(bytes_[places_.units])
                                 : nifti_field<std::int32_t>(bytes_, places_.units, order_);
        switch (units & 7) {
        case 1: out_.metres_per_unit = 1; break;
        case 2: out_.metres_per_unit = 1e-3; break;
        case 3: out_.metres_per_unit = 1e-6; break;
        default: break; // not said
        }
    }

    VolumeFrame general_frame() const
    {
        VolumeFrame frame;
        for (int row = 0; row < 3; ++row)
            for (int k = 0; k < 4; ++k) {
                const double value = real(places_.srow, static_cast<std::size_t>(4 * row + k));
                if (k < 3)
                    frame.steps[k][row] = value;
                else
                    frame.origin[row] = value;
            }
        return frame;
    }

    glm::dvec3 distances() const
    {
        glm::dvec3 out;
        for (int k = 0; k < 3; ++k) {
            out[k] = std::abs(real(places_.pixdim, static_cast<std::size_t>(k) + 1));
            if (!(out[k] > 0 && std::isfinite(out[k]))) out[k] = 0;
        }
        return out;
    }

    // The unit quaternion (a, b, c, d) turns the grid, of which z may go the other way.
    VolumeFrame turned_by_quaternion(const glm::dvec3& distance) const
    {
        double b = real(places_.quatern), c = real(places_.quatern, 1),
               d = real(places_.quatern, 2);
        double a = 1 - (b * b + c * c + d * d);
        if (a < 1e-7) { // half a turn
            const double length = std::sqrt(b * b + c * c + d * d);
            b /= length, c /= length, d /= length, a = 0;
        } else {
            a = std::sqrt(a);
        }
        const double side = real(places_.pixdim) < 0 ? -1 : 1;
        VolumeFrame frame;
        frame.steps[0] = distance.x * glm::dvec3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d),
                                                 2 * (b * d - a * c));
        frame.steps[1] = distance.y * glm::dvec3(2 * (b * c - a * d), a * a + c * c - b * b - d * d,
                                                 2 * (c * d + a * b));
        frame.steps[2] =
            side * distance.z *
            glm::dvec3(2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b);
        for (int k = 0; k < 3; ++k)
            frame.origin[k] = real(places_.qoffset, static_cast<std::size_t>(k));
        return frame;
    }

    void compare(const VolumeFrame& general, const VolumeFrame& turned)
    {
        constexpr double same = 0.02; // of a step
        bool differ = false;
        std::string by_matrix, by_turn;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 a = general.steps[k], b = turned.steps[k];
            differ = differ || glm::length(a - b) > same * glm::length(a);
            by_matrix += (k > 0 ? " x " : "") + number_text(glm::length(a));
            by_turn += (k > 0 ? " x " : "") + number_text(glm::length(b));
        }
        if (differ && spans_space(turned))
            out_.notices.push_back(fmt::format(
                "its two places differ: samples are {} apart by its matrix (sform) and {} by its "
                "turn (qform){}; the matrix was taken",
                by_matrix, by_turn, by_matrix == by_turn ? ", in other directions" : ""));
    }

    void take_frame()
    {
        glm::dvec3 distance = distances();
        const bool general = code(places_.sform) > 0, turned = code(places_.qform) > 0;
        if (general && spans_space(general_frame())) {
            if (turned) compare(general_frame(), turned_by_quaternion(distance));
            out_.frame = turned_frame(general_frame(), {-1, -1, 1});
            return;
        }
        if (distance.x * distance.y * distance.z == 0) {
            for (int k = 0; k < 3; ++k)
                if (distance[k] == 0) distance[k] = 1;
            out_.notices.push_back("it does not say how far its samples are apart; 1 was taken");
        }
        if (turned && spans_space(turned_by_quaternion(distance))) {
            out_.frame = turned_frame(turned_by_quaternion(distance), {-1, -1, 1});
            return;
        }
        if (general || turned)
            out_.notices.push_back("its orientation is damaged; the grid stands along the axes");
        else
            out_.notices.push_back(
                "it does not say how the patient lies; the grid stands along the "
                "axes");
        out_.frame = upright_frame(distance);
        if (!spans_space(out_.frame)) refuse("its samples are too close together or too far apart");
    }

    std::string_view bytes_;
    std::string name_;
    bool first_;
    const NiftiPlaces& places_;
    ByteOrder order_;
    NiftiHeader out_;
};

} // namespace

bool is_nifti(std::string_view bytes)
{
    return is_version(bytes, first_version) || is_version(bytes, second_version);
}

NiftiHeader read_nifti_header(std::string_view bytes, const std::string& name)
{
    return NiftiHead(bytes, name).header();
}

} // namespace trivar
