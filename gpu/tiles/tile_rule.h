// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/patches/tile_set.h"
#include "gpu/tiles/depth_pyramid.h"

namespace trivar::gpu {

// A TileRule is what decides whether a tile is drawn, and by which level: a camera in the space of
// the patches, the levels, and what may hide tiles. std140, field by field as in tiles.comp.
struct TileRule {
    static constexpr int most_levels = 8; // levels_of()
    glm::vec4 sides[5];                   // of the picture: inside 0 or more
    glm::vec4 depth{0};                   // times a point: its distance along the view
    glm::vec4 errors[2]{};                // of the levels, in sides
    glm::mat4 to_clip{1};                 // for what may hide tiles
    float tolerance = 0;                  // how far a tile may be off; in perspective, by distance
    int perspective = 1;
    int steady = 0; // 1: levels are chosen, and kept unless others are clearly better; 0: the first
    int level_count = 1;
    glm::ivec2 pyramid_px{0}; // of what may hide tiles; 0: nothing
    glm::ivec2 unused{0};
    bool operator==(const TileRule&) const = default;
};

static_assert(sizeof(TileRule) == 16 * (5 + 1 + 2 + 4 + 1 + 1));

// The rule of a picture, without what hides. `origin` is that of the patches, and `to_world` takes
// the space of the tiles to the world; `draft`: levels are chosen. At most `most_levels` levels.
TileRule rule_of(const Camera& camera, const glm::dmat4& to_world, const glm::dvec3& origin,
                 bool draft, const std::vector<TileLevel>& levels);
// Adds the occluders to a rule: a pyramid of that size. `world_to_clip` is that of its picture.
TileRule with_pyramid(const TileRule& rule, glm::ivec2 size_px, const glm::dmat4& world_to_clip,
                      const glm::dmat4& to_world, const glm::dvec3& origin);

// A TileHull holds every point of a tile, relative to the origin of the patches. It is larger than
// the box in double precision by all that is rounded on the way to a decision.
struct TileHull {
    glm::vec3 lo{0};
    float stretch = 0;
    glm::vec3 hi{0};
    float unused = 0;
};
TileHull hull_of(const TileSet::Extent& extent, const glm::dvec3& origin);

namespace tile_kernel {
using namespace glm;

// A TileChooser is the rule as C++. The shader tiles.comp includes the same text.
struct TileChooser {
    const TileRule& rule;
    std::span<const float> depths = {}; // DepthPyramid::depths()

    float pyramid_depth(int at) const { return depths[static_cast<std::size_t>(at)]; }

#include "gpu/shaders/tile_rule.glsl"
};

} // namespace tile_kernel
using tile_kernel::TileChooser;

} // namespace trivar::gpu
