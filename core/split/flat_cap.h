// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Triangles between places and points inside; the latter are numbered from the number of places up.
struct FlatCap {
    std::vector<std::array<std::uint32_t, 3>> triangles; // counter-clockwise in the parameters
    std::vector<glm::dvec2> inside;
};

} // namespace trivar
