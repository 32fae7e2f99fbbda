// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/level_surface.h"

#include "core/spline/iso.h"

namespace trivar {

Surface<glm::dvec3> level_surface(const Lattice& volume, double level)
{
    const Trivariate<glm::dvec3>& f = volume.displacement;
    Surface<glm::dvec3> surface{
        {f.axes[0], f.axes[1]},
        contracted(axes_of(f), std::span<const glm::dvec3>(f.points), 2, level)};
    for (int i = 0; i < surface.axes[0].count(); ++i)
        for (int j = 0; j < surface.axes[1].count(); ++j) {
            const glm::dvec3 uvw(surface.axes[0].greville(i), surface.axes[1].greville(j), level);
            surface.points[surface.index(i, j)] += glm::dvec3(volume.rest * glm::dvec4(uvw, 1));
        }
    return surface;
}

} // namespace trivar
