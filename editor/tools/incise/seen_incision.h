// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/incising.h"
#include "editor/tools/incise/incised_skin.h"

#include <array>

namespace trivar {

// A SeenIncision is where an incision is seen: places at equal steps of its length, from 0 to 1, on
// the shut skin and in the world. Where its stroke goes through air, a place lies between those
// before and after that are on the skin, or at the nearest of them.
struct SeenIncision {
    static constexpr std::size_t steps = 64;
    template <class T> using AtSteps = std::array<T, steps + 1>;
    AtSteps<SurfaceHit> line;
    AtSteps<glm::dvec3> across{}; // to the right of each, world, unit; 0: in the air
    AtSteps<bool> on_skin{};
    std::size_t first = 0, last = steps; // of the longest part that is on the skin
    // Lines that show how far the skin gives way, lifted off it a little: both rims along it, and
    // rungs over it.
    std::vector<std::vector<glm::dvec3>> rims, rungs;
    double length = 0, length_world = 0; // metres
    double widest = 1;                   // share of its width that its walls let open
    double depth = 0;                    // metres on the model, after the body's limits
    double scale = 1;                    // metres in the world per metre on the model
    glm::dvec3 at(double share) const;   // of the line, world
    std::size_t widest_at = steps / 2;   // the step of that part where it stands open most
};

// Points and normals at equal steps of a polyline's length.
std::vector<SurfacePoint> at_equal_steps(std::span<const SurfacePoint> stroke, std::size_t steps);

// `told`: what became of it; null: not known. Nothing: none of it is on the skin.
std::optional<SeenIncision> seen_incision(const IncisedSkin& skin, const NamedIncision& incision,
                                          const IncisingEffects::OfIncision* told);

// The share of a seen cut's length that is nearest to a pixel, and how far that is, in pixels.
// Nothing: it is behind the eye.
struct NearCut {
    double share = 0, away_px = 0;
};
std::optional<NearCut> near_cut(const SeenIncision& cut, const Camera& camera, glm::dvec2 p_px);

// The stroke between two shares of its length, as its points are.
std::vector<SurfacePoint> part_of(std::span<const SurfacePoint> stroke, double from, double to);

} // namespace trivar
