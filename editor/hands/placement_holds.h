// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/placement/place.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A HoldKind is a thing that a hand can take on an object on a stroke: points of the stroke; the
// rims and the roof of its volume, with one hold per point of their profiles (across: of the height
// across; map: of the height map; rise: of the rise, up a corner of the volume); where on the
// stroke the model begins and ends; the level that lies on the scene; and how deep the floor is
// sunk under it.
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

// The place at which a hold is drawn, in pixels. A size that is seen end-on, like heights from the
// view of the stroke, stands on a stalk; start and end stand beyond the ends. Empty behind the eye.
std::optional<glm::dvec2> seen_at(const HoldPoint& point, const Camera& camera, double scale);

// The hold under a pixel, the nearest where there are several; empty where there is none.
std::optional<HoldPoint> hold_at(const std::vector<HoldPoint>& points, const Camera& camera,
                                 glm::dvec2 p_px, double scale);

// A HoldDrag is a drag: the state when it began, and the place.
struct HoldDrag {
    Id object = 0;
    PlacementStep step;
    Ref<Placement> placement;
    Ref<RayScene> scene; // the scene on which the stroke falls
    HoldPoint held;
    Camera camera;
    glm::dvec2 from_px{0};
    double scale = 1; // of the interface
    // The step's stroke is what it is now, in a space that this takes to the world; the hosts are
    // as they stand there.
    glm::dmat4 to_world{1};
    std::optional<Attachment> hosts = {};
};
// The command for a hand at `to_px`; with `snap` in round steps. Sizes are limited to what is
// allowed. Pure.
EditPlacement dragged(const HoldDrag& drag, glm::dvec2 to_px, bool snap);

// The number that such a drag changes: "width 0.49 m".
std::string words_of(const Hold& hold, const PlacementParameters& parameters,
                     const PlacementReport& report);
std::string name_of(HoldKind kind); // "Width"

// A NearestLine is where the middle line of the strip comes nearest to a pixel: the place along the
// stroke, and the distance.
struct NearestLine {
    double u = 0, distance_px = 1e300;
};
NearestLine nearest_on_line(const Placement& placement, const Camera& camera, glm::dvec2 p_px);

} // namespace trivar
