// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/key_numbers.h"
#include "core/incise/lattice_point.h"

namespace trivar {

// A DrawnChain is a stroke, or a part of one, as a chain of lattice points, each on one triangle
// with the next.
struct DrawnChain {
    std::vector<LatticePoint> points;
    std::vector<std::uint32_t> triangles; // between each point and the next
    double from = 0, to = 1;              // shares of the stroke's length that it covers
};

// A SlitDrawing is a graph of straight segments on a skin: all strokes of its cuts. Points have
// numbers: those of the skin their own, others from SlitSkin::point_count() on.
class SlitDrawing {
public:
    struct Segment {
        std::uint32_t a, b, stroke;
        double s_a, s_b; // lengths along the stroke
        std::uint32_t triangle;
    };
    struct OnTriangle {
        std::vector<std::uint32_t> segments, points; // points inside of it
    };
    struct OnEdge {
        int steps;
        std::uint32_t point;
        auto operator<=>(const OnEdge&) const = default;
    };

    explicit SlitDrawing(const SlitSkin& skin) : skin_(&skin) {}
    const SlitSkin& skin() const { return *skin_; }

    // Adds a chain as the next stroke and returns its number. Places that are none are left out.
    std::uint32_t add(const DrawnChain& chain);
    // Adds a point that is on no segment.
    void add(const LatticePoint& point) { number_of(point); }
    // Makes segments meet in points alone: where they cross there is a point then, and one that
    // runs through a point is two. In whole numbers, so that no case depends on rounding.
    // Throws Rejected where that finds no end.
    void arrange();

    std::uint32_t stroke_count() const { return strokes_; }
    double length(std::uint32_t stroke) const { return lengths_[stroke]; }
    const std::vector<Segment>& segments() const { return segments_; }
    std::size_t point_count() const { return skin_->point_count() + points_.size(); }
    LatticePoint point(std::uint32_t number) const;
    glm::dvec3 position(std::uint32_t number) const;
    // The triangles that have a point or a segment of the drawing inside or on a side, ascending.
    std::vector<std::uint32_t> touched() const;
    const OnTriangle* on_triangle(std::uint32_t t) const;
    // Returns the points on an edge in the order in which they came; null: none.
    const std::vector<OnEdge>* on_edge(std::uint32_t edge) const;

private:
    std::pair<std::uint32_t, bool> number_of(const LatticePoint& p); // and whether it is new
    OnTriangle& drawn_on(std::uint32_t t);
    void split(std::uint32_t segment, std::uint32_t point);
    struct Located;
    std::vector<Located> located(std::uint32_t t) const;
    bool split_at_points(std::uint32_t t);
    bool split_at_crossing(std::uint32_t t, std::vector<std::uint32_t>& others);

    const SlitSkin* skin_;
    std::vector<LatticePoint> points_; // by number from the skin's on
    std::vector<Segment> segments_;
    std::uint32_t strokes_ = 0;
    std::vector<double> lengths_;
    KeyNumbers number_of_key_, triangle_number_, edge_number_;
    std::vector<OnTriangle> triangles_;
    std::vector<std::uint32_t> drawn_triangles_;
    std::vector<std::vector<OnEdge>> edges_;
};

} // namespace trivar
