// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/patches/placed_tile.h"
#include "gpu/buffer.h"
#include "gpu/texture.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trivar::gpu {

// TilePatches are the places of tiles on the GPU, as polynomials in a buffer texture that the
// vertex stage reads (tile.glsl), with their tints: 416 bytes per tile. Positions are relative to
// an origin near the tiles, which stays while they stay near it.
class TilePatches {
public:
    // Uploads the tiles that differ from those that were there before; `box_world` holds them all.
    // O(#runs), and about half a microsecond per tile that differs. Throws Rejected where the
    // device's textures are too small.
    void write(const Ref<PlacedTiles>& tiles, const Box& box_world);
    const Ref<PlacedTiles>& tiles() const { return tiles_; }
    const glm::dvec3& origin() const { return origin_; }
    std::uint64_t changes() const { return changes_; } // number of writes that changed something
    std::size_t bytes() const { return buffer_.bytes(); }
    void bind() const; // for draws with TILES

private:
    void write_range(std::size_t begin, std::size_t end) const;
    Ref<PlacedTiles> tiles_;
    glm::dvec3 origin_{0};
    std::uint64_t changes_ = 0;
    Buffer buffer_;
    Texels texels_;
};

} // namespace trivar::gpu
