// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

namespace trivar {

// A Crease lowers the continuity of a spline of degree n across one face of its domain.
template <int S> struct Crease {
    std::array<int, S> face; // vertex numbers
    int depth = 0;     // greatest number of cloud knots of a function in its plane: n - 1 - depth
                       // derivatives stay continuous; n: a cut
    bool seam = false; // of depth n: no cut, but a seam
    bool operator==(const Crease&) const = default;
};

// A CloudShift moves knots of one vertex after the clouds were made: their distance from the vertex
// grows by a factor, then they move. Those that a crease holds in a plane stay in it.
template <int S> struct CloudShift {
    int vertex = 0;
    int knot = 0; // 1 .. degree; 0: all
    glm::vec<S, double> by{0};
    double factor = 1;
    bool operator==(const CloudShift&) const = default;
};

// The clouds of knots on the border of a domain are outside, so that the functions sum to 1 in all
// of the domain; or stacked on the vertex, so that control points lie on the border, too; or free,
// as inside, so that each function fades smoothly, and so does their sum at the end of the domain.
enum class CloudBorder { outside, stacked, free };

// A CloudStyle says how clouds of knots are made.
struct CloudStyle {
    double spread = 0.15; // distance from the vertex, as a share of its shortest edge; 0.01 .. 0.3
    CloudBorder border = CloudBorder::outside;
};

// A domain of those vertices and cells with clouds that do not cross:
//  - inside, in directions that differ from vertex to vertex, so that no knots but those asked for
//    lie in a plane and the spline has n - 1 continuous derivatives;
//  - on the border, to the outside of all faces there; where no direction is outside of all,
//    stacked on the vertex;
//  - at creases, in the planes of all creases at the vertex. A vertex on the rim of a crease keeps
//    its cloud: what is cut closes at its rim. The rim is where an odd number of creased faces
//    meet, but for the border.
// Clouds that would cross are drawn nearer until they do not; those that are shifted so that they
// cross are refused. Throws Rejected for vertices and cells that check() refuses. The same bits
// everywhere. O(number of cells).
template <int S>
SimplexDomain<S>
with_clouds(std::vector<glm::vec<S, double>> vertices, std::vector<std::array<int, S + 1>> cells,
            int degree, const CloudStyle& style = {}, const std::vector<Crease<S>>& creases = {},
            const std::vector<CloudShift<S>>& shifts = {});

} // namespace trivar
