// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"
#include "core/silhouette/line_ids.h"

#include <map>
#include <string>
#include <string_view>

namespace trivar {

// HandEdits is what a person did to the lines of an .svg that svg_of() wrote: lines that were
// deleted or hidden, made thicker or thinner, or coloured. It can be done again to a later drawing
// of the same volume whose lines have the ids of the first one (see LineIds).
struct HandEdits {
    struct Edit {
        bool deleted = false;
        float widening = 1;                  // width by the hand per width as it was drawn
        std::optional<glm::vec3> color = {}; // sRGB, if the hand changed it
    };
    std::map<std::string, Edit> by_line; // by line_id(); lines that are as drawn are not in it
    std::map<std::string, std::vector<LineRecord>> lines; // of the .svg, by layer_id()
    std::size_t added = 0; // paths that are not of its list: they are not carried over

    // The ids of a new drawing's lines by the name of its layer, given by where lines were.
    LineIds ids_of(const std::string& layer_name) const;
};

// Reads the edits out of the text of an .svg, as an editor of drawings saved it. Lengths of strokes
// are read from the attribute stroke-width or from the style; transforms are not looked at. Throws
// Rejected for what is no .svg or has no list of lines.
HandEdits read_hand_edits(std::string_view svg);

// Does the edits to a drawing.
void apply(const HandEdits& edits, DrawingSheet& drawing);

} // namespace trivar
