// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"

#include <string>
#include <string_view>

namespace trivar {

// The kinds of files that a drawing can be written to.
enum class DrawingFormat { svg, pdf, png, obj };

// Whether a file is one of lines on a sheet, by the end of its name: .svg or .pdf.
bool is_line_sheet(std::string_view path);

// The format of a file by the end of its name. Throws Rejected where there is none.
DrawingFormat drawing_format(std::string_view path);

// The bytes of a file with a drawing: .svg (see svg.h), .pdf and .png by cairo (the same lines; a
// .pdf has the sheet's size in points), .obj with the lines in space, one object per layer, metres.
// Throws Rejected where cairo cannot make a picture of that size.
std::string drawing_bytes(const DrawingSheet& drawing, DrawingFormat format);

} // namespace trivar
