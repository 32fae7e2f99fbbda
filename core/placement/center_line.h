// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/ray_grid.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// The middle line of the strip as rays see it, at `count` points; the membrane fills misses.
RayGrid center_line(const Curve<glm::dvec2>& center, int count, const Camera& camera,
                    const RayScene& scene, bool skip_back_faces);

} // namespace trivar
