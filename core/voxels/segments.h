// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A VolumeSegment is a segment of a label map: the meaning of its samples with that value.
struct VolumeSegment {
    std::string name = {};
    double value = 0; // the label
    double level = 0; // halfway to the next lower label: a body above it has this and all higher
};

// The named segments of a label map as 3D Slicer writes it (.seg.nrrd), from the lowest value on;
// of several layers those of the first. None for any other file.
std::vector<VolumeSegment> segments_of(const std::string& path);

} // namespace trivar
