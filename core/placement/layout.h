// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/strip_layout.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// How a strip treats rays that pass an edge and hit a surface far behind it: it goes down there, or
// spans the gap on the surface that it lies on.
enum class Jumps { followed, bridged };

// Lays the strip on the scene; see place() for the arguments. `frame`: how the model is turned.
// Throws Rejected for a stroke that meets too little of the scene or nothing, and for sizes that do
// not fit. With bridged jumps also for one that leaves its surface and does not come back to it.
StripLayout lay_out(const Sketch& sketch, const PlacementParameters& parameters,
                    const ModelFrame& frame, const RayScene& scene, Timings& timings,
                    Jumps jumps = Jumps::followed);

} // namespace trivar
