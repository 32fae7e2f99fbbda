// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/strip_layout.h"
#include "core/placement/view.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// A Bracket says where a value stands among ascending places: between number `first` and the one
// after it.
struct Bracket {
    int first;
    double share;
};
Bracket bracket(const std::vector<double>& places, double at);

// A StripChart gives the rays through a strip by the parameters of its nodes, linear between nodes.
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

// A CreasePoint is a point of an edge of the scene that was found on a line of the strip.
struct CreasePoint {
    glm::dvec2 uv;
    glm::dvec3 p_world;
    int axis = 0; // along which the line runs
    // number of the line in the grid, or as given in AskedCrease; -1: a line between those of the
    // grid
    int line = -1;
    std::array<Hit, 2> sides;
    bool ridge = true; // false: the bottom of a valley
};

// Finds the edges of the scene along the lines of the grid, and from the middles of those cells
// that are not where their corners suggest. An interval is halved, at most four times, while its
// ends differ by more than 25 degrees or in their object, or while its middle lies off. If they
// still differ, bisection finds the edge, and the planes of both sides give the point on it. A
// cliff, whose sides are not seen to meet, is no crease: springs and the lift treat cliffs. Cost: a
// few rays per node and some hundred per edge found.
std::vector<CreasePoint> crease_points(const StripChart& chart, const RayScene& scene,
                                       bool skip_back_faces);

// An AskedCrease asks for the crease between two places.
struct AskedCrease {
    glm::dvec2 from, to;
    int axis, line;
};
std::vector<CreasePoint> crease_points(const StripChart& chart,
                                       const std::vector<AskedCrease>& asked, const RayScene& scene,
                                       bool skip_back_faces);

} // namespace trivar
