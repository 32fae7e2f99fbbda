// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/geodesic.h"

namespace trivar {

FootPoint foot_point(const LimitSurface& surface, const ChartPlace& near, const glm::dvec3& p,
                     double tolerance)
{
    constexpr int most_evaluations = 12;
    FootPoint f{near, surface.jet(near)};
    double last = 1e300;
    for (int i = 0; i < most_evaluations; ++i) {
        const glm::dvec2 step = in_chart(f.jet, p - f.jet.p);
        const double miss = glm::length(step.x * f.jet.u + step.y * f.jet.v);
        if (!(miss > tolerance) || miss >= last) break;
        last = miss;
        const ChartNet::Walk walk = surface.net().walk(f.at, step, false);
        f.at = walk.at;
        f.edge = walk.edge;
        if (walk.edge >= 0) {
            const glm::dvec2 along = along_edge(walk.edge);
            f.at =
                surface.net().walk(f.at, walk.left * glm::dot(walk.step, along) * along, false).at;
        }
        f.jet = surface.jet(f.at);
    }
    return f;
}

} // namespace trivar
