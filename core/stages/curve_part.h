// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/part.h"
#include "core/mesh/curves.h"

#include <vector>

namespace trivar {

// A CurvePart is curves as they stand in the world. Their points are a part without faces, so that
// volumes deform them by the function that deforms vertices: once, by the processor, when somebody
// asks for them. Between two points a line stays straight.
struct CurvePart {
    Ref<Curves> curves;
    Part points; // one vertex per point of `curves`

    bool operator==(const CurvePart&) const = default;
};

// The curves in the world, deformed.
Curves in_world(const CurvePart& part);

// The parts followed by the points of the curves, for work that is done on both; and the way back.
std::vector<Part> with_points(std::vector<Part> parts, const std::vector<CurvePart>& curves);
void put_back(std::vector<Part> all, std::vector<Part>& parts, std::vector<CurvePart>& curves);

} // namespace trivar
