// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/line_drawing.h"
#include "editor/panels/inspector/value_rows.h"

namespace trivar {

// Rows for how lines are drawn; `rest` is the style whose values a reset gives back, `parameter`
// what the names of their keys begin with.
void draw_ink_rows(ValueRows& rows, LineStyle& ink, const LineStyle& rest,
                   const std::string& parameter);

// Rows for further lines of a surface.
void draw_more_line_rows(ValueRows& rows, MoreLines& more, const std::string& parameter);

} // namespace trivar
