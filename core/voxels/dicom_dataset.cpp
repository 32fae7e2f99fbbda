// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_dataset.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/voxels/dicom_stream.h"

#include <cmath>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

namespace trivar {
namespace {

// The library has its decoders and its messages for the whole process: the former are made known
// once, the latter are silent, because errors come back as values.
struct DcmtkSetUp {
    DcmtkSetUp()
    {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
        DcmRLEDecoderRegistration::registerCodecs();
    }
    ~DcmtkSetUp()
    {
        DJDecoderRegistration::cleanup();
        DJLSDecoderRegistration::cleanup();
        DcmRLEDecoderRegistration::cleanup();
    }
};

void set_up_dcmtk()
{
    static const DcmtkSetUp once;
}

} // namespace

DicomDataset::DicomDataset(std::string_view bytes, std::string name) : name_(std::move(name))
{
    set_up_dcmtk();
    DicomStream stream(bytes);
    OFCondition read;
    try {
        file_.transferInit();
        read = file_.read(stream);
        file_.transferEnd();
    } catch (const std::exception&) { // out of memory
        refuse("this DICOM file is damaged");
    }
    if (read.bad())
        refuse(
            fmt::format("this DICOM file is damaged or ends too early ({})", shown(read.text())));
}

void DicomDataset::refuse(std::string_view reason) const
{
    throw Rejected(fmt::format("{}: {}", name_, reason));
}

std::string dicom_text(DcmItem& item, const DcmTagKey& tag)
{
    OFString text;
    if (item.findAndGetOFString(tag, text).bad()) return {};
    std::string out(text);
    out.resize(std::min(out.find('\0'), out.size()));
    while (out.ends_with(' ')) out.pop_back();
    out.erase(0, std::min(out.find_first_not_of(' '), out.size()));
    return out;
}

std::vector<double> dicom_numbers(DcmItem& item, const DcmTagKey& tag, unsigned long count)
{
    std::vector<double> out;
    for (unsigned long k = 0; k < count; ++k) {
        Float64 value = 0;
        if (item.findAndGetFloat64(tag, value, k).bad() || !std::isfinite(value)) return {};
        out.push_back(value);
    }
    return out;
}

} // namespace trivar
