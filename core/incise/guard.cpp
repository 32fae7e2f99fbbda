// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/guard.h"

#include "core/base/box.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_certain = 1e-14; // of the largest determinant with such edges
constexpr double cell_of_mean = 0.7;    // of the mean diagonal of boxes
constexpr std::array narrower{1.0, 0.7, 0.5, 0.35, 0.25, 0.12, 0.05, 0.02, 0.0}; // shares
constexpr std::size_t entries_per_block = 4096;

int side_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    const glm::dvec3 x = b - a, y = c - a, z = d - a;
    const double det = glm::dot(x, glm::cross(y, z));
    const auto size = [](const glm::dvec3& v) {
        return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    };
    const double bound = least_certain * size(x) * size(y) * size(z);
    return det > bound ? 1 : det < -bound ? -1 : 0;
}

using TriangleCorners = std::array<glm::dvec3, 3>;

// Whether the line from p to q, whose ends lie on those sides of a triangle's plane, goes through
// its inside.
bool goes_through(const glm::dvec3& p, const glm::dvec3& q, int side_p, int side_q,
                  const TriangleCorners& t)
{
    if (side_p * side_q >= 0) return false;
    const int u = side_of(p, q, t[0], t[1]);
    return u != 0 && u == side_of(p, q, t[1], t[2]) && u == side_of(p, q, t[2], t[0]);
}

// Whether a side of `t` goes through the inside of `other`; `common`: the corner of t that is one
// of the other's, or -1.
bool goes_through(const TriangleCorners& t, int common, const TriangleCorners& other)
{
    std::array<int, 3> side{};
    for (std::size_t i = 0; i < 3; ++i)
        side[i] = static_cast<int>(i) == common ? 0 : side_of(other[0], other[1], other[2], t[i]);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        if (goes_through(t[i], t[k], side[i], side[k], other)) return true;
    }
    return false;
}

class PiercingSearch {
public:
    PiercingSearch(const std::vector<glm::dvec3>& p, const std::vector<glm::uvec3>& triangles)
        : p_(p),
          triangles_(triangles)
    {
        double sizes = 0;
        Box all;
        for (const glm::uvec3& t : triangles) {
            Box box;
            for (int i = 0; i < 3; ++i) box.add(p[t[i]]);
            sizes += glm::length(box.size());
            all.add(box);
            boxes_.push_back(box);
        }
        origin_ = all.lo;
        const double most = glm::length(all.size()) / (1 << 19); // cells have 20 bits an axis
        cell_ = std::max(
            {sizes / static_cast<double>(std::max<std::size_t>(1, boxes_.size())), most, 1e-300});
    }

    std::vector<CutGuard::Pair> operator()()
    {
        enter_cells();
        std::vector<std::vector<CutGuard::Pair>> found(entries_.size() / entries_per_block + 1);
        parallel_blocks(entries_.size(), entries_per_block,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                                compare_with_next(i, found[begin / entries_per_block]);
                        });
        std::vector<CutGuard::Pair> all;
        for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
        std::ranges::sort(all);
        return all;
    }

private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    glm::u64vec3 cell_at(const glm::dvec3& x) const { return glm::u64vec3((x - origin_) / cell_); }
    static std::uint64_t key(const glm::u64vec3& c) { return c.x << 42 | c.y << 21 | c.z; }

    void enter_cells()
    {
        for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
            const glm::u64vec3 lo = cell_at(boxes_[t].lo), hi = cell_at(boxes_[t].hi);
            glm::u64vec3 c;
            for (c.x = lo.x; c.x <= hi.x; ++c.x)
                for (c.y = lo.y; c.y <= hi.y; ++c.y)
                    for (c.z = lo.z; c.z <= hi.z; ++c.z) entries_.push_back({key(c), t});
        }
        std::ranges::sort(entries_);
    }

    void compare_with_next(std::size_t i, std::vector<CutGuard::Pair>& found) const
    {
        for (std::size_t j = i + 1; j < entries_.size() && entries_[j].cell == entries_[i].cell;
             ++j) {
            const std::uint32_t s = entries_[i].triangle, t = entries_[j].triangle;
            if (boxes_[s].apart(boxes_[t])) continue;
            // A pair that meets in several cells is looked at in the first of them
            if (key(cell_at(glm::max(boxes_[s].lo, boxes_[t].lo))) != entries_[i].cell) continue;
            if (pierce(triangles_[s], triangles_[t]))
                found.push_back({std::min(s, t), std::max(s, t)});
        }
    }
    bool pierce(const glm::uvec3& s, const glm::uvec3& t) const
    {
        int common = 0, at_s = 0, at_t = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                if (s[i] == t[k]) {
                    ++common;
                    at_s = i;
                    at_t = k;
                }
        if (common > 1) return false;
        const TriangleCorners a{p_[s.x], p_[s.y], p_[s.z]}, b{p_[t.x], p_[t.y], p_[t.z]};
        return goes_through(a, common == 1 ? at_s : -1, b) ||
               goes_through(b, common == 1 ? at_t : -1, a);
    }

    const std::vector<glm::dvec3>& p_;
    const std::vector<glm::uvec3>& triangles_;
    std::vector<Box> boxes_;
    glm::dvec3 origin_{0};
    double cell_ = 1;
    std::vector<Entry> entries_;
};

} // namespace

CutGuard::CutGuard(const CutShape& shape)
{
    const CutSkin& skin = shape.drawing.skin();
    KeyNumbers local;
    std::vector<std::uint32_t> vertices;
    const auto number = [&](std::uint32_t vertex) {
        const auto [n, fresh] = local.number(vertex);
        if (fresh) {
            vertices.push_back(vertex);
            rest_.push_back(shape.rest_position(vertex));
        }
        return n;
    };
    for (std::size_t i = 0; i < shape.walls.skin.size(); ++i) {
        const auto& t = shape.walls.skin[i];
        if (!shape.left_out.patch_piece(i))
            triangles_.emplace_back(number(t[0]), number(t[1]), number(t[2]));
    }
    first_wall_ = triangles_.size();
    for (std::uint32_t i = 0; i < shape.walls.walls.size(); ++i) {
        const WallTriangle& t = shape.walls.walls[i];
        if (shape.left_out.wall(i)) continue;
        triangles_.emplace_back(number(t.corners[0].vertex), number(t.corners[1].vertex),
                                number(t.corners[2].vertex));
        walls_.push_back(i);
    }
    end_of_walls_ = triangles_.size();
    for (const CutTerm& term : shape.terms) {
        terms_.push_back(term);
        terms_.back().vertex = number(term.vertex);
        movers_.push_back({terms_.back().vertex, term.incision});
    }
    std::ranges::sort(movers_);
    movers_.erase(std::unique(movers_.begin(), movers_.end()), movers_.end());
    KeyNumbers taken; // triangles of the skin round all these vertices
    const std::size_t inner = vertices.size();
    for (std::size_t i = 0; i < inner; ++i) {
        if (vertices[i] >= skin.point_count()) continue;
        skin.around(vertices[i], [&](std::uint32_t side) {
            if (shape.patch.replaces(side / 3) || !taken.number(side / 3).second) return;
            if (std::ranges::binary_search(shape.left_out.skin, side / 3)) return;
            const glm::uvec3& t = skin.triangle(side / 3);
            triangles_.emplace_back(number(t.x), number(t.y), number(t.z));
        });
    }
}

std::vector<CutGuard::Pair> CutGuard::piercings(std::span<const double> shares) const
{
    std::vector<glm::dvec3> p = rest_;
    for (const CutTerm& term : terms_)
        p[term.vertex] += shares[term.incision] * glm::dvec3(term.move);
    return PiercingSearch(p, triangles_)();
}

std::vector<std::uint32_t> CutGuard::incisions_at(const Pair& pair) const
{
    std::vector<std::uint32_t> out;
    for (const std::uint32_t t : {pair.a, pair.b})
        for (int i = 0; i < 3; ++i)
            for (auto mover = std::ranges::lower_bound(movers_, Mover{triangles_[t][i], 0});
                 mover != movers_.end() && mover->vertex == triangles_[t][i]; ++mover)
                out.push_back(mover->incision);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<std::uint32_t> piercing_on_their_way(const CutShape& shape)
{
    const CutGuard guard(shape);
    std::vector<std::uint32_t> out;
    std::uint32_t most = 0;
    for (const CutRun& run : shape.runs) most = std::max(most, run.incision);
    for (const CutGuard::Pair& pair : guard.piercings(std::vector<double>(most + 1, 0.0)))
        for (const std::uint32_t t : {pair.a, pair.b}) {
            if (!guard.is_wall(t)) continue;
            const WallTriangle& wall = shape.walls.walls[guard.wall_number(t)];
            for (const SlitEdge::Pass& pass : shape.graph.edges[wall.corners[0].edge].passes) {
                const CutRun& run = shape.runs[shape.pieces[pass.piece].run];
                if (!run.has_floor()) out.push_back(run.incision);
            }
        }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<double> admissible_shares(const CutShape& shape, std::size_t incisions)
{
    const CutGuard guard(shape);
    std::vector<double> shares(incisions, 0.0);
    const std::vector<CutGuard::Pair> shut = guard.piercings(shares); // the model's own
    for (const CutGuard::Pair& pair : shut)
        if (guard.is_wall(pair.a) || guard.is_wall(pair.b)) return {};
    std::vector<std::size_t> step(incisions, 0); // of narrowing
    for (;;) {
        for (std::size_t k = 0; k < incisions; ++k) shares[k] = narrower[step[k]];
        std::vector<char> to_narrow(incisions, 0);
        for (const CutGuard::Pair& pair : guard.piercings(shares)) {
            if (std::ranges::binary_search(shut, pair)) continue;
            for (const std::uint32_t k : guard.incisions_at(pair)) to_narrow[k] = 1;
        }
        bool narrowed = false;
        for (std::size_t k = 0; k < incisions; ++k)
            if (to_narrow[k] && step[k] + 1 < narrower.size()) {
                ++step[k];
                narrowed = true;
            }
        if (!narrowed) return shares;
    }
}

} // namespace trivar
