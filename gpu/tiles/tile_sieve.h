// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/mirrored_copies.h"
#include "gpu/program.h"
#include "gpu/tiles/device_pyramid.h"
#include "gpu/tiles/tile_rule.h"

namespace trivar::gpu {

// A TileSieve chooses on the graphics card which tiles of a layer are drawn, and how fine, by the
// same rule as the processor (tile_rule.h). It takes two dispatches: each tile finds its level;
// then the tiles of each level are listed in their order, and the commands that draw them are told
// how many they are. Nothing is read back. Needs OpenGL 4.3.
class TileSieve {
public:
    // A command draws a range of indices for each tile of a level.
    struct Command {
        std::uint32_t count = 0, tiles = 0, first = 0, vertex = 0, tile = 0; // for OpenGL
        std::uint32_t level = 0;
        std::array<std::uint32_t, 2> unused{};
        bool operator==(const Command&) const = default;
    };
    static_assert(sizeof(Command) == 32); // tiles.comp, MirroredCopies::draw()
    static std::vector<ProgramName> programs();
    static bool fits(std::size_t tiles); // whether shaders of this device see as many

    // Uploads the hulls of the tiles that differ from those that were there before, 32 bytes each.
    // Tiles keep the levels that they had by their numbers.
    void write(const TileSet& set, const glm::dvec3& origin);
    void forget_levels();
    void take(std::vector<Command> commands);
    // Chooses, for draws that come later; `before` may be null. The counts go to `totals`, from a
    // number on.
    void choose(Programs& programs, const TileRule& rule, const DevicePyramid* before,
                const Buffer& totals, std::size_t first_total);
    // The chosen tiles: those of a level begin at its number times the capacity.
    const std::shared_ptr<ChosenRows>& rows() const { return rows_; }

private:
    void make_room(std::size_t count);
    Runs<TileSet::Extent> extents_;
    glm::dvec3 origin_{0};
    std::vector<Command> commands_;
    Buffer hulls_, levels_, sums_, rule_;
    std::shared_ptr<ChosenRows> rows_ = std::make_shared<ChosenRows>();
};

} // namespace trivar::gpu
