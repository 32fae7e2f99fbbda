// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/deform_timer.h"
#include "gpu/picture.h"

#include <optional>

namespace trivar::gpu {

// What one way of deforming all that a picture's volumes deform takes.
struct WayTime {
    DeformBy by = DeformBy::processor;
    std::size_t vertices = 0;
    double time_ms = 0;
    // From what the processor finds, the largest of all meshes; none of the processor itself.
    std::optional<DeformErrors> off;
    std::string why_not; // a sentence, where the device cannot
};

// Times the ways in the current context, one a call: the first volume of each instance. What was
// bound is left unbound.
class WayTimer {
public:
    WayTime operator()(const Picture& picture, DeformBy by);

private:
    std::unique_ptr<DeformTimer> timer_;
};

} // namespace trivar::gpu
