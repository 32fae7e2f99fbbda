// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <optional>

namespace trivar {

// A PartOnItsWay is a part of an object in a volume, seen at two moments: at the first one and at
// the last one.
struct PartOnItsWay {
    const Object& object;
    const EvaluatedObject& evaluated; // at the first moment
    const Part &a, &b;
    double frames_per_second = 24;
    const Model* model = nullptr; // null: the object has no model from a file
    int node = -1, member = 0;
    double from_s = 0, to_s = 0;                       // of the document's time
    double shift_from = 0, shift_to = 0, uneven_u = 0; // in u, with laps counted
    glm::dmat4 e0{1}, e1{1}; // to_uvw at the first and the last moment, with laps counted
};

// Bounds how far, in u, v and w, a point of the part is from moving evenly between the two moments;
// empty: not known. Both travel and the clip are counted. If the clip has keys between the two
// moments, the poses are compared at these keys; from one key to the next the product rule bounds
// them (core/walking/pose_rates.h, core/walking/planting_rates.h). Cost per key: O(#nodes #bones +
// #joints #targets).
std::optional<glm::dvec3> deviation_of(const PartOnItsWay& way);

} // namespace trivar
