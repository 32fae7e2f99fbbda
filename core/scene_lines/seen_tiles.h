// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/patches/tile_set.h"

namespace trivar {

// A SeenTiles is the tiles of a set by which lines are drawn, as one mesh.
struct SeenTiles {
    Ref<Mesh> mesh;
    double tile_size = 0;  // metres, of the mean tile: the diagonal of its box
    std::size_t drawn = 0; // number of tiles in the mesh
    std::size_t all = 0;   // and in the set
    bool operator==(const SeenTiles&) const = default;
};

// All tiles of a set where they have at most `most_triangles`. Else those that the camera sees as
// large as some pixels, each with as few triangles as it takes; where that is not enough, every
// second or third of them and so on, so that they stay evenly spread. `to_world` maps the space of
// the tiles. 2 us per tile and 0.2 us per triangle; the same for any number of threads.
SeenTiles seen_tiles(const TileSet& set, const glm::dmat4& to_world, const Camera& camera,
                     std::size_t most_triangles = 2'000'000);

} // namespace trivar
