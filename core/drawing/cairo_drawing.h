// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"

#include <string>

namespace trivar {

// A drawing as the bytes of a .pdf, one point per pixel, or of a .png, painted by cairo. The same
// bytes for the same drawing. Throws Rejected for a sheet that is too large.
std::string pdf_of(const DrawingSheet& drawing);
std::string png_of(const DrawingSheet& drawing);

} // namespace trivar
