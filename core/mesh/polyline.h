// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Points that are joined in their order. Where the last one is the first the line is closed. One
// that is not finite is a gap.
struct Polyline {
    std::vector<glm::vec3> points;
    std::vector<glm::vec4> colors; // linear, a coverage; one a point, or one for all; empty: white
    bool operator==(const Polyline&) const = default;
};

} // namespace trivar
