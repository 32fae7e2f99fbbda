// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/guard.h"

namespace trivar {

struct RepairOptions {
    GuardOptions guard = {};
    // The axis along which columns of control points rise, and the layer on which the volume
    // stands. That layer stays unless nothing else helps.
    int column_axis = 2;
    int ground_layer = 0;
    int passes = 150; // largest number of passes of one way
};

} // namespace trivar
