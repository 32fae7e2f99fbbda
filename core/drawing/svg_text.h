// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// An SvgElement is where an element lies in the text of an .svg; offsets are in bytes.
//
//     <g id="a">  content  </g>
//     ^begin    ^tag_end   ^inner_end
//                              ^end       of <g/>, the last three are one
struct SvgElement {
    std::string_view name; // without the prefix of its namespace
    std::size_t begin = 0, tag_end = 0, inner_end = 0, end = 0;
    std::optional<std::size_t> parent = {}; // its number; the root has none
    bool is_empty() const { return tag_end == end; }
};

// An attribute of a start tag: where `name="value"` lies in that tag, in bytes.
struct SvgAttribute {
    std::string_view name, value; // as they are written
    std::size_t begin = 0, end = 0;
};

// The elements of an .svg, each before what is in it. O(#bytes), without recursion. The views
// last as long as the text. Throws Rejected for what is no .svg in UTF-8, is nested more than
// 1,000 deep, has more than 4 million elements, or defines entities by others or by files.
std::vector<SvgElement> svg_elements(std::string_view text);

std::vector<SvgAttribute> svg_attributes(std::string_view tag); // of a start tag with its brackets

// A value of an attribute without the five entities of XML and numbered letters.
std::string unescaped(std::string_view raw);

// The properties of a style, "stroke: red; fill: none", in their order.
std::vector<std::pair<std::string_view, std::string_view>> style_properties(std::string_view style);

// The rules of <style> elements for single classes, as styles by the name of the class.
using SvgClasses = std::map<std::string, std::string, std::less<>>;
SvgClasses svg_classes(std::string_view text, const std::vector<SvgElement>& elements);

// How an element looks: a property of its style, else of the rules for its classes, else the
// attribute of that name. Empty where there is none.
std::string look_of(std::string_view tag, std::string_view property, const SvgClasses& classes);
std::string attribute_of(std::string_view tag, std::string_view name); // unescaped, or empty

} // namespace trivar
