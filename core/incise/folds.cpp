// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/folds.h"

#include <algorithm>

namespace trivar {
namespace {

using On = LatticePoint::On;

constexpr double least_area_left = 0.1;  // of a piece of skin
constexpr double least_side_share = 0.2; // between a new point and an end of the side
constexpr int least_steps = 12;          // of the lattice, from a new point to others and to cuts

// OpenSkin tests the part of the skin that moves when all cuts are fully open.
class OpenSkin {
public:
    explicit OpenSkin(const SlitShape& shape) : shape_(shape)
    {
        for (const SlitTerm& term : shape.terms) {
            const auto [n, fresh] = number_.number(term.vertex);
            if (fresh) {
                vertices_.push_back(term.vertex);
                moves_.emplace_back(0);
            }
            moves_[n] += glm::dvec3(term.move);
        }
    }

    // Calls visit(points, parent triangle) with the pieces of the skin that turn over.
    template <class Visit> void folded(const Visit& visit) const
    {
        const SlitSkin& skin = shape_.drawing.skin();
        for (std::size_t i = 0; i < shape_.walls.skin.size(); ++i) {
            const SkinTriangle& piece = shape_.patch.triangles[i];
            if (!shape_.left_out.patch_piece(i) && folds(piece.points, shape_.walls.skin[i]))
                visit(piece.points, piece.parent);
        }
        KeyNumbers taken;
        for (const std::uint32_t vertex : vertices_) {
            if (vertex >= skin.point_count()) continue;
            skin.around(vertex, [&](std::uint32_t side) {
                const std::uint32_t t = side / 3;
                if (shape_.patch.replaces(t) || !taken.number(t).second) return;
                const glm::uvec3& p = skin.triangle(t);
                const std::array<std::uint32_t, 3> points{p.x, p.y, p.z};
                if (folds(points, points)) visit(points, t);
            });
        }
    }

private:
    glm::dvec3 move(std::uint32_t vertex) const
    {
        const std::uint32_t n = number_.find(vertex);
        return n == KeyNumbers::none ? glm::dvec3(0) : moves_[n];
    }
    bool folds(const std::array<std::uint32_t, 3>& points,
               const std::array<std::uint32_t, 3>& vertices) const
    {
        std::array<glm::dvec3, 3> p{}, q{};
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = shape_.drawing.position(points[k]);
            q[k] = p[k] + move(vertices[k]);
        }
        const glm::dvec3 shut = glm::cross(p[1] - p[0], p[2] - p[0]);
        const glm::dvec3 open = glm::cross(q[1] - q[0], q[2] - q[0]);
        return glm::dot(shut, open) < least_area_left * glm::dot(shut, shut);
    }

    const SlitShape& shape_;
    KeyNumbers number_; // by vertex
    std::vector<std::uint32_t> vertices_;
    std::vector<glm::dvec3> moves_;
};

class FoldPoints {
public:
    explicit FoldPoints(const SlitShape& shape)
        : shape_(shape),
          drawing_(shape.drawing),
          skin_(shape.drawing.skin())
    {
        for (const SlitEdge& edge : shape.graph.edges) slits_.number(pair_key(edge.a, edge.b));
    }

    void halve(const std::array<std::uint32_t, 3>& points, std::uint32_t parent)
    {
        std::array<std::size_t, 3> order{0, 1, 2}; // of the sides, the longest first
        const auto length = [&](std::size_t k) {
            return glm::distance(drawing_.position(points[k]),
                                 drawing_.position(points[(k + 1) % 3]));
        };
        std::ranges::stable_sort(order, std::greater(), length);
        for (const std::size_t k : order) {
            const std::uint32_t a = points[k], b = points[(k + 1) % 3], c = points[(k + 2) % 3];
            const auto key = pair_key(std::min(a, b), std::max(a, b));
            if (slits_.contains(key)) continue;
            if (halved_.contains(key)) return;
            const auto at = between(a, b, c, parent);
            if (!at) continue;
            halved_.number(key);
            points_.push_back(*at);
            return;
        }
    }
    std::vector<LatticePoint> points() && { return std::move(points_); }

private:
    // The point of the side from a to b that is nearest to c, not too near to an end.
    std::optional<LatticePoint> between(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                        std::uint32_t parent) const
    {
        const glm::dvec3 p = drawing_.position(a), way = drawing_.position(b) - p;
        const double length2 = glm::dot(way, way);
        if (!(length2 > 0)) return {};
        const double share = std::clamp(glm::dot(drawing_.position(c) - p, way) / length2,
                                        least_side_share, 1 - least_side_share);
        const auto wa = weights_in(skin_, drawing_.point(a), parent);
        const auto wb = weights_in(skin_, drawing_.point(b), parent);
        if (!wa || !wb) return {};
        const glm::dvec2 w = (1 - share) * glm::dvec2(*wa) + share * glm::dvec2(*wb);
        const glm::ivec2 rounded(glm::round(w));
        const auto far = [&](const glm::ivec2& other) {
            return std::max({std::abs(rounded.x - other.x), std::abs(rounded.y - other.y),
                             std::abs(rounded.x + rounded.y - other.x - other.y)}) >= least_steps;
        };
        if (!far(*wa) || !far(*wb)) return {};
        const LatticePoint at = lattice_point(skin_, parent, rounded);
        if (at.on == On::point) return {};
        if (at.on == On::edge) {
            const std::uint32_t other = skin_.across(at.index);
            if (other == SlitSkin::none || !on_one_edge(*wa, *wb)) return {};
            return clear_of_cuts(at, parent) &&
                           clear_of_cuts(at, (at.index / 3 == parent ? other : at.index) / 3)
                       ? std::optional(at)
                       : std::nullopt;
        }
        return clear_of_cuts(at, parent) ? std::optional(at) : std::nullopt;
    }
    static bool on_one_edge(const glm::ivec2& a, const glm::ivec2& b)
    {
        return (a.x == 0 && b.x == 0) || (a.y == 0 && b.y == 0) ||
               (a.x + a.y == lattice_steps && b.x + b.y == lattice_steps);
    }
    // Whether no segment of the drawing in a triangle runs so near that it would take the point.
    bool clear_of_cuts(const LatticePoint& at, std::uint32_t triangle) const
    {
        const SlitDrawing::OnTriangle* on = drawing_.on_triangle(triangle);
        const auto place = weights_in(skin_, at, triangle);
        if (!on || !place) return place.has_value();
        const glm::dvec2 p(*place);
        for (const std::uint32_t s : on->segments) {
            const SlitDrawing::Segment& g = drawing_.segments()[s];
            const auto a = weights_in(skin_, drawing_.point(g.a), triangle);
            const auto b = weights_in(skin_, drawing_.point(g.b), triangle);
            if (!a || !b || g.a == g.b) continue;
            const glm::dvec2 d = glm::dvec2(*b) - glm::dvec2(*a), e = p - glm::dvec2(*a);
            const double t = std::clamp(glm::dot(d, e) / glm::dot(d, d), 0.0, 1.0);
            if (glm::length(e - t * d) < 2) return false;
        }
        for (const std::uint32_t other : on->points)
            if (const auto w = weights_in(skin_, drawing_.point(other), triangle);
                w && glm::distance(p, glm::dvec2(*w)) < 2)
                return false;
        return true;
    }

    const SlitShape& shape_;
    const SlitDrawing& drawing_;
    const SlitSkin& skin_;
    KeyNumbers slits_, halved_; // by ends
    std::vector<LatticePoint> points_;
};

} // namespace

std::vector<LatticePoint> points_against_folds(const SlitShape& shape)
{
    FoldPoints out(shape);
    OpenSkin(shape).folded([&](const std::array<std::uint32_t, 3>& points, std::uint32_t parent) {
        out.halve(points, parent);
    });
    return std::move(out).points();
}

} // namespace trivar
