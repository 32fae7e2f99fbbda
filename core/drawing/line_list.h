// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"
#include "core/silhouette/line_ids.h"

#include <map>
#include <string>
#include <string_view>

namespace trivar {

// The id of the element of an .svg that has the list of its lines.
inline constexpr std::string_view line_list_id = "trivar-lines";

// The id of a line in files, of its layer's name, whether it is hidden, and its own id. All lines
// that are drawn for one stroke have the same.
std::string line_id(const DrawingLayer& layer, const InkedLine& line);
std::string layer_id(const DrawingLayer& layer); // of its name
std::string hex_color(const glm::vec3& color);   // "#8040ff" of sRGB, 0 .. 1
// The width that a line of one width has in a file; of others, that of their middle.
float width_of(const InkedLine& line);

// A ListedLine is a line as it was drawn into a file.
struct ListedLine {
    float width = 0;   // width_of()
    std::string color; // hex_color() of its first point
    std::string layer; // layer_id()
    LineRecord record = {};
};

// A text that lists the lines of a drawing, one per line of text: id, width, colour, and points in
// whole voxels, each as its difference from the one before, about one per 4 voxels of length.
std::string line_list(const DrawingSheet& drawing);

// Reads such a list: its lines by their ids. Lines of text that are damaged are left out.
std::map<std::string, ListedLine> listed_lines(std::string_view text);

} // namespace trivar
