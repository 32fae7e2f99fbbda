// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_net.h"
#include "core/mesh/cage.h"

namespace trivar {

// Texture coordinates at the corners of each chart, as these are numbered; between them they are
// bilinear. Charts on both sides of a seam have coordinates of their own there.
using ChartUvs = std::vector<std::array<glm::dvec2, 4>>;

// The texture coordinates of the charts of a FacetSurface or a LimitSurface over a cage, for those
// of the cage's corners (#corners). O(#corners).
ChartUvs chart_uvs(const ChartNet& net, const Cage& cage, std::span<const glm::dvec2> corner_uvs);

// The same bits for a side that runs the other way, where 1 - x and 1 - y are exact.
inline glm::dvec2 uv_in_chart(const std::array<glm::dvec2, 4>& uvs, const glm::dvec2& at)
{
    const double s = 1 - at.x, t = 1 - at.y;
    return t * (s * uvs[0] + at.x * uvs[1]) + at.y * (s * uvs[3] + at.x * uvs[2]);
}

} // namespace trivar
