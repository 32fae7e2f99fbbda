// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/fine_triangles.h"

#include "core/split/edge_numbers.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::uint32_t no_triangle = 0xffffffff;
constexpr std::size_t most_flat_points = 1000000;
constexpr double much = 0.5;            // of what is allowed: less coarse edges are not halved
constexpr double least_slimness = 2e-3; // of triangles, where an edge is turned over
constexpr double no_slimness = 1e-7;    // of triangles that rounding may turn round
constexpr double taken = 0.3;           // of an edge, from its middle: a corner of a flat triangle
constexpr double least_gain = 0.99;     // of coarseness, where an edge is turned over

double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Triangles that know their neighbours.
class LinkedTriangles {
public:
    LinkedTriangles(FlatTriangles& triangles, const Coarseness& coarseness, double shortest)
        : points_(triangles.points),
          corners_(triangles.corners),
          coarseness_(coarseness),
          shortest_(shortest)
    {
        link();
    }
    void refine()
    {
        find_coarse_rim();
        for (std::uint32_t t = 0; t < corners_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) turn_later(t, i);
        turn_all();
        for (std::uint32_t t = 0; t < corners_.size(); ++t) open_.push_back({t, corners_[t]});
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const Open each = open_[k];
            while (corners_[each.triangle] == each.corners && points_.size() < most_flat_points) {
                const std::size_t i = edge_to_halve(each.triangle);
                if (i == 3) break;
                const Side side = coarsest_beyond({each.triangle, i});
                halve(side.triangle, side.edge);
                turn_all();
            }
        }
    }

private:
    struct Open {
        std::uint32_t triangle;
        std::array<std::uint32_t, 3> corners; // it has, unless it was changed since
    };
    struct Side {
        std::uint32_t triangle;
        std::size_t edge;
    };
    struct CoarseEdge {
        glm::dvec2 middle;
        double length, coarse;
    };

    void link()
    {
        neighbours_.assign(corners_.size(), {no_triangle, no_triangle, no_triangle});
        EdgeNumbers edges(3 * corners_.size() / 2);
        std::vector<Side> first;
        first.reserve(2 * corners_.size());
        for (std::uint32_t t = 0; t < corners_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t e = edges.add(corners_[t][i], corners_[t][(i + 1) % 3]);
                if (e == first.size()) {
                    first.push_back({t, i});
                    continue;
                }
                neighbours_[t][i] = first[e].triangle;
                neighbours_[first[e].triangle][first[e].edge] = t;
            }
    }
    std::array<glm::dvec2, 3> places(std::uint32_t t) const
    {
        return {points_[corners_[t][0]], points_[corners_[t][1]], points_[corners_[t][2]]};
    }
    double coarseness(std::uint32_t a, std::uint32_t b) const
    {
        return coarseness_({points_[a], points_[b], points_[b]}).edges[0];
    }
    double length(std::uint32_t t, std::size_t i) const
    {
        return glm::distance(points_[corners_[t][i]], points_[corners_[t][(i + 1) % 3]]);
    }
    // Edges of the rim stay as coarse as they are, so others near one may be as coarse: the two
    // that end with it cannot be shorter than half of it.
    void find_coarse_rim()
    {
        for (std::uint32_t t = 0; t < corners_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                if (neighbours_[t][i] == no_triangle && coarseness(Side{t, i}) > 1)
                    coarse_rim_.push_back({middle(t, i), length(t, i), coarseness(Side{t, i})});
    }
    bool may_be_halved(const Side& side, double coarse) const
    {
        if (neighbours_[side.triangle][side.edge] == no_triangle ||
            length(side.triangle, side.edge) <= shortest_)
            return false;
        const glm::dvec2 at = middle(side.triangle, side.edge);
        // In triangles without area a corner may be there already, or nearly so
        const double near = taken * length(side.triangle, side.edge);
        const auto is_taken = [&](const Side& of) {
            const auto& [a, b, c] = corners_[of.triangle];
            return glm::distance(at, apex(of)) <= near && slimness(a, b, c) <= no_slimness;
        };
        if (is_taken(side) || is_taken(beyond(side))) return false;
        return std::ranges::none_of(coarse_rim_, [&](const CoarseEdge& each) {
            return coarse <= each.coarse && glm::distance(at, each.middle) <= 0.75 * each.length;
        });
    }
    const glm::dvec2& apex(const Side& side) const
    {
        return points_[corners_[side.triangle][(side.edge + 2) % 3]];
    }
    // The same edge of the neighbour, which must be there.
    Side beyond(const Side& side) const
    {
        const std::uint32_t other = neighbours_[side.triangle][side.edge];
        return {other, edge_between(other, corners_[side.triangle][(side.edge + 1) % 3])};
    }
    glm::dvec2 middle(std::uint32_t t, std::size_t i) const
    {
        return (points_[corners_[t][i]] + points_[corners_[t][(i + 1) % 3]]) / 2.0;
    }
    // Its edge that is to be halved; 3: none.
    std::size_t edge_to_halve(std::uint32_t t) const
    {
        const auto [coarse, whole] = coarseness_(places(t));
        if (whole <= 1) return 3;
        std::size_t worst = 3;
        for (std::size_t i = 0; i < 3; ++i)
            if (coarse[i] > much && (worst == 3 || coarse[i] > coarse[worst]) &&
                may_be_halved({t, i}, coarse[i]))
                worst = i;
        if (worst < 3) return worst;
        // An edge of the rim may do in a triangle that is flatter
        const std::array<glm::dvec2, 3> p = places(t);
        for (std::size_t i = 0; i < 3; ++i) {
            if (coarse[i] <= 1 || neighbours_[t][i] != no_triangle || coarseness(Side{t, i}) > 1 ||
                turn_of(p[0], p[1], p[2]) <= shortest_ * length(t, i))
                continue;
            for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3})
                if (neighbours_[t][j] != no_triangle && length(t, j) > shortest_ &&
                    (worst == 3 || length(t, j) > length(t, worst)))
                    worst = j;
            return worst;
        }
        return 3;
    }
    double coarseness(const Side& side) const
    {
        return coarseness(corners_[side.triangle][side.edge],
                          corners_[side.triangle][(side.edge + 1) % 3]);
    }
    // Goes across edges to coarser ones as long as there are such: where the coarser edge of two
    // triangles is halved first, few are. [Rivara, New longest-edge algorithms, 1997]
    Side coarsest_beyond(Side side) const
    {
        double most = coarseness(side);
        for (bool changed = true; changed;) {
            changed = false;
            const std::uint32_t other = neighbours_[side.triangle][side.edge];
            for (std::size_t j = 0; j < 3; ++j) {
                if (neighbours_[other][j] == side.triangle) continue;
                const double own = coarseness(Side{other, j});
                if (least_gain * own <= most || !may_be_halved({other, j}, own)) continue;
                most = own;
                side = {other, j};
                changed = true;
                break;
            }
        }
        return side;
    }
    std::size_t side_of(std::uint32_t t, std::uint32_t neighbour) const
    {
        std::size_t i = 0;
        while (i < 2 && neighbours_[t][i] != neighbour) ++i;
        return i;
    }
    void change_neighbour(std::uint32_t t, std::uint32_t from, std::uint32_t to)
    {
        if (t != no_triangle) neighbours_[t][side_of(t, from)] = to;
    }
    void set(std::uint32_t t, const std::array<std::uint32_t, 3>& corners,
             const std::array<std::uint32_t, 3>& neighbours)
    {
        corners_[t] = corners;
        neighbours_[t] = neighbours;
        open_.push_back({t, corners});
    }
    void halve(std::uint32_t t, std::size_t i)
    {
        const std::uint32_t other = neighbours_[t][i];
        const std::size_t j = edge_between(other, corners_[t][(i + 1) % 3]);
        const std::uint32_t a = corners_[t][i], b = corners_[t][(i + 1) % 3],
                            c = corners_[t][(i + 2) % 3], d = corners_[other][(j + 2) % 3];
        const std::uint32_t bc = neighbours_[t][(i + 1) % 3], ca = neighbours_[t][(i + 2) % 3];
        const std::uint32_t ad = neighbours_[other][(j + 1) % 3],
                            db = neighbours_[other][(j + 2) % 3];
        const auto m = static_cast<std::uint32_t>(points_.size());
        points_.push_back((points_[a] + points_[b]) / 2.0);
        const auto t2 = static_cast<std::uint32_t>(corners_.size()), other2 = t2 + 1;
        corners_.resize(corners_.size() + 2);
        neighbours_.resize(corners_.size());
        set(t, {a, m, c}, {other2, t2, ca});
        set(t2, {m, b, c}, {other, bc, t});
        set(other, {b, m, d}, {t2, other2, db});
        set(other2, {m, a, d}, {t, ad, other});
        change_neighbour(bc, t, t2);
        change_neighbour(ad, other, other2);
        turn_later(t, 2);
        turn_later(t2, 1);
        turn_later(other, 2);
        turn_later(other2, 1);
    }
    // The edge of a triangle that begins at a corner.
    std::size_t edge_between(std::uint32_t t, std::uint32_t corner) const
    {
        std::size_t j = 0;
        while (j < 2 && corners_[t][j] != corner) ++j;
        return j;
    }
    void turn_later(std::uint32_t t, std::size_t i)
    {
        if (neighbours_[t][i] != no_triangle)
            turns_.push_back({t, corners_[t][i], corners_[t][(i + 1) % 3]});
    }
    void turn_all()
    {
        while (!turns_.empty()) {
            const Turn each = turns_.back();
            turns_.pop_back();
            const std::size_t i = edge_between(each.triangle, each.from);
            if (corners_[each.triangle][i] != each.from ||
                corners_[each.triangle][(i + 1) % 3] != each.to)
                continue;
            turn(each.triangle, i);
        }
    }
    // The height of a triangle over its longest edge, by that edge.
    double slimness(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        const glm::dvec2 &p = points_[a], &q = points_[b], &r = points_[c];
        const double longest =
            std::max({glm::dot(q - p, q - p), glm::dot(r - q, r - q), glm::dot(p - r, p - r)});
        return turn_of(p, q, r) / std::max(longest, 1e-300);
    }
    // Gives two triangles the other diagonal, where that is less coarse.
    void turn(std::uint32_t t, std::size_t i)
    {
        const std::uint32_t other = neighbours_[t][i];
        if (other == no_triangle) return;
        const std::size_t j = edge_between(other, corners_[t][(i + 1) % 3]);
        const std::uint32_t a = corners_[t][i], b = corners_[t][(i + 1) % 3],
                            c = corners_[t][(i + 2) % 3], d = corners_[other][(j + 2) % 3];
        const double now = std::min(slimness(a, b, c), slimness(b, a, d)),
                     then = std::min(slimness(a, d, c), slimness(d, b, c));
        const bool line = now <= no_slimness; // then one is as good as another
        if (line ? then <= 0 : then < std::min(least_slimness, now) || then <= no_slimness) return;
        if (coarseness(c, d) >= least_gain * coarseness(a, b)) return;
        const std::uint32_t bc = neighbours_[t][(i + 1) % 3], ca = neighbours_[t][(i + 2) % 3];
        const std::uint32_t ad = neighbours_[other][(j + 1) % 3],
                            db = neighbours_[other][(j + 2) % 3];
        // A point of three triangles stays inside them
        if ((ca != no_triangle && ca == ad) || (bc != no_triangle && bc == db)) return;
        set(t, {a, d, c}, {ad, other, ca});
        set(other, {d, b, c}, {db, bc, t});
        change_neighbour(bc, t, other);
        change_neighbour(ad, other, t);
        turn_later(t, 0);
        turn_later(t, 2);
        turn_later(other, 0);
        turn_later(other, 1);
    }

    struct Turn { // an edge of a triangle, if it has it still
        std::uint32_t triangle, from, to;
    };
    std::vector<glm::dvec2>& points_;
    std::vector<std::array<std::uint32_t, 3>>& corners_;
    std::vector<std::array<std::uint32_t, 3>> neighbours_; // across the edge from corner i
    const Coarseness& coarseness_;
    double shortest_;
    std::vector<CoarseEdge> coarse_rim_; // those edges of one triangle that are too coarse
    std::vector<Open> open_;
    std::vector<Turn> turns_;
};

} // namespace

void make_fine_enough(FlatTriangles& triangles, const Coarseness& coarseness, double shortest)
{
    LinkedTriangles(triangles, coarseness, shortest).refine();
}

} // namespace trivar
