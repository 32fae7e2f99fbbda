// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

struct PiercingPair {
    std::uint32_t a, b; // triangles, a < b
    auto operator<=>(const PiercingPair&) const = default;
};

// Whether two triangles pierce each other and have at most one vertex in common. It decides with
// doubles: a pair that they cannot tell from touching does not pierce.
bool pierce(std::span<const glm::dvec3> positions, const glm::uvec3& a, const glm::uvec3& b);

// Finds the pairs that do, ascending; where triangles are `asked` for, those with one of them.
// Costs O(#triangles + #pairs whose boxes meet) where they are of like size. In parallel; the same
// for any number of threads.
std::vector<PiercingPair> piercings(const std::vector<glm::dvec3>& positions,
                                    const std::vector<glm::uvec3>& triangles,
                                    std::span<const char> asked = {});
// Finds the pairs that pierce each other at one of several times at least; each time is a set of
// positions. Each vertex moves straight from the first to the last.
std::vector<PiercingPair> piercings(std::span<const std::vector<glm::dvec3>> times,
                                    const std::vector<glm::uvec3>& triangles,
                                    std::span<const char> asked = {});

} // namespace trivar
