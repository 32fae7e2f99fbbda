// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/dicom_frame.h"
#include "core/voxels/sample_type.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A DicomHead is the description of the pixels of a DICOM file.
struct DicomHead {
    std::string series;       // its SeriesInstanceUID
    std::string series_words; // for the user: its description, else the end of the former
    std::string modality;     // CT, MR, ...
    std::string unit;         // of values: HU, or empty
    long number = 0;          // its InstanceNumber; 0: it has none
    std::int64_t columns = 0, rows = 0;
    SampleType type = SampleType::u16; // of samples, bits that are not stored masked out
    std::vector<DicomFrame> frames;
    bool spaced = true;    // distances between pixels are known
    bool inverted = false; // low values are bright
};

// Whether bytes are a DICOM file's.
bool is_dicom(std::string_view bytes);

// Reads all but the pixels, of which it checks that they are there. A file without any (a
// directory, a report) has no frames. Throws Rejected for damaged and cut files, colours, slices
// without a place, and transfer syntaxes that cannot be decoded. Uses DCMTK.
DicomHead read_dicom_head(std::string_view bytes, const std::string& name);

// The SeriesInstanceUID of a file, also of one whose pixels are refused. Throws Rejected where the
// file is damaged or cut.
std::string dicom_series_of(std::string_view bytes, const std::string& name);

// The samples of all frames of such a file, decoded; samples of 32 bits as floats. Throws Rejected.
TakenSamples read_dicom_samples(std::string_view bytes, const DicomHead& head,
                                const std::string& name);

} // namespace trivar
