// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/drawn_lines.h"

#include <algorithm>

namespace trivar {
namespace {

// Faces of tetrahedra along a round boundary differ by less.
constexpr float crease_deg = 60;

} // namespace

std::optional<LineDrawing> drawn_lines(const Object& object)
{
    if (object.line_drawing) return object.line_drawing;
    const auto* volume = std::get_if<VoxelShape>(&object.source);
    if (!volume || volume->fit.coefficients == 0) return std::nullopt;
    const auto lined = std::ranges::find_if(
        volume->levels, [](const VoxelLevel& l) { return l.lines && !l.hidden; });
    if (lined == volume->levels.end()) return std::nullopt;
    LineDrawing out{.crease_deg = crease_deg, .ink = lined->ink, .more = lined->more};
    out.surface = std::ranges::any_of(volume->levels,
                                      [](const VoxelLevel& l) { return l.surface && !l.hidden; });
    return out;
}

} // namespace trivar
