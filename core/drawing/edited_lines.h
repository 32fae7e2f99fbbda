// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/line_ids.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// HandEdits is what a person did to the lines of an .svg that svg_of() wrote: lines that were
// deleted or hidden, made thicker or thinner, or coloured. It can be done again to a later drawing
// of the same volume whose lines have the ids of the first one (see LineIds).
struct HandEdits {
    struct Edit {
        bool deleted = false;
        float widening = 1;                  // width by the hand per width as it was drawn
        std::optional<glm::vec3> color = {}; // sRGB, if the hand changed it
        std::string layer = {};              // layer_id()
        std::string listed = {};             // its line of the list; see line_list()
    };
    std::map<std::string, Edit> by_line; // by line_id(); lines that are as drawn are not in it
    std::map<std::string, std::vector<LineRecord>> lines; // of the .svg, by layer_id()
    std::string svg = {};                                 // its text
    std::size_t added = 0; // a person's own elements in it, that stay there
};

} // namespace trivar
