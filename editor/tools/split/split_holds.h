// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/stages/evaluated.h"
#include "editor/hands/motion.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// What a hand can take on an object that is parted or cut: the place of an obstacle; the distance
// at which an opening has faded away; how much of the opening stays free; where a cut goes through;
// and how far its halves stand apart.
enum class SplitHoldKind { none, place, reach, clearance, level, gap };
struct SplitHold {
    SplitHoldKind kind = SplitHoldKind::none;
    int number = 0; // of the opening, ascending along the way in which it opens; or of the cut
    int side = 0;   // -1 below, +1 above
    bool operator==(const SplitHold&) const = default;
};

struct SplitHoldPoint {
    SplitHold hold;
    glm::dvec3 p_world{0};
    glm::dvec3 base_world{0};   // what its distance is measured from
    glm::dvec3 way{1, 0, 0};    // unit: along it the number grows
    glm::dvec3 across{0, 0, 0}; // place: the unit normal of the plane in which it goes
    double value = 0;           // metres: the number that is shown; reach: the one in force
    double least = 0;           // reach: what its kernel needs; below it is automatic
    std::vector<Id> obstacles;  // of an opening
};
// The holds of the openings that part an object, or of its cuts, where they meet it.
std::vector<SplitHoldPoint> split_holds(const Document& document, const EvaluatedObject& object);
std::vector<SplitHoldPoint> cut_holds(const Cutting& cutting, const EvaluatedObject& object);

// The pixel at which a hold is drawn: those that a hand pulls outward stand a little further out.
// Nothing behind the eye, and where the way along which it goes points at the eye.
std::optional<glm::dvec2> seen_at(const SplitHoldPoint& point, const Camera& camera, double scale);

// The hold under a pixel, the nearest where there are several.
std::optional<SplitHoldPoint> hold_at(const std::vector<SplitHoldPoint>& points,
                                      const Camera& camera, glm::dvec2 p_px, double scale);

// A drag, with all as it was when it began.
struct SplitHoldDrag {
    Id object = 0;
    Splitting splitting;          // without obstacles: it is not split
    Cutting cutting;              // without cuts: it is not cut
    glm::dmat4 own_to_world{1};   // of the object
    std::vector<Stand> obstacles; // of the opening, those that can be moved
    SplitHoldPoint held;
    Camera camera;
    glm::dvec2 from_px{0};
};
// The command for a hand at `to_px`; with `snap` in round steps. Pure.
Command dragged(const SplitHoldDrag& drag, glm::dvec2 to_px, bool snap);

// The number of a hold: "Clearance 0.05 m".
std::string words_of(const SplitHoldPoint& point);

} // namespace trivar
