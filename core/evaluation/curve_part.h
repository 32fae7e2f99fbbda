// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/part.h"
#include "core/mesh/curves.h"

#include <vector>

namespace trivar {

// Curves as they stand in the world. Their points are a part without faces, so that volumes bend
// them by the function that bends vertices: once, by the processor, when somebody asks for them.
// Between its points a line stays straight.
struct CurvePart {
    Ref<Curves> curves;
    Part points; // a vertex for each point of `curves`

    bool operator==(const CurvePart&) const = default;
};

// In the world, as they are bent.
Curves in_world(const CurvePart& part);

// The parts and, behind them, the points of the curves, for what is done to both; and back.
std::vector<Part> with_points(std::vector<Part> parts, const std::vector<CurvePart>& curves);
void put_back(std::vector<Part> all, std::vector<Part>& parts, std::vector<CurvePart>& curves);

} // namespace trivar
