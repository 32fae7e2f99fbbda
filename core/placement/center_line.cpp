// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/center_line.h"

#include "core/base/rejected.h"
#include "core/placement/strip.h"

namespace trivar {

RayGrid center_line(const Curve<glm::dvec2>& center, int count, const Camera& camera,
                    const RayScene& scene, bool skip_back_faces)
{
    std::vector<double> a, v(static_cast<std::size_t>(count), 0.5);
    for (int i = 0; i < count; ++i) a.push_back(static_cast<double>(i) / (count - 1));
    RayGrid line = shoot(strip_round(center, {0, 0}), std::move(a), std::move(v), camera, scene,
                         skip_back_faces);
    if (line.missed_share() == 1)
        throw Rejected("the stroke meets nothing; draw it over an object");
    return filled(std::move(line), Misses::membrane);
}

} // namespace trivar
