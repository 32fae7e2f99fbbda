// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/voxels/dicom_files.h"

#include <cmath>
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>
#include <stdexcept>

namespace trivar::testing {
namespace {

std::string three(const glm::dvec3& v)
{
    return fmt::format("{:.6f}\\{:.6f}\\{:.6f}", v.x, v.y, v.z);
}

void put(DcmItem& item, const DcmTagKey& tag, const std::string& value)
{
    if (item.putAndInsertString(DcmTag(tag), value.c_str()).bad())
        throw std::logic_error("DICOM value");
}

void put_whole(DcmItem& item, const DcmTagKey& tag, int value)
{
    if (item.putAndInsertUint16(DcmTag(tag), static_cast<Uint16>(value)).bad())
        throw std::logic_error("DICOM number");
}

void put_head(DcmDataset& data, const DicomSlice& slice)
{
    put(data, DCM_SOPClassUID, UID_CTImageStorage);
    put(data, DCM_SOPInstanceUID, "1.2.3.4.5");
    put(data, DCM_SeriesInstanceUID, slice.series);
    put(data, DCM_SeriesDescription, slice.description);
    put(data, DCM_Modality, "CT");
    put(data, DCM_RescaleSlope, fmt::format("{}", slice.slope));
    put(data, DCM_RescaleIntercept, fmt::format("{}", slice.intercept));
    put(data, DCM_PhotometricInterpretation, slice.colours);
    put_whole(data, DCM_SamplesPerPixel, 1);
    if (slice.number > 0) put(data, DCM_InstanceNumber, fmt::format("{}", slice.number));
    put_whole(data, DCM_Rows, slice.rows);
    put_whole(data, DCM_Columns, slice.columns);
    put_whole(data, DCM_BitsAllocated, 16);
    put_whole(data, DCM_BitsStored, slice.bits_stored);
    put_whole(data, DCM_HighBit, slice.bits_stored - 1);
    put_whole(data, DCM_PixelRepresentation, slice.is_signed);
}

void put_place(DcmItem& position, DcmItem& orientation, DcmItem& measures, const DicomSlice& slice)
{
    put(position, DCM_ImagePositionPatient, three(slice.position));
    put(orientation, DCM_ImageOrientationPatient,
        three(slice.along_row) + "\\" + three(slice.along_column));
    put(measures, DCM_PixelSpacing, "0.8\\0.7");
}

void put_pixels(DcmDataset& data, const std::vector<std::int16_t>& samples)
{
    const std::vector<Uint16> words(samples.begin(), samples.end());
    if (data.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size()).bad())
        throw std::logic_error("DICOM pixels");
}

E_TransferSyntax transfer_of(DicomPacking packing)
{
    switch (packing) {
    case DicomPacking::big_endian: return EXS_BigEndianExplicit;
    case DicomPacking::implicit: return EXS_LittleEndianImplicit;
    case DicomPacking::rle: return EXS_RLELossless;
    case DicomPacking::deflated: return EXS_DeflatedLittleEndianExplicit;
    case DicomPacking::jpeg_lossless: return EXS_JPEGProcess14SV1;
    case DicomPacking::jpeg_ls: return EXS_JPEGLSLossless;
    default: return EXS_LittleEndianExplicit;
    }
}

// DCMTK's encoders, known to the whole process.
struct Encoders {
    Encoders()
    {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        DJEncoderRegistration::registerCodecs();
        DJLSEncoderRegistration::registerCodecs();
        DcmRLEEncoderRegistration::registerCodecs();
    }
    ~Encoders()
    {
        DJEncoderRegistration::cleanup();
        DJLSEncoderRegistration::cleanup();
        DcmRLEEncoderRegistration::cleanup();
    }
};

std::string file_bytes(DcmFileFormat& file, DicomPacking packing)
{
    const E_TransferSyntax transfer = transfer_of(packing);
    static const Encoders once;
    OFCondition changed;
    if (packing == DicomPacking::jpeg_lossless) {
        const DJ_RPLossless prediction;
        changed = file.getDataset()->chooseRepresentation(transfer, &prediction);
    } else {
        changed = file.getDataset()->chooseRepresentation(transfer, nullptr);
    }
    if (changed.bad()) throw std::logic_error(changed.text());
    std::string out(1 << 20, '\0');
    DcmOutputBufferStream stream(out.data(), static_cast<offile_off_t>(out.size()));
    file.transferInit();
    const OFCondition written = file.write(stream, transfer, EET_ExplicitLength, nullptr);
    stream.flush(); // what is deflated
    file.transferEnd();
    if (written.bad()) throw std::logic_error(written.text());
    void* from = nullptr;
    offile_off_t size = 0;
    stream.flushBuffer(from, size);
    out.resize(static_cast<std::size_t>(size));
    return out;
}

} // namespace

std::string dicom_file(const DicomSlice& slice)
{
    DcmFileFormat file;
    DcmDataset& data = *file.getDataset();
    put_head(data, slice);
    put_place(data, data, data, slice);
    put_pixels(data, slice.samples);
    if (slice.packing != DicomPacking::jpeg2000_claimed) return file_bytes(file, slice.packing);
    std::string bytes = file_bytes(file, DicomPacking::rle);
    const std::string rle = "1.2.840.10008.1.2.5", other = "1.2.840.10008.1.2.4.90";
    const std::size_t at = bytes.find(rle);
    bytes.replace(at, rle.size() + 1, other); // both are of even length
    bytes[at - 2] = static_cast<char>(other.size());
    // The length of the group of heads stands in front of it, behind "DICM" and its own tag.
    bytes[140] = static_cast<char>(bytes[140] + static_cast<char>(other.size() - rle.size() - 1));
    return bytes;
}

std::string dicom_frames_file(const std::vector<DicomSlice>& frames, FramePlaces places)
{
    DcmFileFormat file;
    DcmDataset& data = *file.getDataset();
    put_head(data, frames[0]);
    put(data, DCM_NumberOfFrames, std::to_string(frames.size()));
    std::vector<std::int16_t> samples;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        samples.insert(samples.end(), frames[k].samples.begin(), frames[k].samples.end());
        if (places != FramePlaces::enhanced) continue;
        DcmItem *frame = nullptr, *position = nullptr, *orientation = nullptr, *measures = nullptr;
        data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, -2);
        frame->findOrCreateSequenceItem(DCM_PlanePositionSequence, position, 0);
        frame->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, orientation, 0);
        frame->findOrCreateSequenceItem(DCM_PixelMeasuresSequence, measures, 0);
        put_place(*position, *orientation, *measures, frames[k]);
    }
    if (places != FramePlaces::enhanced) put_place(data, data, data, frames[0]);
    if (places == FramePlaces::spacing) put(data, DCM_SpacingBetweenSlices, "1.25");
    put_pixels(data, samples);
    return file_bytes(file, DicomPacking::none);
}

std::vector<NamedSlice> oblique_series(int count)
{
    const double c = std::cos(0.3), s = std::sin(0.3);
    std::vector<NamedSlice> out;
    for (int k = 0; k < count; ++k) {
        NamedSlice named{fmt::format("im{:03}.dcm", (k * 7 + 3) % 101), {}};
        DicomSlice& slice = named.slice;
        slice.along_column = {0, c, s};
        slice.position = glm::dvec3(10, 20, 30) + 1.25 * k * glm::dvec3(0, -s, c);
        for (std::size_t i = 0; i < slice.samples.size(); ++i)
            slice.samples[i] = static_cast<std::int16_t>(100 * k + static_cast<int>(i));
        out.push_back(named);
    }
    return out;
}

glm::dmat4 oblique_place()
{
    const double c = std::cos(0.3), s = std::sin(0.3);
    return {{0.0007, 0, 0, 0},
            {0, 0.0008 * c, 0.0008 * s, 0},
            {0, -0.00125 * s, 0.00125 * c, 0},
            {0.01, 0.02, 0.03, 1}};
}

} // namespace trivar::testing
