// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/casting.h"

#include <cstdint>

namespace trivar {

// A CastView says how volume data are looked at, by the names of core/kernel/cast_pixel.glsl. Scene
// space is that of the picture: its unit is the world's.
struct CastView {
    // The ray through the place (u, v) of the picture, 0..1 from the bottom left, is x[0] + u x[1]
    // + v x[2]. x begins at 0 for its foot in voxels; at 3 for the way in voxels per unit of
    // distance along the view direction; at 6 for the same in scene space. w of the first is 1 for
    // perspective.
    std::array<glm::vec4, 9> rays{};
    // Corners of the box that is seen, in voxels; w of the first: by which share of a step the
    // first step of a ray may differ from that of others.
    glm::vec4 low{0, 0, 0, 1}, high{0};
    // Lengths of a voxel in a unit of scene space, times the density; shading, 0..1; voxels in a
    // step; the number of the sample.
    glm::vec4 look{1, 0, 0.5f, 0};
    glm::mat3 to_normals{
        1}; // slopes per voxel to slopes along the scene's axes per length of a voxel
    // Irradiance around in nine harmonics; the direction to the key light with the tangent of its
    // half angle; its irradiance.
    std::array<glm::vec4, 11> lights{};
};

// A CastSolid is the solid surface in front of the volume at a pixel: its id, whose highest bit
// marks a curve, and its distance along the view direction; 0: nothing.
struct CastSolid {
    std::uint32_t id = 0;
    float distance = 0;
};

// A rectangle of pixels of a picture, row by row from the bottom.
struct CastPixels {
    std::vector<glm::vec4> gathered; // linear light times opacity, opacity
    std::vector<float> hits;         // distance up to which half of it is held back; 0: nowhere
};

// Casts the rays of a rectangle of a picture of `size_px` on the processor, as the graphics card
// does, but with the field's own sums. `linear`: between the samples, for drafts, where the values
// are the samples. 1 to 4 us per ray that meets something; the same for any number of threads.
CastPixels cast_image(const Casting& casting, const CastView& view, glm::ivec2 size_px,
                      glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const CastSolid> solids,
                      bool linear);

} // namespace trivar
