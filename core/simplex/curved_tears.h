// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/cell_faces.h"

#include <set>

namespace trivar {

// CurvedTears round the faces between two parts of the cells of a domain: each flat face becomes a
// cubic triangle through its corners that has the faces' mean normals there [Vlachos, Peters, Boyd,
// Mitchell, Curved PN Triangles, I3D 2001], moved so that these lie in the mean where the flat ones
// do and the parts keep their volumes. Neighbours meet along their edges, and those on the border
// stay in it where it is flat.
class CurvedTears {
public:
    // One flag per cell; the normals go from inside to outside. O(n log n) of the cells.
    CurvedTears(const SimplexDomain<3>& domain, const std::vector<bool>& inside);

    // Returns the unit normal at a vertex on a cut; 0 at others.
    const glm::dvec3& normal(int vertex) const
    {
        return normals_[static_cast<std::size_t>(vertex)];
    }

    // Returns the point to which rounding moves a place on the flat face of these vertices.
    // `vertices`: ascending; negative: none. `weights`: of sum 1, and 0 for vertices that are none.
    // A place that is on no cut stays.
    glm::dvec3 rounded(const std::array<int, 3>& vertices, const glm::dvec3& weights) const;

private:
    void keep_volume();
    glm::dvec3 towards(int from, int to) const; // control point at a third of an edge
    glm::dvec3 on_edge(int a, int b, double t) const;

    const SimplexDomain<3>& domain_;
    std::vector<glm::dvec3> corners_, normals_; // by vertex
    std::set<std::array<int, 3>> faces_;
    std::set<std::array<int, 2>> edges_;
};

} // namespace trivar
