// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_stream.h"

#include <algorithm>

namespace trivar {
namespace {

// Makes a stream of the bytes after a place.
class DicomStreamFactory : public DcmInputStreamFactory {
public:
    explicit DicomStreamFactory(std::string_view bytes) : bytes_(bytes) {}
    DcmInputStream* create() const override { return new DicomStream(bytes_); }
    DcmInputStreamFactory* clone() const override { return new DicomStreamFactory(bytes_); }
    DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }

private:
    std::string_view bytes_;
};

} // namespace

DicomStream::DicomStream(std::string_view bytes) : bytes_(bytes)
{
    setBuffer(bytes.data(), static_cast<offile_off_t>(bytes.size()));
    setEos();
}

DcmInputStreamFactory* DicomStream::newFactory() const
{
    const auto read = static_cast<std::size_t>(std::max<offile_off_t>(tell(), 0));
    return new DicomStreamFactory(bytes_.substr(std::min(read, bytes_.size())));
}

} // namespace trivar
