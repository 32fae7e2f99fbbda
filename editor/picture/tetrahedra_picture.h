// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluated.h"
#include "gpu/picture.h"
#include "ui/palette.h"

namespace trivar {

// The edges of the tetrahedra of a volume where it takes them, those inside faintly, creases and
// cuts strongly. They are bent in up to 16 pieces each, 6,000 in
// all.
std::vector<gpu::Line> tetrahedra_lines(const TetrahedraEffects& volume, const ui::Palette& color,
                                        float line_px, bool selected);

// What moves with a pull: the edges of the cells that a function of a control point in the ball
// reaches, of one layer.
std::vector<gpu::Line> support_lines(const TetrahedraEffects& volume, const TetrahedraPull& pull,
                                     const ui::Palette& color, float line_px);

// The edges of a layer's cells before any deformation, in blue; those inside faint.
std::vector<gpu::Line> domain_lines(const TetrahedraEffects& volume, std::size_t layer,
                                    const ui::Palette& color, float line_px);

// The edges of some cells of a domain.
std::vector<gpu::Line> cell_lines(const SimplexDomain<3>& domain, std::span<const int> cells,
                                  const glm::dmat4& to_world, ui::Color color, float width_px);

} // namespace trivar
