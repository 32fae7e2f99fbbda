// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// One slice in a DICOM file.
struct DicomFrame {
    glm::dvec3 position{0};           // of the middle of its first pixel: mm, LPS
    glm::dvec3 along_row{1, 0, 0};    // unit vectors: to the next pixel of a row,
    glm::dvec3 along_column{0, 1, 0}; // and to the next row
    glm::dvec2 spacing{1};            // mm between the pixels of a row, and between rows
    double slope = 1, intercept = 0;
};

} // namespace trivar
