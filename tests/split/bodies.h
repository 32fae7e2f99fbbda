// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/mesh/edges.h"

#include <functional>

namespace trivar::testing {

// A closed mesh whose vertices at one place are one point.
Mesh welded(Mesh mesh);
// A closed sphere.
Mesh ball(const glm::dvec3& middle, double radius, int segments);
// A tube round a curve over 0..1, of that radius, closed at both ends.
Mesh bar(const std::function<glm::dvec3(double)>& axis, double radius, int pieces = 8);

struct Closedness {
    std::size_t open = 0;    // directed edges without an opposite one
    std::size_t twice = 0;   // directed edges that are there more than once
    std::size_t unequal = 0; // edges that faces run along more often one way than the other
    long euler = 0;
};
Closedness closedness(const Mesh& mesh);
// The faces of which all vertices have `which` in `above`.
Mesh half_of(const Mesh& mesh, const std::vector<char>& above, bool which);

} // namespace trivar::testing
