// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/document/object.h"
#include "core/stages/curve_part.h"
#include "core/stages/incising_effects.h"
#include "core/stages/shape.h"

#include <limits>
#include <string>
#include <vector>

namespace trivar {

// Results of steps, by name alone: a source that looks into one includes its header.
struct StrokeMotion;
class Journey;
struct Placement;
class RayScene;
struct RefinementResult;
struct ShapedTetrahedra;
struct ShapedVolume;
struct SplitField;
struct Support;
struct UnwrapFacts;
struct Walk;

// Each struct holds the facts that one step tells of an object beside the shown parts.

// Effects on an object that lies on a stroke, or on a lattice: then for its box, as it would stand
// without a stroke.
struct LayingEffects {
    Ref<Placement> placement; // null: the object is not laid
    Ref<ShapedVolume> shaped; // null: its volume was not shaped
    // The scene on which its stroke falls, and the parts of that; null: nothing. Both are in the
    // space where the stroke was drawn, which the stroke_motion moves to the world.
    Ref<RayScene> lies_on;
    Ref<std::vector<Support>> supports;
};
// A LatticeStroke bends a lattice that lies on a stroke, and its contents, further.
struct LatticeStroke {
    Ref<Placement> placement; // the volume of the stroke
    // into it, from the world in which the lattice would stand without the stroke
    Embedding embedding;
    bool operator==(const LatticeStroke&) const = default;
};
struct LatticeEffects {                // of what has a volume
    Ref<LatticeStroke> lattice_stroke; // null: no lattice, or one that lies on no stroke
    // The object's volume as its stroke, if it is a lattice, and the lattices round it bend it;
    // null: nothing does.
    Ref<Lazy<Ref<Lattice>>> bent_cage;
};
struct TetrahedraEffects {
    // The volume, if it is one of tetrahedra and can be, in its own space; null: it is none.
    Ref<ShapedTetrahedra> tetrahedra;
    glm::dmat4 tetrahedra_to_world{1};
};
struct StrokeMotionEffects {
    Ref<StrokeMotion> stroke_motion; // null: nothing carries it
    // The transform from the object's own space to the world: that of its model, or where it lay
    // before it was carried.
    glm::dmat4 own_to_world{1};
    std::vector<Part> own_parts = {}; // in that space, before lattices; none: they are in the world
};
struct TravelEffects {
    Ref<Journey> journey; // null: it does not travel
    Ref<Walk> walk;       // null: its feet are not locked to its travel
};
struct RefiningEffects {
    Ref<RefinementResult> refined; // null: its triangles are those of the model
};
struct TilingEffects {
    // Materials of the other objects among its tiles, behind its own; null: none.
    Ref<std::vector<Material>> mixed_materials;
    // The heights of its look up to which no tile is lowered, at this frame: of all, and by stroke
    // of those that it lays; infinite: none is ever lowered, or the guard is off.
    double height_limit = std::numeric_limits<double>::infinity();
    std::vector<double> stroke_limits = {};
    std::size_t painted = 0;           // number of tiles that strokes lay
    std::size_t overlapping = 0;       // of these, where such tiles are not left out
    std::vector<Id> tile_objects = {}; // by the meshes of its parts: of what the tiles are copies
};
struct SimplifyingEffects {
    std::size_t triangles_before = 0, triangles = 0; // of its shape; 0: it is not simplified
};
struct UnwrappingEffects {
    Ref<UnwrapFacts> unwrapped; // null: its texture coordinates are those of its file
};
struct CuttingEffects {
    std::size_t pieces = 0; // into which it is cut; 0: nothing cuts it
    double cut_error = 0;   // metres: bound of the distance of its cuts from curved cut surfaces
    // The distance by which the part above each of its own cuts stands off its place, in its own
    // space; the part below stands off as far the other way.
    std::vector<glm::dvec3> cuts_open = {};
};
struct SplittingEffects {
    // The field that parts it, where it stands at this frame; null: it is parted by nothing.
    Ref<SplitField> split_field;
    bool split_apart = false; // that moves something of it
    double split_off = 0;     // metres: bound of the distance of its triangles from the true walls
    std::vector<Part> whole_parts = {}; // as they were before; empty: nothing was cut
};

// A Stage is an object after some of its steps. A step changes a copy and returns that, so that a
// stage never changes once another step has seen it.
struct Stage : SimplifyingEffects,
               UnwrappingEffects,
               IncisingEffects,
               LayingEffects,
               LatticeEffects,
               TetrahedraEffects,
               StrokeMotionEffects,
               TravelEffects,
               RefiningEffects,
               TilingEffects,
               CuttingEffects,
               SplittingEffects {
    Ref<Shape> shape;                 // what its source gives, as the file has it; never null
    std::vector<Part> parts;          // in the world; may be empty
    std::vector<CurvePart> curves;    // in the world; may be empty
    std::vector<std::string> notices; // for example: a missing file, a stroke that no longer hits
    // The notices that say why something is missing, as in Shape.
    std::vector<std::string> lacks;
    // The placement on its stroke, if it lies on one; `placement` of a lattice is that of its box.
    const Ref<Placement>& stroke_placement() const
    {
        return lattice_stroke ? lattice_stroke->placement : placement;
    }
    // Its volume with the control points where they are seen. It must have one.
    Ref<Lattice> seen_cage() const;
    // Returns the parts with the faces of its model: objects that lie on it by these do not see
    // that it is split.
    const std::vector<Part>& whole() const { return whole_parts.empty() ? parts : whole_parts; }
    bool has_no_geometry() const { return parts.empty() && curves.empty(); }
    // Volume data may be seen by lines and rays alone; tetrahedra are seen by their edges.
    bool shows_nothing() const
    {
        return has_no_geometry() && !tetrahedra && !(shape && shape->volume);
    }
    // A sentence for the user that says why the stroke gave nothing; the object then stands
    // undeformed where its transform says. A tool shows the sentence and does not commit. Empty:
    // the object is laid, or has no stroke.
    std::string rejected;
};

} // namespace trivar
