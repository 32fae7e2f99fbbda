// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/timing.h"
#include "core/ffd/deform.h"
#include "core/rays/ray_scene.h"
#include "core/spline/surface.h"

#include <string>
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

// What a node of the grid does when its ray hits nothing.
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
    // Where the strip would be torn by what its rays meet far behind an edge, it spans that on the
    // surface before it. Strokes drawn before there was this follow every jump.
    bool bridge_jumps = false;
    bool operator==(const PlacementParameters&) const = default;
};

struct PlacementReport {
    double length_world = 0, width_world = 0, height_world = 0;
    double missed_share = 0;    // of the nodes
    double contact_share = 0;   // of the nodes, after the springs
    double largest_gap = 0;     // metres between contact surface and scene
    double penetration = 0;     // largest penetration after the lift, as a fraction of height
    double largest_stretch = 1; // of the contact surface along the stroke
    int spring_iterations = 0;
    int narrowed = 0;                 // number of columns narrowed so that the strip does not fold
    double smallest_jacobian = 0;     // sampled at the nodes, relative to the undeformed volume's
    std::vector<std::string> notices; // sentences for the user
    // the sentence among them that says that the volume folds; empty: it does not
    std::string folds;
    std::vector<std::string> all_notices() const;
};

// The largest number of control points of a volume; each takes 24 bytes.
inline constexpr double most_control_points = 1e6;

// How a node of the strip came to rest.
enum class Contact : char { touches, bridges, missed };
struct StripNode {
    glm::dvec3 p_world{0}; // of the contact surface
    Contact contact = Contact::touches;
    double spread = 1;  // area of the surface there, relative to that of the given width and length
    bool folds = false; // det J <= 0 over the node
};

// A Placement is everything that one stroke gives. The contact surface is the volume's iso-surface
// w = `ground`.
struct Placement {
    Surface<glm::dvec3> contact;
    Lattice volume;
    Embedding embedding; // of a model with the box given to place()
    PlacementReport report;
    std::vector<std::vector<glm::dvec3>> strip; // the middle line and the two rims, world
    int node_columns = 0;                       // across the stroke
    double ground = 0;                          // the contact level; 1/2 round a Moebius band
    std::vector<StripNode> nodes; // at the Greville abscissae of the contact surface, v fastest
};

// Lays a volume along the stroke for a model with the given box: sketch fit, offsets, ray grid,
// misses, springs, contact surface, lift, volume. The model's +x runs along the stroke, its +z
// stands on the scene. Throws Rejected with a sentence that says what to do, for a click, a stroke
// that leaves the picture or hits nothing, one that leaves its surface for another far behind where
// jumps are bridged, and sizes that are not positive. Pure; any number of
// threads gives the same bits. Schein 2006, chapter 2.
Placement place(const Sketch& sketch, const PlacementParameters& parameters, const Box& model,
                const RayScene& scene, Timings& timings);

} // namespace trivar
