// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/guard.h"

namespace trivar {

struct RepairOptions {
    GuardOptions guard = {};
    // The layer of control points that lies on what the volume stands on, and the axis across it.
    // Columns rise from it; it stays unless nothing else helps.
    int column_axis = 2;
    int ground_layer = 0;
    int passes = 150; // of one way, at most
};

} // namespace trivar
