// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "editor/hands/point_choice.h"

namespace trivar {

inline constexpr std::size_t most_shown_points = 20000; // at once; of more those round the mouse

inline bool all_are_shown(const Lattice& volume)
{
    return volume.displacement.points.size() <= most_shown_points;
}

// Calls visit(index, pixel) for each control point before the eye.
void each_point(const Lattice& volume, const Camera& camera, auto&& visit)
{
    const glm::ivec3 n = point_count(volume);
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k) {
                const PicturePoint p = project(camera, control_point(volume, i, j, k));
                if (p.depth_world > 0) visit(glm::ivec3(i, j, k), p.p_px);
            }
}

} // namespace trivar
