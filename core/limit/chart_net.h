// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A ChartPlace is a point of a surface that is made of square charts.
struct ChartPlace {
    std::uint32_t chart = 0;
    glm::dvec2 uv{0}; // of the unit square
    bool operator==(const ChartPlace&) const = default;
};

// Corners and edges of the unit square are numbered so:
//
//      3 --- edge 2 --- 2
//      |                |        edge e runs from corner e to corner e + 1, the chart on its left
//    edge 3           edge 1
//      |                |
//      0 --- edge 0 --- 1
//
glm::dvec2 chart_corner(int corner);
glm::dvec2 along_edge(int edge);        // unit
glm::dvec2 out_of_edge(int edge);       // unit
glm::dvec2 on_edge(int edge, double t); // t from 0 at its first corner to 1; exact at both
// Turns a vector by quarter turns, counter-clockwise.
glm::dvec2 quarter_turned(const glm::dvec2& v, int turns);

// A ChartNet says how the charts of a surface hang together. Two charts that share an edge run
// along it in opposite directions; a turn by quarter turns and a shift lead beyond it. All other
// edges are borders.
class ChartNet {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    struct Side {
        std::uint32_t chart = none;
        int edge = 0;
        bool operator==(const Side&) const = default;
    };
    struct Chart {
        std::array<std::uint32_t, 4> points{}; // at the corners; equal numbers are one point
        std::array<Side, 4> across{};          // what lies behind each edge
        std::array<bool, 4> crease{};          // edges over which the surface has two normals
    };
    explicit ChartNet(std::vector<Chart> charts) : charts_(std::move(charts)) {}
    // Joins charts where they have the same two points; `corners` holds four points a chart.
    // Edges of other than two charts that run along them in opposite directions are borders.
    // O(#charts log #charts).
    ChartNet(std::span<const int> corners, std::span<const int> crease_ends);

    std::size_t size() const { return charts_.size(); }
    const Chart& chart(std::uint32_t c) const { return charts_[c]; }
    const Side& across(std::uint32_t c, int edge) const
    {
        return charts_[c].across[static_cast<std::size_t>(edge)];
    }
    bool is_crease(std::uint32_t c, int edge) const
    {
        return charts_[c].crease[static_cast<std::size_t>(edge)];
    }
    std::uint32_t point(std::uint32_t c, int corner) const
    {
        return charts_[c].points[static_cast<std::size_t>(corner & 3)];
    }

    // Gives a place on an edge in the coordinates of the chart behind it. Not at a border.
    ChartPlace beyond(const ChartPlace& at, int edge) const;

    struct Walk {
        ChartPlace at;
        glm::dvec2 step{0}; // as the last chart has it
        double left = 0;    // share of the step that was not made
        int edge = -1;      // on which it was stopped; -1: it was not
        int turns = 0;      // quarter turns of directions from the first chart to the last
    };
    // Goes straight in the coordinates of the charts. It stops exactly on a border; also on a
    // crease if `over_creases` is false. O(#edges crossed), at most 256 of them.
    Walk walk(const ChartPlace& from, const glm::dvec2& step, bool over_creases = true) const;

private:
    std::vector<Chart> charts_;
};

} // namespace trivar
