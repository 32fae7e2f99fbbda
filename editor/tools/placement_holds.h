// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/evaluation/evaluate.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// What a hand can take hold of on something that lies on a stroke: places of the stroke, the rims
// and the roof of its volume (one for each point of their profiles, across: of the height across,
// map: of the height map, rise: of the rise, up a corner of it), where on the stroke the model
// begins and ends, the level that lies on the scene, and how deep the floor is sunk under it.
enum class HoldKind { none, stroke, width, height, across, map, rise, start, end, contact, sunk };
struct Hold {
    HoldKind kind = HoldKind::none;
    int index = 0; // of the place or the point, of a map row by row; of a rim 2 x point, and 1 more
                   // on the left one
    bool operator==(const Hold&) const = default;
};

struct HoldPoint {
    Hold hold;
    double u = 0;             // along the stroke
    glm::dvec3 p_world{0};    // where it stands
    glm::dvec3 base_world{0}; // what its distance is measured from; of contact and floor: the
                              // roof; of start and end: a place further in
};
std::vector<HoldPoint> hold_points(const PlacementStep& step, const Placement& placement);

// Where it is drawn, pixels: a size that is seen end on, as heights are from where the stroke was
// drawn, on a stalk of its own; start and end beyond the ends. Nothing behind the eye.
std::optional<glm::dvec2> seen_at(const HoldPoint& point, const Camera& camera, double scale);

// The one under a pixel, the nearest where several are; nothing where none is.
std::optional<HoldPoint> hold_at(const std::vector<HoldPoint>& points, const Camera& camera,
                                 glm::dvec2 p_px, double scale);

// A drag: what there was when it began, and where.
struct HoldDrag {
    Id object = 0;
    PlacementStep step;
    Ref<Placement> placement;
    Ref<RayScene> scene; // what the stroke falls on
    HoldPoint held;
    Camera camera;
    glm::dvec2 from_px{0};
    double scale = 1; // of the interface
};
// What it asks for when the hand is at `to_px`; with `snap` in round steps. Sizes are cut to what
// is allowed. Pure.
EditPlacement dragged(const HoldDrag& drag, glm::dvec2 to_px, bool snap);

// The number that such a drag changes: "width 0.49 m".
std::string words_of(const Hold& hold, const PlacementParameters& parameters,
                     const PlacementReport& report);
std::string name_of(HoldKind kind); // "Width"

// Where the middle line of the strip comes nearest to a pixel, along the stroke, and how near.
struct NearestLine {
    double u = 0, distance_px = 1e300;
};
NearestLine nearest_on_line(const Placement& placement, const Camera& camera, glm::dvec2 p_px);

} // namespace trivar
