// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

#include <optional>
#include <span>
#include <vector>

// These values say what is done to a volume after it was laid, one value per step. Places are given
// in the volume's own u, v, w of 0..1 and directions along its own (VolumeDirections), so that the
// steps follow the volume wherever its stroke goes.

namespace trivar {

// The share of a press that reaches a control point at x = distance / radius; 0 from x = 1 on.
// Gaussian: exp(-x^2 / (2 s^2)) with s = 1/3, minus its value at 1; hat: 1 - x; box: 1; smooth: (1
// - x^2)^2, C^1 at the rim.
enum class Decay { gaussian, hat, box, smooth };
double decay(Decay decay, double x);

// A Press is a ball pressed into the volume, or drawn out of it where amounts are negative. Schein
// 2006, 2.4.1.
struct Press {
    Decay decay = Decay::gaussian;
    double radius = 0.1; // metres
    // The centre of the ball and the metres by which it presses there, [u, v, w, amount] per
    // sample. Distances are those before the first sample.
    std::vector<glm::dvec4> samples = {};
    bool mirror = false;     // also presses at 1 - v
    bool guard = true;       // does no more of it than is proven not to fold
    bool into_scene = false; // the surface that lies on the scene may be drawn into the scene
    bool operator==(const Press&) const = default;
};

// A PointShift moves, turns and scales control points as one. The first point gives the directions
// along, across and up.
struct PointShift {
    std::vector<glm::ivec3> points = {}; // indices along, across and above the stroke
    glm::dvec3 by{0};                    // metres along, across and up
    bool mirror = false; // points on the other side of the middle move the other way
    bool guard = true;
    // The numbers of control points along, across and up of the volume for which `points` was made.
    // In a volume of other numbers these indices would be other points, and nothing is moved. 0:
    // any.
    glm::ivec3 of{0};
    // One weight per point, 0..1: its share of the whole movement. Empty: every point takes all of
    // it.
    std::vector<double> weights = {};
    // Rotation and factors apply about the middle of the points that take the whole movement, in
    // the first point's directions: the points are scaled along them, then turned about along,
    // across and up, then moved. A share of a turn is the turn by that share of its angles.
    glm::dvec3 rotation_deg{0}, factors{1};
    bool mirror_along = false, mirror_up = false; // as `mirror`, along those axes
    bool operator==(const PointShift&) const = default;
};

enum class VolumeAxis { along, across, up };

// A KnotInsertion adds control points at given parameters; the volume keeps its shape.
struct KnotInsertion {
    std::vector<double> along = {}, across = {}, up = {}; // parameters, inside 0..1
    bool operator==(const KnotInsertion&) const = default;
};

// A Coarsening leaves fewer control points along one axis, as near to the shape as possible.
struct Coarsening {
    VolumeAxis axis = VolumeAxis::along;
    int count = 4;
    bool operator==(const Coarsening&) const = default;
};

// A Mending is the smallest change that was found after which nothing folds.
struct Mending {
    bool operator==(const Mending&) const = default;
};

// A VolumePart is a box of u, v, w.
struct VolumePart {
    glm::dvec3 lo{0}, hi{1};
    bool operator==(const VolumePart&) const = default;
};
// A FoldAllowance names parts of the volume that may fold from then on: the guard ignores them.
struct FoldAllowance {
    // added to those of before; empty: no part may fold any more
    std::vector<VolumePart> boxes = {};
    bool operator==(const FoldAllowance&) const = default;
};

// A Warp bulges, tapers, shears, bends and twists a box as a whole along one of its axes, in this
// order. Zeros change nothing. After Barr 1984, section 4, applied to the control points.
struct Warp {
    VolumeAxis axis = VolumeAxis::up;
    // The place along the axis that twist and bend leave unchanged: 0 the near end, 1 the far end.
    double fixed = 0;
    double twist_deg = 0;  // turn of the far end about the axis, relative to the near end
    double bend_deg = 0;   // turn of the axis from its near end to its far end, along an arc
    double toward_deg = 0; // the side toward which it is bent and sheared: 0 toward the next axis
    double taper = 0;      // -1..: the far end is 1 + taper times as wide, the near end stays
    double shear = 0;      // way of the far end to that side, in lengths of the box
    double bulge = 0;      // -1..: the middle is 1 + bulge times as wide, both ends stay
    bool guard = true;     // does no more of it than is proven not to fold
    bool operator==(const Warp&) const = default;
};

// A VolumeEdit holds exactly one of these steps.
struct VolumeEdit {
    std::optional<Press> press = {};
    std::optional<PointShift> shift = {};
    std::optional<KnotInsertion> insertion = {};
    std::optional<Coarsening> coarsening = {};
    std::optional<Mending> mending = {};
    std::optional<FoldAllowance> allowance = {};
    std::optional<Warp> warp = {};
    bool operator==(const VolumeEdit&) const = default;
};

// The part of u, v, w that some control points influence: the smallest box round the spans of their
// basis functions; the whole of a closed axis where one of them reaches across the seam.
VolumePart bent_by(const Lattice& volume, std::span<const glm::ivec3> points);

// VolumeDirections holds the unit directions of a volume at a place: along the stroke, across it
// and up from the scene, at right angles, right-handed.
struct VolumeDirections {
    glm::dvec3 along{1, 0, 0}, across{0, 1, 0}, up{0, 0, 1};
    glm::dvec3 to_world(const glm::dvec3& v) const { return v.x * along + v.y * across + v.z * up; }
};
VolumeDirections volume_directions(const Lattice& volume, const glm::dvec3& uvw);

} // namespace trivar
