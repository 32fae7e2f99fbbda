// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/evaluated.h"
#include "gpu/picture.h"
#include "ui/palette.h"

#include <tuple>

namespace trivar {

template <int S> struct SimplexDomain;

// TetrahedraLines draws the edges of the tetrahedra of volumes where these take them: those of the
// border, and while the volume is selected those inside faintly, creases and cuts strongly. They
// are bent in up to 16 pieces each, 6,000 in all. It keeps the last few volumes, about 100 bytes
// per edge, so that a turn of the view only copies them; others cost 4 us per point.
class TetrahedraLines {
public:
    const std::vector<gpu::Line>& operator()(const TetrahedraEffects& volume,
                                             const ui::Palette& color, float line_px,
                                             bool selected);

private:
    using Colors = std::array<ui::Color, 3>; // those of the palette that are used
    using Key = std::tuple<Ref<ShapedTetrahedra>, glm::dmat4, Colors, float, bool>;
    Recent<Key, std::vector<gpu::Line>> known_{8};
};

// Returns the edges that move with a pull: those of the cells that a function of a control point in
// the ball reaches, of one layer.
std::vector<gpu::Line> support_lines(const TetrahedraEffects& volume, const TetrahedraPull& pull,
                                     const ui::Palette& color, float line_px);

// The edges of a layer's cells before any deformation, in blue; those inside faint.
std::vector<gpu::Line> domain_lines(const TetrahedraEffects& volume, std::size_t layer,
                                    const ui::Palette& color, float line_px);

// The edges of some cells of a domain.
std::vector<gpu::Line> cell_lines(const SimplexDomain<3>& domain, std::span<const int> cells,
                                  const glm::dmat4& to_world, ui::Color color, float width_px);

} // namespace trivar
