// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only the sources of this room that read DICOM include this header, as dicom_dataset.h.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcistrmb.h>
#include <string_view>

namespace trivar {

// A DicomStream gives DCMTK the bytes of a file in memory. DCMTK's own stream of memory takes as
// much as an element says it is long before it looks whether that is there, up to 4 GB for a file
// of 1 kB. This one lets it leave large values where they are and read them when they are asked
// for, as it does with files: a value that goes beyond the end is then an error, and pixels are not
// copied before they are wanted. The bytes must outlive all that is read from them.
class DicomStream : public DcmInputBufferStream {
public:
    explicit DicomStream(std::string_view bytes);
    DcmInputStreamFactory* newFactory() const override; // owned by the caller

private:
    std::string_view bytes_;
};

} // namespace trivar
