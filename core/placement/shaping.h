// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

#include <optional>
#include <span>
#include <vector>

// What is done to a volume after it was laid, one value a step. Places are given in the volume's
// own u, v, w of 0..1 and directions along its own (VolumeDirections), so that the steps follow it
// wherever its stroke goes.

namespace trivar {

// How much of a press reaches a control point at x = distance / radius; nothing from x = 1 on.
// Gaussian: exp(-x^2 / (2 s^2)) with s = 1/3, taken down by its value at 1; hat: 1 - x; box: all
// of it; smooth: (1 - x^2)^2, C^1 at the rim.
enum class Decay { gaussian, hat, box, smooth };
double decay(Decay decay, double x);

// A ball pressed into the volume, drawn out of it where amounts are negative. Schein 2006, 2.4.1.
struct Press {
    Decay decay = Decay::gaussian;
    double radius = 0.1; // metres
    // Where the ball's centre is and by how many metres it presses there, [u, v, w, amount] each.
    // Distances are those before the first of them.
    std::vector<glm::dvec4> samples = {};
    bool mirror = false;     // the same at 1 - v
    bool guard = true;       // no more of it than is proven not to fold
    bool into_scene = false; // what lies on the scene may be drawn into it
    bool operator==(const Press&) const = default;
};

// Control points moved, turned and scaled as one. The first says along, across and up.
struct PointShift {
    std::vector<glm::ivec3> points = {}; // indices along, across and above the stroke
    glm::dvec3 by{0};                    // metres along, across and up
    bool mirror = false;                 // those on the other side of the middle the other way
    bool guard = true;
    // How many the volume has along, across and up that they were numbered in: in another one they
    // would be other points, and nothing is moved. 0: whichever there is.
    glm::ivec3 of{0};
    // One a point, 0..1: the share of the whole that it takes. None: all of it, each.
    std::vector<double> weights = {};
    // About the middle of the points that take all of it, in the first one's directions: scaled
    // along them, then turned about along, across and up, then moved. A share of a turn is one by
    // that share of its angles.
    glm::dvec3 rotation_deg{0}, factors{1};
    bool mirror_along = false, mirror_up = false; // as `mirror`, along those axes
    bool operator==(const PointShift&) const = default;
};

enum class VolumeAxis { along, across, up };

// More control points where they are wanted; the volume keeps its shape.
struct KnotInsertion {
    std::vector<double> along = {}, across = {}, up = {}; // parameters, inside 0..1
    bool operator==(const KnotInsertion&) const = default;
};

// Fewer control points along one axis, as near to the shape as they come.
struct Coarsening {
    VolumeAxis axis = VolumeAxis::along;
    int count = 4;
    bool operator==(const Coarsening&) const = default;
};

// The smallest change that was found after which nothing folds.
struct Mending {
    bool operator==(const Mending&) const = default;
};

// A box of u, v, w.
struct VolumePart {
    glm::dvec3 lo{0}, hi{1};
    bool operator==(const VolumePart&) const = default;
};
// Parts of the volume that may fold from then on: the guard leaves them alone.
struct FoldAllowance {
    std::vector<VolumePart> boxes = {}; // beside those of before. None: nothing may any more
    bool operator==(const FoldAllowance&) const = default;
};

// A box as a whole turned, bent, tapered, sheared or bulged along one of its axes, in this order:
// bulge, taper, shear, bend, twist. Zeros leave it as it is. After Barr 1984, section 4, on the
// control points.
struct Warp {
    VolumeAxis axis = VolumeAxis::up;
    double fixed = 0;      // where along the axis twist and bend leave it as it is: 0 at the near
                           // end, 1 at the far end
    double twist_deg = 0;  // by which its far end is turned about the axis against its near end
    double bend_deg = 0;   // that the axis turns from its near end to its far end, along an arc
    double toward_deg = 0; // to which side it is bent and sheared: 0 toward the next axis
    double taper = 0;      // -1..: the far end is 1 + taper times as wide, the near end stays
    double shear = 0;      // how far the far end goes to that side, in lengths of the box
    double bulge = 0;      // -1..: the middle is 1 + bulge times as wide, both ends stay
    bool guard = true;     // no more of it than is proven not to fold
    bool operator==(const Warp&) const = default;
};

// Exactly one of them.
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

// The part of u, v, w that some control points bend: the least box round the spans of their basis
// functions; all of a closed axis where one goes across its seam.
VolumePart bent_by(const Lattice& volume, std::span<const glm::ivec3> points);

// Unit directions of a volume at a place: along the stroke, across it and up from the scene, right
// angles between them, right-handed.
struct VolumeDirections {
    glm::dvec3 along{1, 0, 0}, across{0, 1, 0}, up{0, 0, 1};
    glm::dvec3 to_world(const glm::dvec3& v) const { return v.x * along + v.y * across + v.z * up; }
};
VolumeDirections volume_directions(const Lattice& volume, const glm::dvec3& uvw);

} // namespace trivar
