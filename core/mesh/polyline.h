// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A Polyline is points that are joined in their order. Where the last point equals the first, the
// line is closed. A point that is not finite is a gap.
struct Polyline {
    std::vector<glm::vec3> points;
    // linear with coverage; one per point, or one for all; empty: white
    std::vector<glm::vec4> colors = {};
    // Shares of the width that the line is drawn with, one per point; empty: all of it.
    std::vector<float> widths = {};
    bool operator==(const Polyline&) const = default;
};

} // namespace trivar
