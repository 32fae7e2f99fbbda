// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"

namespace trivar {

// Returns the object's line drawing; for fitted volume data without one, the ink of the first level
// with lines, which all levels share. No value: its meshes are not drawn in lines.
std::optional<LineDrawing> drawn_lines(const Object& object);

} // namespace trivar
