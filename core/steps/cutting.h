// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/cap_notices.h"
#include "core/stages/step.h"

namespace trivar {

// CuttingStep cuts what an object shows into pieces, as it stands at the frame: what was drawn over
// a bent, posed or tiled model is what is cut. Every piece is a part by itself, so that a gap that
// opens only moves parts. A layer of tiles is cut with what it is painted on, and then by cuts of
// its own: tiles that no cut goes through move with their piece or go with it, the others are cut,
// too. A second such step, after splits, makes the cuts that were drawn over what is parted. Stage:
// cut.
class CuttingStep : public Step {
public:
    explicit CuttingStep(bool of_parted) : of_parted_(of_parted) {}
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

    // A piece of a part; without a mesh and tiles it is all of the part.
    struct Piece {
        Ref<Mesh> mesh = nullptr;
        Ref<TileSet> tiles = nullptr; // whole ones
        Ref<Mesh> rest = nullptr;     // see Part::before_split
        unsigned sides = 0;           // bit i: above cut i
        Box bounds = {};
    };
    struct Pieces {
        std::vector<std::vector<Piece>> of_parts;
        CapCounts caps;
        double off = 0;                         // metres
        unsigned goes_through = 0, touches = 0; // something; bit i: cut i
    };
    // A Whole is the part that pieces are cut from; gaps are 0 in `cutting`.
    struct Whole {
        Ref<Mesh> mesh;       // null: tiles
        Ref<TileSet> tiles;   // null: a mesh
        bool alone = false;   // see tile_pieces()
        Ref<Mesh> rest;       // of what a pattern fills, where that is not the mesh
        unsigned above = 0;   // bit i: of cut i, which an earlier step made
        glm::dmat4 to_own{1}; // the space of the cuts, as it was before the gaps of those
        bool operator==(const Whole&) const = default;
    };
    struct PiecesKey {
        std::vector<Whole> parts;
        Cutting cutting;
        unsigned made = 0;                         // the cuts that are made; bit i: cut i
        unsigned earlier = 0;                      // those that an earlier step made
        double metres = 1;                         // of a unit of the object's own space
        std::optional<std::uint32_t> material = 0; // of caps; none: that of a part's first face
        bool operator==(const PiecesKey&) const = default;
    };
    struct StageKey {
        Ref<Stage> before;
        Cutting cutting;
        glm::dmat4 own_to_world{1};
        bool filled = false;
        bool operator==(const StageKey&) const = default;
    };
    struct Known { // what the cuts of one object made
        Recent<PiecesKey, Ref<Pieces>> pieces;
        Recent<StageKey, Ref<Stage>> stages;
    };

private:
    bool of_parted_;
    std::vector<Known> known_; // of the bases of a layer of tiles, and of its own
};

} // namespace trivar
