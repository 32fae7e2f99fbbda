// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/silhouette/drawing_layer.h"

#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// A DrawingSheet is lines in layers on a sheet, ready to be written to a file.
struct DrawingSheet {
    std::vector<DrawingLayer> layers;
    glm::dvec2 size{1000};                         // pixels
    std::optional<glm::vec3> paper = glm::vec3(1); // sRGB; none: nothing behind the lines
    glm::dmat4 to_metres{1};                       // of the points that lines have in space
};

// The id of a line in files, of its layer's name, whether it is hidden, and its own id. All lines
// that are drawn for one stroke have the same.
std::string line_id(const DrawingLayer& layer, const InkedLine& line);

// The kinds of files that a drawing can be written to.
enum class DrawingFormat { svg, pdf, png, obj };

// The format of a file by the end of its name. Throws Rejected where there is none.
DrawingFormat drawing_format(std::string_view path);

// The bytes of a file with a drawing: .svg (see svg.h), .pdf and .png by cairo (the same lines; a
// .pdf has the sheet's size in points), .obj with the lines in space, one object per layer, metres.
// Throws Rejected where cairo cannot make a picture of that size.
std::string drawing_bytes(const DrawingSheet& drawing, DrawingFormat format);

} // namespace trivar
