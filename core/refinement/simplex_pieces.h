// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/mistake.h"
#include "core/refinement/displacement_cells.h"

#include <algorithm>
#include <optional>

namespace trivar {

// A SimplexPiece is an edge (two corners) or a triangle (three) in parameter space, or a piece of
// one.
template <int corners> struct SimplexPiece {
    glm::ivec3 slabs{0};
    std::array<glm::dvec3, corners> weight; // barycentric place of each corner in the whole simplex
    std::array<glm::dvec3, corners> uvw;
};

// A CutSimplex is the convex part of a simplex between some knot planes.
template <int corners> class CutSimplex {
public:
    struct Corner {
        glm::dvec3 weight, uvw;
    };
    static CutSimplex of(const std::array<glm::dvec3, corners>& uvw)
    {
        CutSimplex out;
        for (int i = 0; i < corners; ++i) {
            glm::dvec3 weight(0);
            weight[i] = 1;
            out.add({weight, uvw[static_cast<std::size_t>(i)]});
        }
        return out;
    }
    bool empty() const { return count_ < corners; }
    double least(int axis) const { return std::min_element(begin(), end(), by(axis))->uvw[axis]; }
    double most(int axis) const { return std::max_element(begin(), end(), by(axis))->uvw[axis]; }

    // The part on one side (-1 below, 1 above) of a plane.
    CutSimplex part(int axis, double plane, int side) const
    {
        CutSimplex out;
        for (std::size_t i = 0; i < count_; ++i) {
            const Corner &a = corners_[i], &b = corners_[(i + 1) % count_];
            const double off_a = side * (a.uvw[axis] - plane), off_b = side * (b.uvw[axis] - plane);
            if (off_a >= 0) out.add(a);
            const bool last_of_edge = corners == 2 && i == 1;
            if (last_of_edge || !((off_a < 0 && off_b > 0) || (off_a > 0 && off_b < 0))) continue;
            const double t = off_a / (off_a - off_b);
            Corner cut{a.weight + t * (b.weight - a.weight), a.uvw + t * (b.uvw - a.uvw)};
            cut.uvw[axis] = plane;
            out.add(cut);
        }
        return out;
    }
    // Visits the part as simplices, in a fan.
    void each_simplex(auto&& visit) const
    {
        for (std::size_t i = corners - 1; i < count_; ++i)
            if constexpr (corners == 2)
                visit(std::array{corners_[i - 1], corners_[i]});
            else
                visit(std::array{corners_[0], corners_[i - 1], corners_[i]});
    }

private:
    static auto by(int axis)
    {
        return [axis](const Corner& a, const Corner& b) { return a.uvw[axis] < b.uvw[axis]; };
    }
    const Corner* begin() const { return corners_.data(); }
    const Corner* end() const { return corners_.data() + count_; }
    void add(const Corner& corner)
    {
        ensure(count_ < corners_.size(), "a piece of a triangle has more than twelve corners");
        corners_[count_++] = corner;
    }
    std::array<Corner, 12> corners_; // each of six planes adds at most one
    std::size_t count_ = 0;
};

// A Crossing says how smooth the map of a simplex is: one polynomial, across smooth knots, across
// kinks, or not even continuous.
struct Crossing {
    bool kink = false, jump = false;
};

// Calls visit(piece) for the pieces of a simplex between knot planes; each holds one polynomial.
template <int corners>
Crossing each_piece(const DisplacementCells& cells, const std::array<glm::dvec3, corners>& uvw,
                    auto&& visit)
{
    Crossing crossing;
    SimplexPiece<corners> piece;
    const auto along = [&](const auto& self, const CutSimplex<corners>& part, int a) -> void {
        if (a == 3) {
            part.each_simplex([&](const auto& simplex) {
                for (std::size_t i = 0; i < corners; ++i) {
                    piece.weight[i] = simplex[i].weight;
                    piece.uvw[i] = simplex[i].uvw;
                }
                visit(piece);
            });
            return;
        }
        const AxisSlabs& axis = cells.axis(a);
        const int first = axis.upper(part.least(a)),
                  last = std::max(first, axis.lower(part.most(a)));
        CutSimplex<corners> rest = part;
        for (int slab = first; slab <= last; ++slab) {
            piece.slabs[a] = slab;
            if (slab == last) {
                self(self, rest, a + 1);
                break;
            }
            crossing.kink |= axis.joint(slab) != AxisSlabs::Joint::smooth;
            crossing.jump |= axis.joint(slab) == AxisSlabs::Joint::jump;
            const CutSimplex<corners> below = rest.part(a, axis.end(slab), -1);
            if (!below.empty()) self(self, below, a + 1);
            piece.slabs[a] = slab + 1;
            rest = rest.part(a, axis.end(slab), 1);
            if (rest.empty()) break;
        }
    };
    along(along, CutSimplex<corners>::of(uvw), 0);
    return crossing;
}

} // namespace trivar
