// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"

namespace trivar {

// A VolumeReading says of volume data what their files do not: of a file without a head how its
// samples lie, of raw files and pictures how far apart they are; and how much of them is kept.
struct VolumeReading {
    glm::ivec3 size{0}; // number of samples along each axis; 0: as the file or its name says
    SampleType type = SampleType::u8;
    ByteOrder order = ByteOrder::little;
    int header_bytes = 0;     // before the samples
    glm::dvec3 spacing_mm{1}; // between samples
    // Number of samples along each axis of which one is made while the files are read, so that data
    // larger than memory come in; 1: all are kept.
    int coarsen = 1;
    bool operator==(const VolumeReading&) const = default;
};

} // namespace trivar
