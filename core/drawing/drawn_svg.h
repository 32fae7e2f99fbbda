// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/line_list.h"
#include "core/drawing/svg_text.h"

namespace trivar {

// A DrawnSvg tells which elements of an .svg were drawn here; all others are a person's own.
struct DrawnSvg {
    std::vector<SvgElement> elements;
    std::vector<bool> off; // of each: it, or what it is in, is not displayed
    SvgClasses classes;
    std::optional<std::size_t> list, paper;   // their elements
    std::map<std::string, ListedLine> listed; // lines of the list, by their ids
    std::optional<ListedSheet> sheet;         // as it was listed
    std::map<std::string, std::size_t> paths; // elements of lines, by the ids that they have
    std::size_t own = 0; // a person's shapes, texts and groups that are in no other of them
};

// Reads an .svg: nothing where no line and no list of it was drawn here. Where the list is lost,
// lines are known by their ids, in groups with the ids of their layers. Throws Rejected as
// svg_elements() does.
std::optional<DrawnSvg> drawn_svg(std::string_view text);

// The id of a line without the number of its path, "bone-s1a_2": "bone-s1a".
std::string without_number(const std::string& id);

} // namespace trivar
