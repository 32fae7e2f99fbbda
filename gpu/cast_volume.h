// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/casting.h"

namespace trivar::gpu {

// A CastVolume is volume data seen by rays that are cast through a box of it. It is part of the
// scene: it stops at surfaces and curves, hides things behind it as far as it is dense, and can be
// picked where it hides more than half. It casts no shadow. Drafts cast fewer rays, by samples that
// are linear in between; pictures at rest show the field's own spline.
struct CastVolume {
    Ref<Casting> data = {};    // uploaded once; null: nothing is drawn
    glm::dmat4 to_world{1};    // of voxels
    glm::vec3 low{0}, high{0}; // the box, in voxels
    float density = 1;         // what the thickness of a voxel is multiplied by
    float shading = 0.8f;      // 0: colours as they are, 1: lit where values change
    int id = 0;                // what pick() returns; 0: not pickable
};

} // namespace trivar::gpu
