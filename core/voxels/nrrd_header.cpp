// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/nrrd_header.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/voxels/nrrd_fields.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <optional>
#include <teem/nrrd.h>

namespace trivar {
namespace {

struct NrrdNuke {
    void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
    void operator()(NrrdIoState* state) const { nrrdIoStateNix(state); }
};
using OwnedNrrd = std::unique_ptr<Nrrd, NrrdNuke>;
using OwnedState = std::unique_ptr<NrrdIoState, NrrdNuke>;

// The library keeps its messages in one place for the whole process.
std::mutex& teem_mutex()
{
    static std::mutex mutex;
    return mutex;
}

constexpr const char* no_order =
    "it does not say the order of bytes; it should have a line 'endian: "
    "little' or 'endian: big'";

// Returns the text between two others; nothing if one of them is missing.
std::optional<std::string_view> between(std::string_view text, std::string_view front,
                                        std::string_view back)
{
    const std::size_t begin = text.find(front), from = begin + front.size();
    const std::size_t end = begin == text.npos ? begin : text.find(back, from);
    if (end == text.npos) return {};
    return text.substr(from, end - from);
}

// Explains in our words, from the messages of the library, outermost to innermost, the fault that
// it found.
std::string teem_reason()
{
    const std::unique_ptr<char, decltype(&std::free)> all(biffGetDone(NRRD), &std::free);
    const std::string_view text = all ? all.get() : "";
    if (const auto field = between(text, "trouble parsing ", " info |"))
        return fmt::format("its line '{}: {}' cannot be read", shown(*field),
                           shown(between(text, " info |", "|\n").value_or("")));
    if (const auto line = between(text, "field identifier from in \"", "\"\n"))
        return fmt::format("its line '{}' is not 'field: value'", shown(*line));
    if (text.find("require endian info") != text.npos) return no_order;
    return "its version is not known, or a line is missing: type, dimension, sizes and encoding "
           "are needed";
}

class NrrdHead {
public:
    NrrdHead(const Nrrd& nrrd, const NrrdIoState& state, std::string name)
        : nrrd_(nrrd),
          state_(state),
          name_(std::move(name))
    {
    }

    NrrdHeader header()
    {
        find_axes();
        for (std::size_t k = 0; k < 3; ++k)
            out_.block.size[k] = static_cast<std::int64_t>(axis(k).size);
        out_.block.type = type();
        check_block(out_.block, name_);
        out_.encoding = encoding();
        out_.order = state_.endian == airEndianBig ? ByteOrder::big : ByteOrder::little;
        const bool ordered = out_.encoding == NrrdEncoding::ascii || size_of(out_.block.type) == 1;
        if (!ordered && state_.endian != airEndianBig && state_.endian != airEndianLittle)
            refuse(no_order);
        out_.line_skip = state_.lineSkip;
        out_.byte_skip = state_.byteSkip;
        take_frame();
        return std::move(out_);
    }

private:
    [[noreturn]] void refuse(std::string_view reason) const
    {
        throw Rejected(fmt::format("{}: {}", name_, reason));
    }
    const NrrdAxisInfo& axis(std::size_t k) const { return nrrd_.axis[axes_[k]]; }

    // Whether an axis counts volumes, such as times: it says so, it alone has no direction, or it
    // is the last of four that say nothing.
    bool counts_volumes(unsigned a, std::size_t found) const
    {
        const NrrdAxisInfo& info = nrrd_.axis[a];
        if (info.kind == nrrdKindList || info.kind == nrrdKindTime) return true;
        if (info.kind != nrrdKindUnknown) return false;
        constexpr std::size_t most_colours = 4;
        if (nrrd_.spaceDim == 3) return !std::isfinite(info.spaceDirection[0]);
        return found == 3 && nrrd_.axis[0].size > most_colours;
    }

    // Finds the three axes of the grid, and one of several volumes; others may have one sample
    // only.
    void find_axes()
    {
        std::size_t found = 0;
        std::uint64_t in_turn = 1; // samples of a volume
        for (unsigned a = 0; a < nrrd_.dim; ++a) {
            const NrrdAxisInfo& info = nrrd_.axis[a];
            const bool of_space = info.kind == nrrdKindUnknown || info.kind == nrrdKindDomain ||
                                  info.kind == nrrdKindSpace;
            const bool spare = nrrd_.dim - a + found > 3;
            if (info.size == 1 && spare) continue;
            if (spare && out_.volumes == 1 && counts_volumes(a, found)) {
                out_.volumes = info.size;
                out_.in_turn = in_turn;
                continue;
            }
            if (!of_space)
                refuse(fmt::format("its axis {} holds {} values for each point ({}); a volume has "
                                   "one number at each point",
                                   a + 1, info.size, airEnumStr(nrrdKind, info.kind)));
            if (found == 3) refuse(fmt::format("it has {} dimensions; a volume has 3", nrrd_.dim));
            axes_[found++] = a;
            in_turn *= info.size; // teem refuses sizes whose product is beyond its numbers
        }
        if (found < 3)
            refuse(fmt::format("it has {}; a volume has 3",
                               counted(nrrd_.dim, "dimension", "dimensions")));
    }

    SampleType type() const
    {
        switch (nrrd_.type) {
        case nrrdTypeChar: return SampleType::i8;
        case nrrdTypeUChar: return SampleType::u8;
        case nrrdTypeShort: return SampleType::i16;
        case nrrdTypeUShort: return SampleType::u16;
        case nrrdTypeInt: return SampleType::i32;
        case nrrdTypeUInt: return SampleType::u32;
        case nrrdTypeLLong: return SampleType::i64;
        case nrrdTypeULLong: return SampleType::u64;
        case nrrdTypeFloat: return SampleType::f32;
        case nrrdTypeDouble: return SampleType::f64;
        default: refuse("its samples are blocks of bytes; a volume has one number at each point");
        }
    }

    NrrdEncoding encoding() const
    {
        if (state_.encoding == nrrdEncodingRaw) return NrrdEncoding::raw;
        if (state_.encoding == nrrdEncodingGzip) return NrrdEncoding::gzip;
        if (state_.encoding == nrrdEncodingBzip2) return NrrdEncoding::bzip2;
        if (state_.encoding == nrrdEncodingAscii) return NrrdEncoding::ascii;
        if (state_.encoding == nrrdEncodingHex) return NrrdEncoding::hex;
        refuse("its encoding is not known; raw, gzip, bzip2, ascii and hex can be read");
    }

    void take_frame()
    {
        if (nrrd_.spaceDim == 3 && has_directions()) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double* step = axis(k).spaceDirection;
                out_.frame.steps[static_cast<int>(k)] = {step[0], step[1], step[2]};
            }
            const double* origin = nrrd_.spaceOrigin;
            if (std::isfinite(origin[0]) && std::isfinite(origin[1]) && std::isfinite(origin[2]))
                out_.frame.origin = {origin[0], origin[1], origin[2]};
            turn_to_lps();
        } else {
            glm::dvec3 spacing(1), origin(0);
            for (std::size_t k = 0; k < 3; ++k) {
                const NrrdAxisInfo& info = axis(k);
                const int i = static_cast<int>(k);
                if (std::isfinite(info.spacing)) spacing[i] = info.spacing;
                if (std::isfinite(info.min))
                    origin[i] = info.min + (info.center == nrrdCenterCell ? spacing[i] / 2 : 0);
            }
            out_.frame = upright_frame(spacing, origin);
            if (!std::isfinite(axis(0).spacing))
                out_.notices.push_back(
                    "it does not say how far its samples are apart; 1 was taken");
        }
        if (!spans_space(out_.frame))
            refuse("its space directions do not span space; they should be three finite vectors "
                   "that lie in no plane");
        take_unit();
    }

    bool has_directions() const
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (!std::isfinite(axis(k).spaceDirection[0])) return false;
        return true;
    }

    void turn_to_lps()
    {
        switch (nrrd_.space) {
        case nrrdSpaceRightAnteriorSuperior:
            out_.frame = turned_frame(out_.frame, {-1, -1, 1});
            break;
        case nrrdSpaceLeftAnteriorSuperior:
            out_.frame = turned_frame(out_.frame, {1, -1, 1});
            break;
        default: break; // LPS, or a space that is no patient's
        }
    }

    void take_unit()
    {
        const char* said = nrrd_.spaceUnits[0] ? nrrd_.spaceUnits[0] : axis(0).units;
        const std::string unit(said ? said : "");
        const bool plain = glm::length(out_.frame.steps[0]) == 1 &&
                           glm::length(out_.frame.steps[1]) == 1 &&
                           glm::length(out_.frame.steps[2]) == 1;
        if (unit.empty() && plain && out_.notices.empty())
            out_.notices.push_back("its samples are 1 apart along each axis, without a unit, so it "
                                   "may not know their distance; 1 mm was taken");
        if (unit == "mm" || unit == "millimeter" || unit == "millimetre")
            out_.metres_per_unit = 1e-3;
        else if (unit == "cm")
            out_.metres_per_unit = 1e-2;
        else if (unit == "m" || unit == "meter" || unit == "metre")
            out_.metres_per_unit = 1;
        else if (unit == "um" || unit == "micron" || unit == "microns" || unit == "\xc2\xb5m")
            out_.metres_per_unit = 1e-6;
        else if (unit == "nm")
            out_.metres_per_unit = 1e-9;
        else if (!unit.empty())
            out_.notices.push_back(
                fmt::format("its unit '{}' is not known; mm was taken", shown(unit)));
    }

    const Nrrd& nrrd_;
    const NrrdIoState& state_;
    std::string name_;
    std::array<unsigned, 3> axes_{};
    NrrdHeader out_;
};

} // namespace

NrrdHeader read_nrrd_header(std::string_view bytes, const std::string& name)
{
    NrrdFields fields = nrrd_fields(bytes, name);
    const OwnedNrrd nrrd(nrrdNew());
    const OwnedState state(nrrdIoStateNew());
    {
        const std::lock_guard lock(teem_mutex());
        state->skipData = 1;
        if (nrrdStringRead(nrrd.get(), fields.text.c_str(), state.get()))
            throw Rejected(
                fmt::format("{}: the head of this NRRD file is damaged: {}", name, teem_reason()));
    }
    NrrdHeader header = NrrdHead(*nrrd, *state, name).header();
    header.data_files = std::move(fields.data_files);
    header.size = fields.size;
    return header;
}

} // namespace trivar
