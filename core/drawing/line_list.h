// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"
#include "core/drawing/edited_lines.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// The id of the element of an .svg that has the list of its lines.
inline constexpr std::string_view line_list_id = "trivar-lines";
inline constexpr std::string_view paper_id = "trivar-paper"; // of the <rect> behind all lines

// The id of a layer in files, of its name: letters of all languages, digits and points stay, and
// each other letter becomes a dash.
std::string layer_id(std::string_view name);
// Names of layers of which no two have one layer_id(): ".2", ".3" and so on follow those that do.
std::vector<std::string> names_apart(std::vector<std::string> names);
std::vector<std::string> layer_ids(std::span<const DrawingLayer> layers); // no two are the same
// The id of a line in files, of the id of its layer, whether it is hidden, and its own id. All
// lines that are drawn for one stroke have the same.
std::string line_id(const std::string& layer_id, const InkedLine& line);
std::string hex_color(const glm::vec3& color); // "#8040ff" of sRGB, 0 .. 1

// A ListedLine is a line as it was drawn into a file.
struct ListedLine {
    float width = 0;      // width_of()
    float widened = 0;    // the same after a hand's edits
    bool outline = false; // is drawn as a filled outline; else as a stroke
    std::string color;    // hex_color() of its first point
    std::string layer;    // layer_id()
    std::string text;     // its line of the list
    LineRecord record = {};
};

// A ListedSheet is the sheet as it was drawn into a file.
struct ListedSheet {
    std::string width, height; // short_number(), pixels
    std::string paper;         // hex_color(), or "none"
};

std::string short_number(double value); // with at most one digit after the point

// A text that lists the sheet and the lines of a drawing, one per line of text: id, width, colour,
// and points in whole voxels, each as its difference from the one before, about one per 4 voxels of
// length. The width of an outline is told twice, as 2.60/3.10: before and after the edits that will
// be done to it. Lines that they delete are listed, too, also where they are not in this drawing.
std::string line_list(const DrawingSheet& drawing, const HandEdits& edits = {});

// Reads such a list: its lines by their ids. Lines of text that are damaged are left out. Lists of
// earlier versions have no sheet.
std::map<std::string, ListedLine> listed_lines(std::string_view text);
std::optional<ListedSheet> listed_sheet(std::string_view text);
// The layer_id() in a line_id(); nothing where it is none.
std::optional<std::string> layer_of_line(const std::string& id);

} // namespace trivar
