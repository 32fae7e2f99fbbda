// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_patches.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

constexpr unsigned patches_unit = 14; // tile.glsl; no draw reads a volume, too
constexpr std::size_t texels_per_tile = 26;

using TileTexels = std::array<glm::vec4, texels_per_tile>;

TileTexels texels_of(const PlacedTile& tile, const glm::dvec3& origin)
{
    const TilePowers powers = powers_of(tile);
    TileTexels out;
    out[0] = glm::vec4(glm::vec3(powers.origin - origin), powers.scale);
    for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t j = 0; j < 4; ++j) {
            const float* c = powers.c[k].data() + 4 * j;
            out[1 + 4 * k + j] = {c[0], c[1], c[2], c[3]};
        }
    out[25] = glm::vec4(tile.tint, tile.tint_over);
    return out;
}

std::size_t most_texels()
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return static_cast<std::size_t>(std::max(most, 0));
}

} // namespace

void TilePatches::write(const Ref<PlacedTiles>& tiles, const Box& box_world)
{
    if (tiles == tiles_) return;
    const std::size_t count = tiles->size();
    if (count * texels_per_tile > most_texels())
        throw Rejected("There are more tiles than fit into a texture of this graphics card.");
    const Ref<PlacedTiles> before = std::exchange(tiles_, nullptr);
    bool all = !before;
    // A number of few digits, as for other meshes that are deformed.
    if (const glm::dvec3 middle(glm::vec3(box_world.center()));
        all || glm::distance(middle, origin_) > glm::length(box_world.size())) {
        origin_ = middle;
        all = true;
    }
    const std::size_t bytes = count * sizeof(TileTexels);
    if (bytes > buffer_.bytes() || 4 * bytes < buffer_.bytes()) {
        buffer_.reserve(std::min(count + count / 2, most_texels() / texels_per_tile) *
                        sizeof(TileTexels)); // room for the next dabs of a brush
        all = true;
    }
    tiles_ = tiles;
    ++changes_;
    if (all) return write_range(0, count);
    const auto differs = [&](std::size_t i) {
        return i >= before->size() || (*before)[i] != (*tiles)[i];
    };
    for (std::size_t r = 0; r < tiles->runs().size(); ++r) {
        const std::size_t begin = tiles->begin_of(r), past = tiles->begin_of(r + 1);
        if (begin < before->size()) {
            const std::size_t there = before->run_of(begin);
            if (before->begin_of(there) == begin && before->runs()[there] == tiles->runs()[r])
                continue;
        }
        for (std::size_t i = begin; i < past;) {
            std::size_t end = i;
            while (end < past && differs(end)) ++end;
            if (end > i) write_range(i, end);
            i = end + 1;
        }
    }
}

void TilePatches::write_range(std::size_t begin, std::size_t end) const
{
    std::vector<TileTexels> texels(end - begin);
    parallel_blocks(texels.size(), 256, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            texels[i] = texels_of((*tiles_)[begin + i], origin_);
    });
    buffer_.write_part(begin * sizeof(TileTexels), std::as_bytes(std::span(texels)));
}

void TilePatches::bind() const
{
    texels_.bind(patches_unit, buffer_);
}

} // namespace trivar::gpu
