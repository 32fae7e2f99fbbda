// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "gpu/picture.h"
#include "ui/palette.h"

namespace trivar {

// What shows the volume of a placed object: its edges and ribs with the stroke, and its faces.
// `line_px`: of a line that is one pixel wide at scale 1.
std::vector<gpu::Line> placement_lines(const Placement& placement, const ui::Palette& color,
                                       float line_px);
gpu::Translucent placement_veil(const Placement& placement, const ui::Palette& color);

// How strong the lines between control points are: along the twelve edges of the volume, and the
// others on its six sides; 0 leaves them out. Lines within are never drawn.
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

// Adds all volumes, those that are the same once, and the ball of each one's last step where that
// was a press.
void add_volumes(gpu::Picture& picture, const Evaluation& evaluated, const Document& document,
                 const ui::Palette& color, float line_px);

} // namespace trivar
