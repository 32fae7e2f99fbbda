// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"
#include "core/drawing/edited_lines.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace trivar {

inline constexpr std::uintmax_t most_edited_bytes = 256 << 20; // of an .svg that is read

// Reads the edits out of the text of an .svg, as an editor of drawings saved it. Widths and colours
// are read from styles, classes and attributes; transforms are not looked at. A
// stroke that a hand gave to an outline makes it wider by as much in the middle of the line, and
// the colour of an outline is that of its fill. Of a line in several paths the first one counts.
// Nothing where no line of it was drawn here. Throws Rejected as svg_elements() does.
std::optional<HandEdits> hand_edits_of(std::string_view svg);
// The same. Throws Rejected, too, where no line of it was drawn here.
HandEdits read_hand_edits(std::string_view svg);

// An EditedLineIds gives the lines of new drawings the ids that they have in an .svg.
class EditedLineIds {
public:
    explicit EditedLineIds(const HandEdits& edits) : edits_(&edits) {}
    LineIds& operator()(const std::string& layer_name);

private:
    const HandEdits* edits_;
    std::map<std::string, LineIds> known_; // by name
};

// AppliedEdits counts the edits that were applied to a drawing.
struct AppliedEdits {
    std::size_t done = 0; // number of edits of lines that are in the drawing
    std::size_t lost = 0; // and of lines that are not
    std::size_t added = 0;
    std::set<std::string> other_layers = {}; // of edits, that the drawing has not
};
std::string words_of(const AppliedEdits& edits); // "2 edits by hand were done again", and so on

// Does the edits to a drawing. Its list is that of the lines before, so that an .svg of it differs
// from its list by all edits, and they can be read from it again; and an .svg of it has what else
// is in the one that the edits are of.
AppliedEdits apply(const HandEdits& edits, DrawingSheet& drawing);

} // namespace trivar
