// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <vector>

namespace trivar {

struct StrokeSample {
    glm::dvec2 p_px{0};  // in the camera's picture
    double time_s = 0;   // since the stroke began
    double pressure = 1; // 0..1
    bool operator==(const StrokeSample&) const = default;
};

struct Sketch {
    Camera camera;
    std::vector<StrokeSample> samples;
    bool operator==(const Sketch&) const = default;
};

// The largest number of control points of a volume per axis; the smallest is the axis's order.
inline constexpr int most_along_or_across = 400, most_layers = 64;

// The rule for a node of the grid whose ray hits nothing.
enum class Misses { membrane, ground, nearest, shrink };

// The model's axis that runs along the stroke.
enum class LengthAxis { x, y, z };

struct PlacementParameters {
    double width = 0;           // of the strip, metres; 0: in proportion to the model
    double height = 0;          // of the volume, metres; 0: in proportion to the model
    glm::ivec3 grid{33, 9, 4};  // control points along, across and above the stroke
    glm::ivec3 orders{3, 3, 3}; // 2..6 each
    double offset = 0;       // 0: F1, extrusion toward the camera; 1: F2, offset along the normals
    bool springs = true;     // bridge gaps by the obstacle problem
    double stiffness = 0.25; // a span of stiffness x length sags by a tenth of the gap, 0.001..1000
    double bending = 0;      // resistance to bending, relative to stiffness, 0..10
    int neighborhood = 3;    // grid steps round a rough node whose nodes are free to move
    double roughness_deg = 20; // angle between neighbouring faces that counts as rough, 1..90
    bool free_ends = false;    // the first and the last row of nodes may move too
    Misses misses = Misses::membrane;
    bool skip_back_faces = false;
    double start = 0;             // where along the stroke the model begins, 0..1
    double fill = 1;              // how much of the stroke it fills, start + fill <= 1
    double lift_tolerance = 1e-3; // allowed penetration, as a fraction of the height
    double clearance = 0;         // metres kept between scene and contact surface
    bool reverse = false;         // the model looks toward the start of the stroke
    double roll_deg = 0;          // quarter turns of the model about its length: 0, 90, 180, 270
    // Factors of width and height along the stroke, as control points (share, factor) of a Profile;
    // empty: 1 everywhere.
    std::vector<glm::dvec2> width_profile{}, height_profile{};
    // The same for the height across the stroke, from its right to its left. The height at (u, v)
    // is the height times both factors.
    std::vector<glm::dvec2> height_across{};
    // Factors of the height over the whole strip, as the control points of a HeightMap: rows along
    // the stroke, each from its right to its left; empty: 1 everywhere. All three factors multiply.
    std::vector<std::vector<double>> height_map{};
    // The height that the volume has reached at a share of w, as control points of a Rise; empty:
    // the share itself.
    std::vector<glm::dvec2> rise_profile{};
    double contact_level = 0; // the w that lies on the scene: 0 the floor of the volume, 1 its roof
    // the model's axis; the model is turned first, then rolled, then reversed
    LengthAxis along = LengthAxis::x;
    bool sharp = false;     // the surface has the creases of the scene under it
    bool on_ground = false; // it falls on the ground too, the plane Z 0 of the world
    // If set, the strip spans gaps, where rays hit far behind an edge, on the surface before the
    // edge instead of being torn. Older strokes follow every jump.
    bool bridge_jumps = false;
    bool operator==(const PlacementParameters&) const = default;
};

// The behaviour of a travelling model at the end of its stroke: it stops there, disappears,
// continues straight, continues from the other end, or goes back without turning round.
enum class Ends { stay, hide, run_on, loop, back_and_forth };

// A Travel says how a placed model moves along the middle of its volume.
struct Travel {
    // metres per second in the direction it looks; negative: backwards; 0: it rests
    double speed = 0;
    Ends ends = Ends::stay;
    double ease_in = 0, ease_out = 0; // seconds from rest to that speed, and back to rest
    int start_frame = 1;              // when it sets out
    double duration = 0;              // seconds after which it stops wherever it is; 0: no limit
    int followers = 0;                // number of further copies that follow one after the other
    double gap = 0;   // metres along the middle from one to the next; 0: evenly along a loop, else
                      // as close as they are long
    double phase = 0; // shift from one follower to the next, as a share of the clip's period
    bool operator==(const Travel&) const = default;
};

} // namespace trivar
