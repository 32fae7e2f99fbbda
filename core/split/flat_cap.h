// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <set>
#include <utility>
#include <vector>

namespace trivar {

// Triangles between places and points inside; the latter are numbered from the number of places up.
struct FlatCap {
    std::vector<std::array<std::uint32_t, 3>> triangles; // counter-clockwise in the parameters
    std::vector<glm::dvec2> inside;
    // Edges of loops that no skin has, since they go across gaps of the mesh; by places.
    std::set<std::pair<std::uint32_t, std::uint32_t>> gaps = {};
};

} // namespace trivar
