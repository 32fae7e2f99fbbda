// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/drawing_layer.h"

#include <optional>
#include <string>

namespace trivar {

// A DrawingSheet is lines in layers on a sheet, ready to be written to a file.
struct DrawingSheet {
    std::vector<DrawingLayer> layers;
    glm::dvec2 size{1000};                         // pixels
    std::optional<glm::vec3> paper = glm::vec3(1); // sRGB; none: nothing behind the lines
    glm::dmat4 to_metres{1};                       // of the points that lines have in space
    // The list of lines that an .svg states as drawn, see line_list(), if a hand's edits were
    // applied to the lines since; empty: the lines as they are.
    std::string list = {};
    // The .svg that the edits are of: an .svg is written into it; see updated_svg().
    std::string earlier = {};
};

} // namespace trivar
