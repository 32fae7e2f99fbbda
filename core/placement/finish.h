// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/layout.h"

namespace trivar {

// From nodes, displaced by s along their springs, to the placement: contact surface, lift, volume,
// embedding, report. What place() does with the nodes at rest and an animation with moving ones.
Placement finished(const Layout& layout, const std::vector<double>& s, const Camera& camera,
                   const PlacementParameters& parameters, const ModelFrame& frame,
                   const RayScene& scene, Timings& timings);

} // namespace trivar
