// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar::testing {

// How the pixels of a DICOM file are written.
enum class DicomPacking {
    none,
    big_endian,
    implicit,
    rle,
    deflated,
    jpeg_lossless,
    jpeg_ls,
    jpeg2000_claimed
};

// A slice as DCMTK writes it: 6 x 5 pixels, 0.7 mm apart in a row, rows 0.8 mm apart.
struct DicomSlice {
    glm::dvec3 position{0};
    glm::dvec3 along_row{1, 0, 0}, along_column{0, 1, 0};
    std::vector<std::int16_t> samples = std::vector<std::int16_t>(30);
    int rows = 5, columns = 6;
    int number = 0; // InstanceNumber; 0: none
    std::string series = "1.2.3.1", description = "phantom";
    double slope = 1, intercept = -1024;
    int bits_stored = 16;
    bool is_signed = true;
    std::string colours = "MONOCHROME2";
    DicomPacking packing = DicomPacking::none;
};
std::string dicom_file(const DicomSlice& slice);

// A file with many frames: an enhanced one, with the place of each; with the distance between them
// only; or with none, as films are.
enum class FramePlaces { enhanced, spacing, none };
std::string dicom_frames_file(const std::vector<DicomSlice>& frames, FramePlaces places);

// An oblique series of `count` slices 1.25 mm apart, whose names are in another order than their
// places. Sample i of slice k is 100 k + i.
struct NamedSlice {
    std::string name;
    DicomSlice slice;
};
std::vector<NamedSlice> oblique_series(int count);

// Its matrix in metres.
glm::dmat4 oblique_place();

} // namespace trivar::testing
