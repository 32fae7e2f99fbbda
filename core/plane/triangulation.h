// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace trivar {

// A constrained Delaunay triangulation of points of the grid, built by inserting points [1], then
// edges by flips [2]; turns are exact, so no input puts it in disorder.
//   [1] Lawson, Software for C1 surface interpolation, 1977
//   [2] Sloan, A fast algorithm for generating constrained Delaunay triangulations, 1993
class Triangulation {
public:
    using Corners = std::array<int, 3>; // point numbers, counter-clockwise

    Triangulation(); // of one huge triangle round the grid, whose corners are points 0, 1 and 2

    // The number of the point there, a new one or the one that was.
    int insert(const glm::ivec2& p);
    // Makes a - b an edge that stays: several, one after another, where points lie on it. It ends
    // at an edge that stays and would be crossed.
    enum class Joined { one_edge, several, crosses };
    Joined join(int a, int b);
    // Flips what is no edge of `join` till it is Delaunay.
    void settle();

    // Takes for inside what lies left of those edges, which stay and enclose it.
    void fill(const std::vector<std::pair<int, int>>& edges);
    // Inserts centres of circumscribed circles [3] of triangles inside that have an edge longer
    // than that, as long as one lies, within sight, in a triangle that `may_split`; `added` is told
    // of each new point and the corners of the triangle that it lies in. Where the edges of `join`
    // are shorter than 0.8 of that, all others round what may be split become so.
    //   [3] Chew, Guaranteed-quality triangular meshes, 1989
    void refine(double longest, const std::function<bool(const Corners&)>& may_split,
                const std::function<void(int point, const Corners&)>& added);

    const std::vector<glm::ivec2>& points() const { return points_; }
    std::vector<Corners> inside() const; // the triangles that fill() found

private:
    struct Triangle {
        Corners v;            // side i is from v[i + 1] to v[i + 2] ...
        std::array<int, 3> n; // ... and across it is triangle n[i], or none: -1
        std::array<bool, 3> stays{};
        bool inside = false;
    };
    struct Side {
        int triangle, side;
    };
    std::int64_t turn_of(int a, int b, int c) const;
    int locate(const glm::ivec2& p, int from, bool through) const;
    int split(int triangle, const glm::ivec2& p);
    void flip(Side s);
    bool flips_well(Side s) const; // its two triangles are a convex quadrangle
    bool is_delaunay(Side s) const;
    void settle_round(int point);
    Side find(int a, int b) const; // the side of the triangle left of a - b; {-1, 0}: none
    Side twin(Side s) const;
    void keep(Side s);
    int turn_round(int point, int triangle) const;

    std::vector<glm::ivec2> points_;
    std::vector<int> triangle_at_; // #points to one that has it
    std::vector<Triangle> triangles_;
    int last_ = 0;
};

} // namespace trivar
