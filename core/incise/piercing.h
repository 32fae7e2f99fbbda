// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

struct PiercingPair {
    std::uint32_t a, b; // triangles, a < b
    auto operator<=>(const PiercingPair&) const = default;
};

// Finds the triangles that pierce each other and have at most one vertex in common, ascending. It
// decides with doubles: what they cannot tell from touching is no piercing. Costs O(#triangles log)
// where they are of like size. In parallel; the same for any number of threads.
std::vector<PiercingPair> piercings(const std::vector<glm::dvec3>& positions,
                                    const std::vector<glm::uvec3>& triangles);

} // namespace trivar
