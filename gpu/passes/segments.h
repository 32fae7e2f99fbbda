// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/frame.h"

#include <vector>

namespace trivar::gpu {

// A Segment is a piece of a line in the form that line.vert takes. Points are in scene space.
struct Segment {
    // The ends and their neighbours; at an end of the line, `before` or `after` is that end.
    glm::vec3 before, from, to, after;
    glm::vec4 color_from, color_to; // linear, with coverage
    glm::vec4 along;                // at both ends: arc length in pixels, share of the length
    glm::vec4 width_taper;          // width in pixels, or in world units; CurveStyle::taper
    glm::vec2 width_shares;         // Polyline::widths at both ends
    float dash_px, own_reach;       // CurveStyle::own_reach_world
    std::uint32_t id, hidden;       // HiddenParts; with as_ink_bit where CurveStyle::as_ink is
};

// The largest number of segments in one picture; they take half a GB of the card's memory.
inline constexpr std::size_t most_segments = 4'000'000;

// Segments are the pieces of all lines in a picture; `frame` must be without a sample's shift.
// Widths in pixels are multiplied by `scale`. Parts of a line with a point that is not finite are
// left out.
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
    std::size_t left_out() const { return left_out_; } // number for which there was no room

private:
    void add(const Polyline& line, const glm::dmat4& to_world, const CurveStyle& style, int id);
    const Frame& frame_;
    glm::dvec3 origin_world_;
    float scale_;
    std::vector<Segment> all_;
    std::size_t left_out_ = 0;
};

} // namespace trivar::gpu
