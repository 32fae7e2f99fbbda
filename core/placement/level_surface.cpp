// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/level_surface.h"

#include "core/spline/tensor.h"

namespace trivar {

Surface<glm::dvec3> level_surface(const Lattice& volume, double level)
{
    const Trivariate<glm::dvec3>& f = volume.displacement;
    const AxisMap at_level = sampling_map(f.axes[2], std::span(&level, 1));
    Surface<glm::dvec3> surface{{f.axes[0], f.axes[1]},
                                applied(at_level, extent(f.axes[2]),
                                        std::span<const glm::dvec3>(f.points),
                                        points_inside(axes_of(f), 2))};
    for (int i = 0; i < surface.axes[0].count(); ++i)
        for (int j = 0; j < surface.axes[1].count(); ++j) {
            const glm::dvec3 uvw(surface.axes[0].greville(i), surface.axes[1].greville(j), level);
            surface.points[surface.index(i, j)] += glm::dvec3(volume.rest * glm::dvec4(uvw, 1));
        }
    return surface;
}

} // namespace trivar
