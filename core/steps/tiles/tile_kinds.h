// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/mesh/height_sheet.h"
#include "core/patches/tile_set.h"
#include "core/stages/step.h"
#include "core/steps/moving/posing.h"
#include "core/tiles/layout.h"

namespace trivar {

// A TileKind is an object whose copies are tiles of a layer, in one phase of its clip and morph,
// and with one of the morphs that a brush has painted.
struct TileKind {
    Id object = 0;
    std::vector<Part> parts;                        // in the object's own space; posed if they move
    glm::dmat4 turned{1};                           // its own rotation and scale
    Ref<std::vector<Material>> materials = nullptr; // null: the layer's own
    std::uint32_t first_material = 0;               // of its materials among those of the layer
    int first_mesh = 0;                             // of its meshes among those of the layer
    bool from_zero = false; // it stands in z = 0, as heights do, and not on its lowest point
    struct OverUvs {        // heights by a picture over the UVs of what is covered
        Ref<GreyImage> image;
        HeightSheet sheet;
        double highest = 0; // metres
        bool operator==(const OverUvs&) const = default;
    };
    std::optional<OverUvs> over_uvs = {};
    bool mirrored = false; // along y, and so is what `turned` does
    bool operator==(const TileKind&) const = default;
};

// A KindChoice chooses the kind of each tile of a layer among TileKinds::all.
struct KindChoice {
    struct Mixed { // one of the objects
        std::size_t first = 0, phases = 1;
        std::size_t morphs = 1; // number of painted morphs in each phase
        bool masked = false;    // a mask chooses the phase, from not yet morphed to altogether
        bool operator==(const Mixed&) const = default;
    };
    std::vector<Mixed> objects;
    std::vector<double> weights; // #objects
    std::vector<double> morphs;  // those that were painted, ascending; 0 is among them
    std::size_t images = 0;      // number of the first mirror image; 0: there are none
    bool operator==(const KindChoice&) const = default;

    // The kind of a tile: its seed chooses the object and the phase; where a mask says how far it
    // has morphed, that chooses the phase.
    std::size_t of(std::uint32_t seed, double masked_morph = 1, double painted_morph = 0,
                   bool mirrored = false) const;
};

// TileKinds are all kinds of a layer: those of each object behind one another, and where tiles are
// mirrored the mirror image of each, in the same order.
struct TileKinds {
    std::vector<TileKind> all;
    KindChoice choice;
    std::string trouble; // why tiles do not become what they should; empty: they do
    bool operator==(const TileKinds&) const = default;

    // Returns the object that the parts of a layer copy, by the number of their mesh.
    std::vector<Id> objects_of_meshes() const;
};

// The morphs that brushes have given to the tiles of a layout and of its strands, in few steps,
// ascending; 0 is among them. `phases` is the number of phases that each is multiplied with.
std::vector<double> painted_morphs(const TileLayout& layout, int phases);

// A UnitTile is a part of a kind on its way into the unit cell of a tile.
struct UnitTile {
    Ref<Mesh> mesh;
    glm::dmat4 to_unit;
    std::uint32_t first_material;
    bool moves; // and has no levels then
    bool operator==(const UnitTile&) const = default;
};
UnitTile unit_tile(const TileKind& kind, const Part& part, const glm::dmat4& to_unit);

// Bounds an object's parts at rest, turned. O(#V).
Box box_at_rest(const std::vector<Part>& parts, const glm::dmat4& turned);
// Gives the height over the floor of that box up to which the parts reach: its own, or more where
// their pose lifts them. Metres; O(#V) of posed parts.
double reach_over(const Box& at_rest, const std::vector<Part>& parts, const glm::dmat4& turned);
// Gives the look as it is for a kind: where that is mirrored, the other way along y.
TileLook look_of(const TileKind& kind, const TileLook& look);
// Gives the part of a box that fills the place of a tile, from the level that lies on the surface
// up. The box itself where the look asks for no other.
Box unit_cell_in(const Box& box, const TileLook& look);
// Gives the box of an object's parts that becomes a tile.
TileCell tile_cell(const std::vector<Part>& parts, const glm::dmat4& turned, const TileLook& look);
TileCell tile_cell(const TileKind& kind, const TileLook& look);

// Gives the materials of the objects that are mixed in, behind one another; null: there are none.
Ref<std::vector<Material>> materials_of_others(const TileKinds& kinds);

// A TileKindsOf finds the kinds of a layer at a frame and makes their tiles; it keeps the last few.
class TileKindsOf {
public:
    // `mirrored`: some of its tiles are.
    TileKinds operator()(const Stage& layer, const StepInput& input,
                         const std::vector<double>& morphs, bool mirrored);
    // Makes the tile of one of the kind's parts in a cell. Tiles that move have no levels.
    Ref<TileModel> model(const TileKind& kind, const Part& part, const TileCell& cell);

private:
    struct Morph { // what a layer's own tiles become, part by part; none: `into` is empty
        std::vector<Part> into;
        glm::dmat4 turned{1};
    };
    static Morph morph_of_layer(const Stage& layer, const StepInput& input, std::string& trouble);
    // The kinds of one object, for each phase of its clip and morph one for each painted morph.
    std::vector<TileKind> phases_of(Id id, const Stage& stage, const Morph& morph,
                                    const std::vector<double>& painted, const StepInput& input);
    // Poses parts as far on their way to what they become as the share says.
    void move_on(TileKind& kind, const Morph& morph, double share, const TileLook& look);

    struct MorphInput {
        Ref<Mesh> rest, from, into;
        glm::dmat4 way; // from what they become
        double share;
        bool operator==(const MorphInput&) const = default;
    };
    struct ModelInput {
        Ref<Mesh> mesh;
        glm::dmat4 to_model;
        TileCell cell;
        std::uint32_t first_material;
        bool moves;
        bool operator==(const ModelInput&) const = default;
    };
    std::map<Id, Posing> posings_;
    Kept<MorphInput, Ref<PosedMesh>> morphs_;
    Kept<ModelInput, Ref<TileModel>> models_{64};
};

} // namespace trivar
