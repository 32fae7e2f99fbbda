// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/obstacle.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A SpringSheet is a grid of nodes, each of which moves along a line: P = p0 + s direction, lo <= s
// <= hi. Springs of rest length zero join neighbours. The sheet's energy is 1/2 sum k |P_a - P_b|^2
// + bending / 2 sum |P_before - 2 P + P_after|^2 + pull / 2 sum area s^2. The weights k make the
// energy that of a membrane for any spacing of the nodes; they are 1 where the grid is square.
//
//         :   :   :   :   :        hi: each node slides along its line
//         o---o---o---o---o        nodes at rest, joined by springs
//      ___|___         ___|___     lo: the scene, which holds the outer ones
//             \_______/            a gap that the sheet bridges
struct SpringSheet {
    int rows = 0, columns = 0;             // node (i, j) has index i * columns + j
    std::vector<double> along, across;     // #rows, #columns: ascending positions, metres
    std::vector<glm::dvec3> p0, direction; // #nodes; unit directions
    std::vector<double> lo, hi;            // #nodes; infinite where there is nothing
    std::vector<char> on_edge; // #nodes or empty; 1: a fold there is intended and not rough
    double bending = 0;        // relative to the springs, >= 0
    double pull = 0; // toward s = 0, 1/square metre: a span of length pull^(-1/2) sags by a tenth

    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(j);
    }
    glm::dvec3 point(std::size_t k, const std::vector<double>& s) const
    {
        return p0[k] + s[k] * direction[k];
    }
};

// The equilibrium as an obstacle problem in which every node is free. O(#nodes).
ObstacleProblem spring_problem(const SpringSheet& sheet);

// The plain graph Laplacian of a grid, without obstacle.
ObstacleProblem grid_laplacian(int rows, int columns);

// The order in which nodes are relaxed; the factor below suits a grid of that size.
std::vector<int> red_black(int rows, int columns);
double over_relaxation(int rows, int columns);

struct RestOptions {
    double roughness_deg = 20; // angle between neighbouring faces
    int neighborhood = 3;      // grid steps round a rough node whose nodes are freed
    bool free_ends = false;    // the first and the last row may move
    double tolerance = 1e-6;   // of s, metres
    int most_sweeps = 4000;
};

struct RestShape {
    std::vector<double> s;
    std::vector<char> loose; // nodes that were free to move
    int sweeps = 0;
    double residual = 0;
};

// The nodes around which two faces differ by more than the angle.
std::vector<char> rough_nodes(const SpringSheet& sheet, const std::vector<double>& s,
                              double roughness_deg);

// Frees the neighbourhoods of rough nodes, finds their rest shape, and repeats this where the sheet
// has become rough, until no new node is rough. Nodes are only ever added, so it ends. Schein 2006,
// 2.3.2.
//   s        #nodes: the start, lo <= s <= hi
RestShape rest_shape(const SpringSheet& sheet, std::vector<double> s, const RestOptions& options);

} // namespace trivar
