// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

#include <optional>
#include <vector>

// A TetrahedraShape is a volume of tetrahedra that deforms objects in it, with its edits. All
// places are in its own space, before any deformation: they stay where they are when the domain
// changes.

namespace trivar {

// A TetrahedraPull scales, turns and moves the control points in one or several balls as one, less
// and less toward the rims. One of the domain does not reach across cuts; refinements have none.
// Balls round resting places that hold no other ones, with the decay `box`, move control points by
// hand.
struct TetrahedraPull {
    int layer = 0; // 0: the domain; n: the nth refinement
    glm::dvec3 at{0};
    std::vector<glm::dvec3> also = {}; // middles of more balls of that radius
    double radius = 0.5;               // metres
    glm::dvec3 by{0};                  // metres
    // About X, Y and Z and along them, about the middle of where the balls' middles are now.
    glm::dvec3 rotation_deg{0}, factors{1};
    Decay decay = Decay::smooth;
    bool guard = true; // does no more of it than keeps det J above 0 at the samples
    bool operator==(const TetrahedraPull&) const = default;
};

// A TetrahedraCrease lowers the continuity across inner faces of the domain with middles within the
// radius of a place. The deepest counts, but one of depth 0 takes away those before it.
struct TetrahedraCrease {
    std::vector<glm::dvec3> places = {};
    double radius = 0.1; // metres
    int depth = 1;       // Crease::depth; the degree: a cut; 0: smooth
    bool seam = false;   // of that depth: slopes may jump, but it stays in one piece
    bool operator==(const TetrahedraCrease&) const = default;
};

// A TetrahedraCloud moves knots of the cloud of one vertex of the domain from where they would be:
// all of them `factor` times as far from the vertex, then by some way. Knots that a crease holds in
// a plane stay in it.
struct TetrahedraCloud {
    glm::dvec3 at{0}; // where the vertex is; where none is, nothing changes
    int knot = 0;     // 1 .. degree; 0: all
    glm::dvec3 by{0}; // metres
    double factor = 1;
    bool operator==(const TetrahedraCloud&) const = default;
};

// A TetrahedraRefinement adds a layer of smaller tetrahedra round some places. Its control points
// add to the displacement of all layers before, and begin at 0, so that nothing changes its shape
// [Forsey, Bartels, Hierarchical B-spline refinement, 1988].
struct TetrahedraRefinement {
    std::vector<glm::dvec3> places = {};
    double radius = 0.3; // metres round each place
    double edge = 0.15;  // metres
    bool operator==(const TetrahedraRefinement&) const = default;
};

// A TetrahedraEdit holds exactly one of these. Creases and clouds apply from the beginning.
struct TetrahedraEdit {
    std::optional<TetrahedraPull> pull = {};
    std::optional<Warp> warp = {}; // of the box round the domain
    std::optional<TetrahedraCrease> crease = {};
    std::optional<TetrahedraRefinement> refinement = {};
    std::optional<TetrahedraCloud> cloud = {};
    bool operator==(const TetrahedraEdit&) const = default;
};

// A TetrahedraFunction shows the functions of the control point that rests nearest to a place, as
// the surface on which they have a share of their greatest value.
struct TetrahedraFunction {
    glm::dvec3 at{0};
    double share = 0.5;
    bool operator==(const TetrahedraFunction&) const = default;
};

// The greatest number of functions that are shown at once.
inline constexpr std::size_t most_shown_functions = 64;

struct TetrahedraShape {
    glm::dvec3 size{1};   // metres, of a box about the origin
    glm::ivec3 boxes{2};  // along X, Y and Z, of 6 tetrahedra each
    int degree = 2;       // 1..3
    double spread = 0.15; // CloudStyle::spread
    // The domain, where it is no box: both empty, or neither.
    std::vector<glm::dvec3> vertices = {};
    std::vector<glm::ivec4> cells = {};
    // The displacements of a lattice that was converted to tetrahedra, in metres, for each cell in
    // turn (CellDisplacements); empty: none. `deviation` is their greatest distance from the
    // lattice, if it was measured.
    std::vector<glm::dvec3> displaced = {};
    double deviation = 0;
    std::vector<TetrahedraEdit> edits = {};
    std::vector<TetrahedraFunction> functions = {}; // that are shown
    bool operator==(const TetrahedraShape&) const = default;
};

} // namespace trivar
