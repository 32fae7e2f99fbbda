// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/casting.h"

namespace trivar {

// A CastRay goes through a grid, in voxels, from `from` by t * along, t from 0 to `end`.
struct CastRay {
    glm::vec3 from{0}, along{0, 0, 1};
    float end = 0;
    float pace = 0.5f;   // of t in a step
    float jitter = 1;    // share of a step that the first one is, above 0
    float thickness = 1; // length in voxels per t, times the density
};

// CastLight is the light that a ray gathers from its beginning to its end.
struct CastLight {
    glm::vec3 color{0}; // linear light that is given off, not lit by others, times the opacity
    float opacity = 0;
    float hit = 0; // t up to which half of the light is held back; `end`: it never is
};

// Casts a ray on the processor, as the graphics card does it: one text has the formulas for both
// (core/kernel/casting.glsl). `order` as the picture has it: linear between the samples, or that of
// the field. 1 us per step.
CastLight cast_ray(const Casting& casting, const CastRay& ray, FieldOrder order);

// The value of the field as the formulas there have it, as a share of the range, and its slope per
// voxel.
struct CastValue {
    float value;
    glm::vec3 slope;
};
CastValue cast_value(const Casting& casting, const glm::vec3& p, FieldOrder order);

} // namespace trivar
