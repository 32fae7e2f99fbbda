// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/deform_timer.h"
#include "gpu/picture.h"

#include <optional>

namespace trivar::gpu {

// A WayTime is the time that one way needs to deform everything in a picture's volumes.
struct WayTime {
    DeformBy by = DeformBy::processor;
    std::size_t vertices = 0;
    double time_ms = 0;
    // The differences from the processor's result, the largest of all meshes; empty for the
    // processor itself.
    std::optional<DeformErrors> off;
    std::string why_not; // a sentence that says why the device cannot
};

// A WayTimer measures the ways in the current context, one per call: the first volume of each
// instance. Afterwards nothing is bound.
class WayTimer {
public:
    WayTime operator()(const Picture& picture, DeformBy by);

private:
    std::unique_ptr<DeformTimer> timer_;
};

} // namespace trivar::gpu
