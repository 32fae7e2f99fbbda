// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/ffd/deform.h"
#include "core/placement/placement_input.h"
#include "core/spline/surface.h"

#include <string>
#include <vector>

namespace trivar {

class RayScene;

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

// The way in which a node of the strip came to rest.
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

// Lays a volume along a stroke for a model: sketch fit, offsets, ray grid, misses, springs, contact
// surface, lift, volume. The model's +x runs along the stroke, its +z stands on the scene. Schein
// 2006, chapter 2.
//   sketch   the stroke in its camera's picture, pixels
//   model    box of the model, its own space, metres
//   scene    on which the stroke falls, world
//   timings  receives the time of each stage
// Pure; the same bits for any number of threads. Throws Rejected with a sentence that says what to
// do, for a click, a stroke that leaves the picture or hits nothing, one that leaves its surface
// for another far behind where jumps are bridged, and sizes that are not positive.
Placement place(const Sketch& sketch, const PlacementParameters& parameters, const Box& model,
                const RayScene& scene, Timings& timings);

} // namespace trivar
