// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/camera.h"
#include "core/patches/tile_set.h"

#include <array>
#include <optional>

namespace trivar::gpu {

// A TileView is what decides how a tile is drawn: a camera, in the space of the tiles.
class TileView {
public:
    TileView(const Camera& camera, const glm::dmat4& to_world, bool steady);
    bool operator==(const TileView&) const = default;

    // Whether a box may be in the picture: it is not wholly beyond one of its sides.
    bool sees(const Box& box) const;
    // The length in the space of the tiles that is half a pixel at the nearest point of a box;
    // 0 where the box reaches behind the camera.
    double tolerance(const Box& box) const;
    // Of a draft: levels are chosen, and a tile keeps the one that it had, unless another is
    // clearly better.
    bool steady() const { return steady_; }

private:
    std::array<glm::dvec4, 5> planes_; // inside: 0 or more
    glm::dvec4 depth_;                 // times a point: its distance along the view
    double pixel_ = 0;                 // half a pixel, by distance or for all distances
    bool perspective_ = true, steady_ = false;
};

// The coarsest level whose error, stretched, is at most the tolerance. With `last`, the level that
// the tile had, another one is chosen only where it is better by a third.
std::size_t level_for(const std::vector<TileLevel>& levels, double stretch, double tolerance,
                      std::optional<std::size_t> last = std::nullopt);

} // namespace trivar::gpu
