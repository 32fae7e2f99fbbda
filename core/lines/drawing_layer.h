// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/ink.h"

#include <string>

namespace trivar {

// A DrawingLayer is what one level gives to a drawing.
struct DrawingLayer {
    std::string name; // of the layer in the file
    std::vector<InkedLine> lines;
};

} // namespace trivar
