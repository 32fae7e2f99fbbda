// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/frame.h"

#include <vector>

namespace trivar::gpu {

// A piece of a line as line.vert takes it. Points in scene space.
struct Segment {
    glm::vec3 before, from, to, after; // at an end of the line the point before it is its first one
    glm::vec4 color_from, color_to;    // linear, a coverage
    glm::vec4 along;                   // at both ends: arc length in pixels, share of the length
    glm::vec4 width_taper;             // width in pixels, or in world units; CurveStyle::taper
    std::uint32_t id, hidden;          // HiddenParts
};

// What one picture draws of lines at most; it takes half a GB of the card's memory.
inline constexpr std::size_t most_segments = 4'000'000;

// The segments of lines in a picture; `frame` is without a sample's shift. Widths in pixels are
// times `scale`. Parts of a line with a point that is not finite are left out.
class Segments {
public:
    Segments(const Frame& frame, const glm::dvec3& origin_world, double scale)
        : frame_(frame),
          origin_world_(origin_world),
          scale_(static_cast<float>(scale))
    {
    }
    void add(const Line& line);
    void add(const Curve& curve);
    const std::vector<Segment>& all() const { return all_; }
    std::size_t left_out() const { return left_out_; } // for which there was no room

private:
    void add(const Polyline& line, const glm::dmat4& to_world, const CurveStyle& style, int id);
    const Frame& frame_;
    glm::dvec3 origin_world_;
    float scale_;
    std::vector<Segment> all_;
    std::size_t left_out_ = 0;
};

} // namespace trivar::gpu
