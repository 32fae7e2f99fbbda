// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/dicom_frame.h"

#include <vector>

namespace trivar {

class DicomDataset;

// The slices of a file, in its order, with their places.
struct DicomFrames {
    std::vector<DicomFrame> frames;
    bool spaced = true; // it says how far its pixels are apart
};

// Throws Rejected where the places are not said or damaged.
DicomFrames dicom_frames(DicomDataset& file, unsigned long count);

} // namespace trivar
