// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/animation/track.h"
#include "core/base/ref.h"
#include "core/document/face_shading.h"
#include "core/document/incising.h"
#include "core/document/source.h"
#include "core/lines/line_drawing.h"
#include "core/placement/attachment.h"
#include "core/placement/placement_input.h"
#include "core/placement/shaping.h"
#include "core/refinement/methods.h"
#include "core/split/cutting.h"
#include "core/split/splitting.h"
#include "core/tiles/tile_cover.h"
#include "core/tiles/tile_mask.h"
#include "core/tiles/tile_stroke.h"
#include "core/unwrap/methods.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

using Id = int; // of an object, from 1 up; never used twice in one document. 0: none

struct Transform {
    glm::dvec3 translation{0};
    glm::dvec3 rotation_deg{0}; // about X, then Y, then Z
    glm::dvec3 scale{1};
    glm::dmat4 matrix() const;
    bool operator==(const Transform&) const = default;
};

// A RoundWay is the way of a volume round a cylinder, a sphere, a torus or a Moebius band, or round
// any body where a plane cuts it.
struct RoundWay {
    double level = 0; // metres from its widest circle; with a plane: along the normal, from where
                      // it stands; both in the body's own space
    std::optional<glm::dvec3> normal = {}; // of the plane, in the body's own space
    bool operator==(const RoundWay&) const = default;
};

// A PlacementStep is a stroke laid over other objects. `onto` names the objects that its rays see:
// a dependency, so moving one of them places this object again. Cycles are refused.
struct PlacementStep {
    Sketch sketch;
    PlacementParameters parameters;
    std::vector<Id> onto;
    // the way round the only object of `onto`, in place of the stroke
    std::optional<RoundWay> round = {};
    // which of `onto` carry it; no value: the stroke stays in the world
    std::optional<Attachment> attach = {};
    bool operator==(const PlacementStep&) const = default;
};

// Playing says how an object moves by a clip of its model (core/mesh/clip.h), besides any other
// movement.
struct Playing {
    std::string clip = {}; // name of the clip; empty: the pose of the file
    double speed = 1;      // relative to the clip's own; negative: backwards
    Repeat repeat = Repeat::loop;
    double offset = 0;      // seconds into the clip at the start frame
    int start_frame = 1;    // from which on the clip plays
    bool foot_lock = false; // the travel, and not `speed`, decides how fast the clip plays
    bool operator==(const Playing&) const = default;
};

// Refining splits triangles until, deformed, they are within a tolerance of the true surface.
struct Refining {
    double tolerance = 1e-3; // metres
    SplitPoint split = SplitPoint::equidistributed;
    RefinementRule rule = RefinementRule::edge_driven;
    BoundMethod method = BoundMethod::composed_net;
    int budget = 1000000; // greatest number of triangles
    bool operator==(const Refining&) const = default;
};

// Simplifying reduces the triangles of a shape (core/simplify) before anything else is done with
// it.
struct Simplifying {
    double keep = 0.5; // share of its triangles, above 0 and at most 1
    // metres before placing and scaling; greatest movement of a triangle; 0: no limit
    double deviation = 0;
    bool operator==(const Simplifying&) const = default;
};

// Unwrapping gives a shape texture coordinates made here (core/unwrap), after it was simplified and
// before anything else is done with it.
struct Unwrapping {
    UnwrapMethod method = UnwrapMethod::conformal;
    double seam_angle_deg = 60, spread_deg = 60;
    double margin = 0.002; // as a share of the square
    bool operator==(const Unwrapping&) const = default;
};

// A MixedTile is another object whose copies stand among the tiles of a layer.
struct MixedTile {
    Id object = 0;
    double weight = 1; // how often it is there, beside the weights of the others
    bool operator==(const MixedTile&) const = default;
};

// Tiling makes an object a layer of tiles: copies of it, painted on another object or covering it.
// The layer's own rotation and scale turn each tile.
struct Tiling {
    Id base = 0; // what it is painted on or covers; 0: that is gone
    TileLook look;
    std::vector<Ref<TileStroke>> strokes; // in their order
    double weight = 1;                    // of the object itself in a mix of several
    std::vector<MixedTile> others = {};   // what it is mixed with
    Id into = 0;                          // what its own tiles become by the morph; 0: nothing
    TileCover cover = {};                 // besides the strokes
    std::vector<TileMask> masks = {};     // of strokes, strands and cover alike
    bool operator==(const Tiling&) const = default;
};

struct Object {
    std::string name;
    Source source;
    Transform transform;
    std::optional<Surfacing> surfacing;
    Id parent = 0;
    bool hidden = false;
    bool locked = false; // hands cannot take it by accident; a command that names it may
    // The stroke that it lies on; its translation waits as long as it lies, its rotation and scale
    // turn it first.
    std::optional<PlacementStep> stroke;
    // The steps that were done to its volume after it was laid, in their order.
    std::vector<Ref<VolumeEdit>> shaping = {};
    Travel travel = {};                    // along its stroke; only for an object on a stroke
    Playing playing = {};                  // only for an imported file
    std::optional<Refining> refining = {}; // only for an object on a stroke
    std::optional<Simplifying> simplifying = {};
    std::optional<Unwrapping> unwrapping = {};
    std::optional<FaceShading> shading = {}; // never `own`
    std::optional<Incising> incising = {};
    std::optional<Tiling> tiles = {}; // not for an object on a stroke
    std::optional<Cutting> cutting = {};
    std::optional<Splitting> splitting = {};
    std::optional<LineDrawing> line_drawing = {};
    Tracks tracks = {}; // of the numbers that change in time, by parameter
    bool operator==(const Object&) const = default;
};

} // namespace trivar
