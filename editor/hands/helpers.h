// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <vector>

namespace trivar {

// Helpers are drawn over the scene to work on it.
struct Helpers {
    std::vector<gpu::Line> lines = {};
    std::vector<gpu::Translucent> veils = {};
};

} // namespace trivar
