// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/strip_layout.h"
#include "core/placement/view.h"

namespace trivar {

// Where in ascending places a value stands: between the first and the one after it.
struct Bracket {
    int first;
    double share;
};
Bracket bracket(const std::vector<double>& places, double at);

// The rays through a strip by the parameters of its nodes, and what lies between: linear.
class StripChart {
public:
    StripChart(const StripLayout& strip, const View& view); // both must outlive it
    Ray ray(glm::dvec2 uv) const;
    double value(const std::vector<double>& of_nodes, glm::dvec2 uv) const;
    const std::vector<double>& places(int axis) const // of the nodes
    {
        return places_[static_cast<std::size_t>(axis)];
    }
    double length(int axis) const { return axis == 0 ? strip_.length : strip_.width; }

private:
    const StripLayout& strip_;
    const View& view_;
    std::array<std::vector<double>, 2> places_;
};

// A point of an edge of the scene, met on a line of the strip.
struct CreasePoint {
    glm::dvec2 uv;
    glm::dvec3 p_world;
    int axis = 0;  // along which the line runs
    int line = -1; // which one of the grid, or as it was asked for; -1: between them
    std::array<Hit, 2> sides;
    bool ridge = true; // else the bottom of a valley
};

// Looks along the lines of the grid, and from the middles of cells that are not where their corners
// tell. An interval is halved, four times at most, while its ends differ by more than 25 degrees or
// in their object, or its middle lies off; where they still do, bisection finds the edge, and the
// planes of both sides the point on it. Cliffs, whose sides are not seen to meet, are none: springs
// and the lift see to them. Some rays a node, and some hundred an edge met.
std::vector<CreasePoint> crease_points(const StripChart& chart, const RayScene& scene,
                                       bool skip_back_faces);

// The same between two places each.
struct AskedCrease {
    glm::dvec2 from, to;
    int axis, line;
};
std::vector<CreasePoint> crease_points(const StripChart& chart,
                                       const std::vector<AskedCrease>& asked, const RayScene& scene,
                                       bool skip_back_faces);

} // namespace trivar
