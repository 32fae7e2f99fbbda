// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/grey_image.h"
#include "core/tiles/line_distance.h"
#include "core/tiles/tile_mask.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trivar {

// A MaskPlace is a place on a base at rest, in the space of its model.
struct MaskPlace {
    glm::dvec3 p{0}, normal{0, 0, 1};
    std::optional<glm::dvec2> uv = {}; // none: the base has no texture coordinates there
};

// MaskFactors are the products of the factors of all masks of a layer at one tile.
struct MaskFactors {
    double density = 1, scale = 1, height = 1, morph = 1;
    bool operator==(const MaskFactors&) const = default;
};

// A ReadyMask is a mask with its image or curve. A mask that lacks them does nothing.
struct ReadyMask {
    TileMask mask;
    Ref<GreyImage> image = nullptr;    // null: it has none
    Ref<LineDistance> curve = nullptr; // the same, in the space of the base's model
    bool operator==(const ReadyMask&) const = default;
};

// TileMasks are the masks of a layer.
struct TileMasks {
    std::vector<ReadyMask> all;
    Box box; // of the base at rest, over which images are stretched
    bool operator==(const TileMasks& o) const
    {
        return all == o.all && box.lo == o.box.lo && box.hi == o.box.hi;
    }

    bool drive(MaskDrives what) const; // whether one of them does
    bool read_uvs() const;
    // Returns the factors at a place. Pure and thread-safe. O(#masks), and the cost of a
    // LineDistance.
    MaskFactors at(const MaskPlace& place) const;
};

// The value of a mask at a place: from 0 to 1, before its range; nothing where it does nothing.
std::optional<double> mask_value(const ReadyMask& mask, const Box& box, const MaskPlace& place);

// Whether a tile is there at a density: it is where its own share, which follows from its seed
// alone, is below it. So tiles come and go with a mask one by one, and those that stay do not move.
bool is_there(std::uint32_t seed, double density);

} // namespace trivar
