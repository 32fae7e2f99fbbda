// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_file.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/voxels/dicom_dataset.h"
#include "core/voxels/dicom_frames.h"
#include "core/voxels/dicom_nesting.h"
#include "core/voxels/inflate.h"

#include <algorithm>
#include <cstring>
#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcxfer.h>
#include <fmt/format.h>

namespace trivar {
namespace {

// StoredBits tells how the bits of a sample lie in its 8, 16 or 32.
struct StoredBits {
    unsigned allocated = 16, stored = 16, high = 15;
    bool is_signed = false;
};

unsigned whole_of(DcmItem& item, const DcmTagKey& tag, unsigned otherwise)
{
    Uint16 value = 0;
    return item.findAndGetUint16(tag, value).good() ? value : otherwise;
}

StoredBits stored_bits(DicomDataset& file)
{
    StoredBits bits;
    bits.allocated = whole_of(file.data(), DCM_BitsAllocated, 0);
    bits.stored = whole_of(file.data(), DCM_BitsStored, bits.allocated);
    bits.high = whole_of(file.data(), DCM_HighBit, bits.stored - 1);
    bits.is_signed = whole_of(file.data(), DCM_PixelRepresentation, 0) == 1;
    if (bits.allocated != 8 && bits.allocated != 16 && bits.allocated != 32)
        file.refuse(fmt::format("its samples have {} bits; 8, 16 and 32 are read", bits.allocated));
    if (bits.stored < 1 || bits.stored > bits.allocated || bits.high >= bits.allocated ||
        bits.high + 1 < bits.stored)
        file.refuse(fmt::format("its BitsStored {} and HighBit {} do not fit its {} bits",
                                bits.stored, bits.high, bits.allocated));
    return bits;
}

SampleType type_of(const StoredBits& bits)
{
    if (bits.allocated == 8) return bits.is_signed ? SampleType::i8 : SampleType::u8;
    if (bits.allocated == 16) return bits.is_signed ? SampleType::i16 : SampleType::u16;
    return bits.is_signed ? SampleType::i32 : SampleType::u32;
}

unsigned long frame_count(DicomDataset& file)
{
    constexpr long most = 100'000;
    const std::string words = dicom_text(file.data(), DCM_NumberOfFrames);
    if (words.empty()) return 1;
    Sint32 count = 0;
    if (file.data().findAndGetSint32(DCM_NumberOfFrames, count).bad() || count < 1 || count > most)
        file.refuse(fmt::format("its NumberOfFrames is '{}'; it should be from 1 to {}",
                                shown(words), with_commas(most)));
    return static_cast<unsigned long>(count);
}

// Pixels that are not packed must be there to the last byte; packed ones can be so many only.
void check_pixels(DicomDataset& file, const DicomHead& head, std::string_view bytes,
                  const std::string& name)
{
    DcmElement* pixels = nullptr;
    file.data().findAndGetElement(DCM_PixelData, pixels);
    const std::uint64_t needed = static_cast<std::uint64_t>(head.columns) *
                                 static_cast<std::uint64_t>(head.rows) * head.frames.size() *
                                 size_of(head.type); // at most 2^51
    const DcmXfer transfer(file.data().getOriginalXfer());
    if (transfer.isEncapsulated()) {
        if (!DcmCodecList::canChangeCoding(transfer.getXfer(), EXS_LittleEndianExplicit))
            file.refuse(
                fmt::format("its pixels are packed as {}, which is not read; JPEG, JPEG-LS, "
                            "RLE and pixels that are not packed are; gdcmconv --raw IN OUT "
                            "writes it again without packing",
                            transfer.getXferName()));
        // JPEG-LS packs runs of one value as tightly as bzip2 does.
        check_ratio(bytes.size(), Packing::bzip2, needed, name);
        return;
    }
    const std::uint64_t present = pixels ? pixels->getLength() : 0;
    if (present != needed && present != needed + needed % 2)
        file.refuse(
            fmt::format("has {} bytes of pixels; {} x {} pixels of {} bits in {} need {}",
                        with_commas(present), head.columns, head.rows, 8 * size_of(head.type),
                        counted(head.frames.size(), "frame", "frames"), with_commas(needed)));
}

std::string words_of_series(DcmItem& data, const std::string& uid)
{
    const std::string words = dicom_text(data, DCM_SeriesDescription);
    if (!words.empty()) return shown(words);
    constexpr std::size_t end = 12;
    return uid.size() > end ? "..." + shown(uid.substr(uid.size() - end)) : shown(uid);
}

DicomHead head_of(std::string_view bytes, const std::string& name)
{
    DicomDataset file(bytes, name);
    DcmDataset& data = file.data();
    DicomHead head;
    head.series = dicom_text(data, DCM_SeriesInstanceUID);
    head.series_words = words_of_series(data, head.series);
    if (!data.tagExists(DCM_Rows) && !data.tagExists(DCM_PixelData)) return head;
    if (!data.tagExists(DCM_PixelData))
        file.refuse("this DICOM file has no whole numbers as pixels, or ends before them");
    head.modality = dicom_text(data, DCM_Modality);
    Sint32 number = 0;
    if (data.findAndGetSint32(DCM_InstanceNumber, number).good()) head.number = number;
    head.rows = whole_of(data, DCM_Rows, 0);
    head.columns = whole_of(data, DCM_Columns, 0);
    if (head.rows < 1 || head.columns < 1)
        file.refuse(fmt::format("its size is {} x {} pixels; it should be at least 2 x 2",
                                head.columns, head.rows));
    const std::string colours = dicom_text(data, DCM_PhotometricInterpretation);
    if (whole_of(data, DCM_SamplesPerPixel, 1) != 1 ||
        (!colours.empty() && !colours.starts_with("MONOCHROME")))
        file.refuse(fmt::format(
            "its pixels are colours ({}); a volume has one number at each point", shown(colours)));
    head.inverted = colours == "MONOCHROME1";
    head.type = type_of(stored_bits(file));
    DicomFrames placed = dicom_frames(file, frame_count(file));
    head.frames = std::move(placed.frames);
    head.spaced = placed.spaced;
    const std::string unit = dicom_text(data, DCM_RescaleType);
    if (unit == "HU" || (head.modality == "CT" && data.tagExistsWithValue(DCM_RescaleIntercept) &&
                         (unit.empty() || unit == "US")))
        head.unit = "HU";
    check_pixels(file, head, bytes, name);
    return head;
}

// Bits that are not stored may hold anything (overlays once did): the stored ones are moved to the
// low end, and a sign is carried up.
template <class T> void keep_stored_bits(std::vector<T>& samples, const StoredBits& bits)
{
    if (bits.stored == bits.allocated) return;
    const unsigned low = bits.high + 1 - bits.stored;
    const std::uint32_t mask = (std::uint32_t{1} << bits.stored) - 1;
    const std::uint32_t sign = bits.is_signed ? std::uint32_t{1} << (bits.stored - 1) : 0;
    for (T& sample : samples) {
        const std::uint32_t value = static_cast<std::uint32_t>(sample) >> low & mask;
        sample = static_cast<T>(static_cast<std::int32_t>((value ^ sign) - sign));
    }
}

template <class T> std::vector<T> pixels_of(DicomDataset& file, std::size_t count)
{
    const auto cut = [&](unsigned long there) {
        file.refuse(fmt::format("its pixels are damaged: of {} samples {} can be decoded",
                                with_commas(count), with_commas(there)));
    };
    std::vector<T> out(count);
    unsigned long words = 0;
    if constexpr (sizeof(T) == 1) {
        const Uint8* all = nullptr;
        const bool read = file.data().findAndGetUint8Array(DCM_PixelData, all, &words).good();
        if (!read || !all || words < count) cut(read ? words : 0);
        std::memcpy(out.data(), all, count);
    } else { // of 32 bits the lower 16 come first
        constexpr std::size_t words_of_one = sizeof(T) / 2;
        const Uint16* all = nullptr;
        const bool read = file.data().findAndGetUint16Array(DCM_PixelData, all, &words).good();
        if (!read || !all || words / words_of_one < count) cut(read ? words / words_of_one : 0);
        std::memcpy(out.data(), all, count * sizeof(T));
    }
    return out;
}

template <class T> TakenSamples samples_as(DicomDataset& file, std::size_t count)
{
    const StoredBits bits = stored_bits(file);
    std::vector<T> samples = pixels_of<T>(file, count);
    keep_stored_bits(samples, bits);
    if constexpr (sizeof(T) == 4)
        return taken_samples({reinterpret_cast<const char*>(samples.data()), 4 * samples.size()},
                             type_of(bits), ByteOrder::little);
    else
        return {std::move(samples), 0};
}

// Whether DCMTK 3.6.7 would look for ever at a marker of a packed picture: it never leaves TEM,
// which no file has any more (ITU-T T.81, table B.1).
bool has_endless_marker(const Uint8* jpeg, std::size_t size)
{
    for (std::size_t at = 2; at + 4 < size;) {
        const unsigned marker = jpeg[at + 1];
        const bool frame = marker == 0xC0 || (marker >= 0xC0 && marker <= 0xCF && marker % 4 != 0);
        if (jpeg[at] != 0xFF || frame) return false;
        if (marker == 0x01) return true;
        if (marker == 0xFF) // a fill byte
            ++at;
        else if (marker <= 0xBF || (marker >= 0xD0 && marker <= 0xD9)) // it stands alone
            at += 2;
        else
            at += 2 + 256u * jpeg[at + 2] + jpeg[at + 3];
    }
    return false;
}

bool has_endless_marker(DcmDataset& data)
{
    DcmElement* element = nullptr;
    if (data.findAndGetElement(DCM_PixelData, element).bad()) return false;
    auto* pixels = dynamic_cast<DcmPixelData*>(element);
    if (!pixels) return false;
    E_TransferSyntax type = EXS_Unknown;
    const DcmRepresentationParameter* parameter = nullptr;
    pixels->getOriginalRepresentationKey(type, parameter);
    if (type < EXS_JPEGProcess1 || type > EXS_JPEGProcess14SV1) return false;
    DcmPixelSequence* fragments = nullptr;
    if (pixels->getEncapsulatedRepresentation(type, parameter, fragments).bad()) return false;
    for (unsigned long i = 0; i < fragments->card(); ++i) {
        DcmPixelItem* item = nullptr;
        Uint8* bytes = nullptr;
        if (fragments->getItem(item, i).good() && item->getUint8Array(bytes).good() && bytes &&
            has_endless_marker(bytes, item->getLength()))
            return true;
    }
    return false;
}

TakenSamples samples_of_file(std::string_view bytes, const DicomHead& head, const std::string& name)
{
    DicomDataset file(bytes, name);
    if (has_endless_marker(file.data())) file.refuse("its packed pixels are damaged");
    OFCondition decoded;
    try {
        decoded = file.data().chooseRepresentation(EXS_LittleEndianExplicit, nullptr);
    } catch (const std::exception&) {
        file.refuse("its packed pixels are damaged");
    }
    if (decoded.bad())
        file.refuse(fmt::format("its packed pixels are damaged ({})", shown(decoded.text())));
    const auto count = static_cast<std::size_t>(head.columns) *
                       static_cast<std::size_t>(head.rows) * head.frames.size();
    if (type_of(stored_bits(file)) != head.type)
        file.refuse("this file was changed while it was read");
    switch (head.type) {
    case SampleType::u8: return samples_as<std::uint8_t>(file, count);
    case SampleType::i8: return samples_as<std::int8_t>(file, count);
    case SampleType::u16: return samples_as<std::uint16_t>(file, count);
    case SampleType::i16: return samples_as<std::int16_t>(file, count);
    case SampleType::i32: return samples_as<std::int32_t>(file, count);
    default: return samples_as<std::uint32_t>(file, count);
    }
}

} // namespace

bool is_dicom(std::string_view bytes)
{
    constexpr std::size_t preamble = 128;
    if (bytes.size() > preamble + 4 && bytes.substr(preamble, 4) == "DICM") return true;
    // Old files begin with an element of group 8 at once.
    if (bytes.size() < 16 || bytes[0] != 8 || bytes[1] != 0 || bytes[3] != 0) return false;
    const std::string_view kind = bytes.substr(4, 2);
    constexpr std::string_view kinds[] = {"UL", "CS", "UI", "DA", "TM", "LO", "SH"};
    if (std::ranges::find(kinds, kind) != std::end(kinds)) return true;
    return bytes.substr(5, 3) == std::string_view("\0\0\0", 3) && bytes[4] > 0 && bytes[4] <= 64 &&
           bytes[4] % 2 == 0 && bytes[2] <= 0x18;
}

DicomHead read_dicom_head(std::string_view bytes, const std::string& name)
{
    DicomHead head;
    with_stack_for_dicom(bytes, name, [&](std::string_view all) { head = head_of(all, name); });
    return head;
}

std::string dicom_series_of(std::string_view bytes, const std::string& name)
{
    std::string series;
    with_stack_for_dicom(bytes, name, [&](std::string_view all) {
        DicomDataset file(all, name);
        series = dicom_text(file.data(), DCM_SeriesInstanceUID);
    });
    return series;
}

TakenSamples read_dicom_samples(std::string_view bytes, const DicomHead& head,
                                const std::string& name)
{
    TakenSamples samples;
    with_stack_for_dicom(bytes, name,
                         [&](std::string_view all) { samples = samples_of_file(all, head, name); });
    return samples;
}

} // namespace trivar
