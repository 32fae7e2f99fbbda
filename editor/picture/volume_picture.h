// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"
#include "editor/picture/tetrahedra_picture.h"
#include "gpu/picture.h"
#include "ui/palette.h"

namespace trivar {

// The lines that show the volume of a placed object: its edges and ribs with the stroke; and its
// faces. `line_px` is the width of a line that is one pixel wide at scale 1.
std::vector<gpu::Line> placement_lines(const Placement& placement, const ui::Palette& color,
                                       float line_px);
gpu::Translucent placement_veil(const Placement& placement, const ui::Palette& color);

// A ShellLook says how strong the lines between control points are: along the twelve edges of the
// volume, and elsewhere on its six sides; 0 leaves them out. Lines inside are never drawn.
struct ShellLook {
    float edges = 0.9f, sides = 0.26f;
};
std::vector<gpu::Line> shell_lines(const Lattice& volume, ui::Color color, float line_px,
                                   const ShellLook& look = {});
// The fill of a lattice: just enough to tell its inside from its outside.
gpu::Translucent shell_veil(const Lattice& volume, const ui::Palette& color);

// A ball with a rim, for tools.
gpu::Translucent ball_veil(const glm::dvec3& center, double radius, const ui::Palette& color);
// The balls of a press, mirrored too, where its last sample has come to lie in a volume.
std::vector<gpu::Translucent> balls_of(const Press& press, const Lattice& volume,
                                       const ui::Palette& color);

// Adds all volumes, equal ones once, and for each the ball of its last step if that was a press.
void add_volumes(gpu::Picture& picture, const Evaluation& evaluated, const Document& document,
                 TetrahedraLines& tetrahedra, const ui::Palette& color, float line_px);

} // namespace trivar
