// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <optional>

namespace trivar {

// A part of an object in a volume on its way from one moment to another.
struct PartOnItsWay {
    const Object& object;
    const EvaluatedObject& evaluated; // at the first of them
    const Part &a, &b;
    double frames_per_second = 24;
    const Model* model = nullptr; // null: it is none of a file
    int node = -1, member = 0;
    double from_s = 0, to_s = 0;                       // of the document's time
    double shift_from = 0, shift_to = 0, uneven_u = 0; // of u, laps counted
    glm::dmat4 e0{1}, e1{1};                           // to_uvw at both, laps counted
};

// How far its points are from going evenly, by u, v and w, at most; nothing: not known. By travel,
// and by the clip: at the moments between at which it goes on otherwise the poses are compared, and
// from one such to the next the product rule bounds them (core/mesh/pose_rates.h,
// core/mesh/planting_rates.h). For each such moment O(#nodes #bones + #joints #targets).
std::optional<glm::dvec3> deviation_of(const PartOnItsWay& way);

} // namespace trivar
