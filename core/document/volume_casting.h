// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/transfer.h"

namespace trivar {

// A VolumeCasting says how volume data are seen as a whole, by rays cast through them. Its box cuts
// off what is cast only: levels keep their surfaces and lines, which then stand free before it.
struct VolumeCasting {
    bool shown = false;
    std::vector<TransferPoint> points = {}; // none: usual_transfer()
    double density = 1;                     // what the thickness of a voxel is multiplied by
    double shading = 0.8;                   // 0: colours as they are, 1: lit where values change
    // The corners of the box that is seen, as shares of the grid along its axes.
    glm::vec3 crop_low{0}, crop_high{1};
    bool operator==(const VolumeCasting&) const = default;
};

} // namespace trivar
