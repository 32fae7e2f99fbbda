// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <optional>

namespace trivar {

// An Adjacency holds the edges of a mesh, and the faces round each edge and each point. An edge
// joins two points of the surface, so both sides of a seam are one edge. A side is the piece of a
// face's outline from one corner to the next, and has the number of the corner at which it begins:
// the sides of an edge tell which faces are round it. Cost: O(#C log valence); the same result for
// any number of threads.
class Adjacency {
public:
    enum class Ends { points, vertices }; // with vertices, the two sides of a seam are two edges

    explicit Adjacency(const Mesh& mesh, Ends ends = Ends::points);
    // Takes faces without a mesh: `corner_points` holds the point of each corner, all below
    // `points`. Without `face_begin` every three corners are a face.
    Adjacency(std::vector<std::uint32_t> corner_points, std::size_t points,
              std::span<const std::uint32_t> face_begin = {});

    std::size_t point_count() const { return round_begin_.size() - 1; }
    std::size_t edge_count() const { return edges_.size(); }

    // The ends of the edges, x <= y, in ascending order. They are equal only where a face repeats a
    // point.
    std::span<const glm::uvec2> edges() const { return edges_; }
    std::uint32_t edge_at(std::uint32_t side) const { return edge_of_side_[side]; }
    // The sides of an edge in ascending order, and so in the order of their faces.
    std::span<const std::uint32_t> sides(std::size_t edge) const
    {
        return {sides_.data() + sides_begin_[edge], sides_.data() + sides_begin_[edge + 1]};
    }
    // The corners of faces at a point, in ascending order.
    std::span<const std::uint32_t> corners(std::size_t point) const
    {
        return {round_.data() + round_begin_[point], round_.data() + round_begin_[point + 1]};
    }

    std::uint32_t face(std::uint32_t corner) const
    {
        return face_of_.empty() ? corner / 3 : face_of_[corner];
    }
    std::uint32_t point(std::uint32_t corner) const { return points_[corner]; }
    std::uint32_t next(std::uint32_t corner) const // of the same face
    {
        if (face_of_.empty()) return corner % 3 == 2 ? corner - 2 : corner + 1;
        const std::uint32_t f = face_of_[corner];
        return corner + 1 < face_begin_[f + 1] ? corner + 1 : face_begin_[f];
    }
    std::uint32_t previous(std::uint32_t corner) const
    {
        if (face_of_.empty()) return corner % 3 == 0 ? corner + 2 : corner - 1;
        const std::uint32_t f = face_of_[corner];
        return corner > face_begin_[f] ? corner - 1 : face_begin_[f + 1] - 1;
    }
    // whether the side runs from the smaller point to the larger one
    bool upward(std::uint32_t side) const { return points_[side] == edges_[edge_of_side_[side]].x; }

    std::optional<std::uint32_t> edge_between(std::uint32_t p, std::uint32_t q) const;
    bool is_border(std::size_t edge) const { return sides(edge).size() == 1; }
    bool has_border() const;
    // Whether an edge has exactly two faces, which run along it in opposite directions.
    bool is_manifold(std::size_t edge) const;
    // Whether along every edge as many faces run one way as the other. False where there are no
    // faces.
    bool is_closed() const;

private:
    void take_rounds(std::size_t points);
    void take_edges();

    std::vector<std::uint32_t> points_;               // #C
    std::vector<std::uint32_t> face_begin_, face_of_; // #F + 1, #C; empty: triangles
    std::vector<std::uint32_t> round_begin_, round_;  // #P + 1, #C
    std::vector<glm::uvec2> edges_;
    std::vector<std::uint32_t> sides_begin_, sides_, edge_of_side_; // #E + 1, #C, #C
};

} // namespace trivar
