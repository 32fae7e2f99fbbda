// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/buffer.h"
#include "gpu/tiles/tile_counts.h"

#include <array>
#include <optional>
#include <vector>

namespace trivar::gpu {

// LateCounts are the graphics card's counts of the tiles of pictures: read when it is done, and
// never waited for.
class LateCounts {
public:
    static constexpr std::size_t kinds = 9; // tiles.comp: the levels, and what is hidden
    struct Layer {
        std::size_t tiles = 0, all_vertices = 0;
        std::vector<std::size_t> vertices; // of a tile, by level
    };

    LateCounts() = default;
    LateCounts(const LateCounts&) = delete;
    LateCounts& operator=(const LateCounts&) = delete;
    ~LateCounts();

    // Returns the buffer for the card's counts of the next picture: so many kinds for each layer, 4
    // bytes each. The picture three before is forgotten.
    const Buffer& next(std::vector<Layer> layers);
    void asked(); // after the commands that write them
    // The counts of the last picture of which they are there and were not yet told.
    std::optional<TileCounts> told();

private:
    struct Picture {
        std::vector<Layer> layers;
        Buffer totals;
        void* fence = nullptr; // a GLsync; null: nothing was asked
    };
    static void forget(Picture& picture);
    static TileCounts counts_of(const Picture& picture);
    std::array<Picture, 3> pictures_;
    std::size_t last_ = 0; // the picture that was asked last
};

} // namespace trivar::gpu
