// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"

namespace trivar {

// How the meshes of an object are drawn in lines: as it is told; else, of volume data that are
// fitted by tetrahedra, as the first of their levels with lines, whose ink all have. No value: they
// are not.
std::optional<LineDrawing> drawn_lines(const Object& object);

} // namespace trivar
