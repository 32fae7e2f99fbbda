// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace trivar {

// A Triangulation is a constrained Delaunay triangulation of points of the grid. It is CGAL's,
// which decides by exact numbers: no input brings it into disorder, and every machine makes the
// same triangles.
class Triangulation {
public:
    using Corners = std::array<int, 3>; // point numbers, counter-clockwise

    Triangulation();
    ~Triangulation();

    // The number of the point at that place, a new one or an existing one; numbers count up from 0.
    // It is looked for from point `near` on; -1: from the last one.
    int insert(const glm::ivec2& p, int near = -1);
    // Makes a - b an edge that stays, or several edges in a row where points lie on it. It stops at
    // an edge that stays and would be crossed.
    enum class JoinResult { one_edge, several, crosses };
    JoinResult join(int a, int b);

    // Declares as inside the area to the left of these edges, which must stay. Returns whether they
    // enclose it, once everywhere.
    bool fill(const std::vector<std::pair<int, int>>& edges);
    // Inserts centres of circumscribed circles [1] of triangles inside that have an edge longer
    // than that, as long as one lies, within sight, in a triangle that `may_split`; `added` is told
    // of each new point and the corners of the triangle that it lies in. Where the edges of `join`
    // are shorter than 0.8 of that, all others round what may be split become so.
    //   [1] Chew, Guaranteed-quality triangular meshes, 1989
    void refine(double longest, const std::function<bool(const Corners&)>& may_split,
                const std::function<void(int point, const Corners&)>& added);

    const std::vector<glm::ivec2>& points() const { return points_; }
    std::vector<Corners> inside() const; // the triangles that fill() found inside

private:
    struct Plane;
    std::unique_ptr<Plane> plane_;
    std::vector<glm::ivec2> points_;
};

} // namespace trivar
