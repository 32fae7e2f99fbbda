// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/step.h"
#include "core/patches/tile_set.h"

namespace trivar {

// A TileKind is one of the objects whose copies are the tiles of a layer.
struct TileKind {
    Ref<EvaluatedObject> other = nullptr; // null: the layer itself
    glm::dmat4 turned{1};                 // the object's own rotation and scale
    double weight = 1;
    std::uint32_t first_material = 0; // of its materials among those of the layer
    int first_mesh = 0;               // of its meshes among those of the layer
    bool operator==(const TileKind&) const = default;

    // Its parts in its own space, before lattices. `layer` is the stage of the layer itself.
    const std::vector<Part>& parts(const Stage& layer) const
    {
        return other ? other->own_parts.empty() ? other->parts : other->own_parts : layer.own_parts;
    }
};

// Lists the kinds of tiles of a layer, its own first; objects without meshes are left out.
std::vector<TileKind> tile_kinds(const Stage& layer, const StepInput& input);

// Gives the materials of all kinds but the first, one after the other; null: there are no others.
Ref<std::vector<Material>> materials_of_others(const std::vector<TileKind>& kinds);

// Gives the box of an object's parts that becomes a tile.
TileCell tile_cell(const std::vector<Part>& parts, const glm::dmat4& turned);

} // namespace trivar
