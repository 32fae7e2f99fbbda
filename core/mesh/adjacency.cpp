// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t points_together = 1 << 13;

std::vector<std::uint32_t> ends_by_corner(const Mesh& mesh, Adjacency::Ends ends)
{
    std::vector<std::uint32_t> out = mesh.corners;
    if (ends == Adjacency::Ends::points && !mesh.points.empty())
        for (std::uint32_t& v : out) v = mesh.points[v];
    return out;
}

} // namespace

Adjacency::Adjacency(const Mesh& mesh, Ends ends)
    : Adjacency(ends_by_corner(mesh, ends),
                ends == Ends::points && mesh.vertex_count() > 0 ? trivar::point_count(mesh)
                                                                : mesh.vertex_count(),
                mesh.face_begin)
{
}

Adjacency::Adjacency(std::vector<std::uint32_t> corner_points, std::size_t points,
                     std::span<const std::uint32_t> face_begin)
    : points_(std::move(corner_points))
{
    const std::size_t faces = face_begin.empty() ? 0 : face_begin.size() - 1;
    bool triangles = face_begin.empty() || points_.size() == 3 * faces;
    for (std::size_t f = 0; f < faces && triangles; ++f) triangles = face_begin[f] == 3 * f;
    if (!triangles) {
        face_begin_.assign(face_begin.begin(), face_begin.end());
        face_of_.resize(points_.size());
        for (std::uint32_t f = 0; f < faces; ++f)
            std::fill(face_of_.begin() + face_begin[f], face_of_.begin() + face_begin[f + 1], f);
    }
    take_rounds(points);
    take_edges();
}

void Adjacency::take_rounds(std::size_t points)
{
    round_begin_.assign(points + 1, 0);
    for (const std::uint32_t p : points_) ++round_begin_[p + 1];
    for (std::size_t p = 0; p < points; ++p) round_begin_[p + 1] += round_begin_[p];
    round_.resize(points_.size());
    std::vector<std::uint32_t> free(round_begin_.begin(), round_begin_.end() - 1);
    for (std::uint32_t c = 0; c < points_.size(); ++c) round_[free[points_[c]]++] = c;
}

void Adjacency::take_edges()
{
    // The sides of an edge are stored with the smaller of its two points.
    const std::size_t points = point_count();
    std::vector<std::uint32_t> begin(points + 1, 0);
    const auto low = [&](std::uint32_t c) { return std::min(points_[c], points_[next(c)]); };
    for (std::uint32_t c = 0; c < points_.size(); ++c) ++begin[low(c) + 1];
    for (std::size_t p = 0; p < points; ++p) begin[p + 1] += begin[p];
    sides_.resize(points_.size());
    std::vector<std::size_t> first_edge((points + points_together - 1) / points_together + 1, 0);
    parallel_blocks(points, points_together, [&](std::size_t first, std::size_t last) {
        std::vector<std::uint64_t> round; // the other end of a side, and its corner
        std::size_t edges = 0;
        for (auto p = static_cast<std::uint32_t>(first); p < last; ++p) {
            round.clear();
            const auto add = [&](std::uint32_t end, std::uint32_t corner) {
                round.push_back(std::uint64_t{end} << 32 | corner);
            };
            for (const std::uint32_t c : corners(p)) {
                const std::uint32_t before = previous(c), ahead = points_[next(c)];
                if (ahead >= p) add(ahead, c);
                if (points_[before] > p) add(points_[before], before);
            }
            std::sort(round.begin(), round.end());
            for (std::size_t i = 0; i < round.size(); ++i) {
                sides_[begin[p] + i] = static_cast<std::uint32_t>(round[i]);
                edges += i == 0 || round[i] >> 32 != round[i - 1] >> 32;
            }
        }
        first_edge[first / points_together + 1] = edges;
    });
    for (std::size_t b = 0; b + 1 < first_edge.size(); ++b) first_edge[b + 1] += first_edge[b];
    edges_.resize(first_edge.back());
    sides_begin_.resize(edges_.size() + 1);
    sides_begin_.back() = static_cast<std::uint32_t>(points_.size());
    edge_of_side_.resize(points_.size());
    parallel_blocks(points, points_together, [&](std::size_t first, std::size_t last) {
        std::size_t made = first_edge[first / points_together];
        glm::uvec2 known(~0u);
        for (std::uint32_t i = begin[first]; i < begin[last]; ++i) {
            const std::uint32_t a = points_[sides_[i]], b = points_[next(sides_[i])];
            const glm::uvec2 ends(std::min(a, b), std::max(a, b));
            if (ends != known) {
                edges_[made] = known = ends;
                sides_begin_[made++] = i;
            }
            edge_of_side_[sides_[i]] = static_cast<std::uint32_t>(made - 1);
        }
    });
}

bool Adjacency::has_border() const
{
    for (std::size_t e = 0; e < edge_count(); ++e)
        if (is_border(e)) return true;
    return false;
}

std::optional<std::uint32_t> Adjacency::edge_between(std::uint32_t p, std::uint32_t q) const
{
    const glm::uvec2 ends(std::min(p, q), std::max(p, q));
    const auto found = std::ranges::lower_bound(edges_, ends, [](glm::uvec2 a, glm::uvec2 b) {
        return std::pair(a.x, a.y) < std::pair(b.x, b.y);
    });
    if (found == edges_.end() || *found != ends) return std::nullopt;
    return static_cast<std::uint32_t>(found - edges_.begin());
}

bool Adjacency::is_manifold(std::size_t edge) const
{
    const auto both = sides(edge);
    return both.size() == 2 && upward(both[0]) != upward(both[1]);
}

bool Adjacency::is_closed() const
{
    for (std::size_t e = 0; e < edge_count(); ++e) {
        std::ptrdiff_t balance = 0;
        for (const std::uint32_t side : sides(e)) balance += upward(side) ? 1 : -1;
        if (balance != 0) return false;
    }
    return edge_count() > 0;
}

} // namespace trivar
