// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

// Names and values, as they are written between quotation marks.
using SvgAttributes = std::vector<std::pair<std::string, std::string>>;

// The paths of a layer that are hidden or seen, in a group of their own.
struct SvgGroup {
    std::string id;
    bool is_needed = false;                // or the layer has no such lines
    std::vector<SvgAttributes> paths = {}; // ids first
};
struct SvgLayer {
    std::string id;
    SvgAttributes attributes;       // of its group
    std::array<SvgGroup, 2> groups; // hidden, seen
};

// SvgParts are what a drawing gives to an .svg.
struct SvgParts {
    SvgAttributes size;               // of the root: width, height, viewBox
    std::string list;                 // line_list()
    std::optional<std::string> paper; // hex_color()
    std::vector<SvgLayer> layers;
};
SvgParts svg_parts(const DrawingSheet& drawing);

std::string svg_escaped(std::string_view text); // for a value

// The texts of parts. `prefix` is that of the namespace of SVG: "svg:", or mostly empty.
std::string text_of(const SvgAttributes& attributes); // a space before each
std::string paper_text(const std::string& color, const std::string& prefix = {});
std::string path_text(const SvgAttributes& path, const std::string& prefix);
std::string text_of(const SvgGroup& group, const std::string& prefix);
std::string text_of(const SvgLayer& layer, const std::string& prefix = {});

} // namespace trivar
