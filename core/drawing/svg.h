// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"

#include <string>

namespace trivar {

// Writes a drawing as a text of SVG 1.1: a group per layer and in it one for what is hidden, one
// path per line, its points with one digit after the point. Lines of one width are strokes, others
// filled outlines; one whose colour changes is a path per piece of one colour. Ids are those of
// layer_ids() and line_id(), with _2, _3 and so on for what else is drawn for a line. A <desc>
// tells where every line is in space and how it was drawn, before a hand's edits: what HandEdits
// reads.
std::string svg_of(const DrawingSheet& drawing);

} // namespace trivar
