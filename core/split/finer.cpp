// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/finer.h"

#include "core/base/parallel.h"
#include "core/refinement/born_vertices.h"
#include "core/split/edge_numbers.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace trivar {
namespace {

constexpr int most_rounds = 16;
constexpr std::size_t triangles_per_block = 1 << 12, vertices_per_turn = 1 << 12;

// An edge between two vertices; that with the smaller point is the first.
struct VertexEdge {
    std::uint32_t a, b;
};

Mesh as_triangles(Mesh mesh)
{
    if (mesh.corners.size() == 3 * mesh.face_count()) return mesh;
    const std::vector<glm::uvec3> all = triangles(mesh);
    Mesh out;
    std::swap(out, mesh); // whose faces are needed still
    mesh.face_begin = out.face_begin;
    mesh.face_material = out.face_material;
    mesh.face_group = out.face_group;
    out.corners.clear();
    out.corners.reserve(3 * all.size());
    out.face_begin = {0};
    out.face_begin.reserve(all.size() + 1);
    out.face_material.clear();
    out.face_group.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t t = mesh.face_begin[f] - 2 * f; t < mesh.face_begin[f + 1] - 2 * (f + 1);
             ++t) {
            add_face(out, std::array{all[t].x, all[t].y, all[t].z});
            if (!mesh.face_material.empty()) out.face_material.push_back(mesh.face_material[f]);
            if (!mesh.face_group.empty()) out.face_group.push_back(mesh.face_group[f]);
        }
    return out;
}

// Splits triangles round by round.
class Rounds {
public:
    Rounds(Mesh mesh, const SplitField& field, const SplitError& error, double tolerance)
        : mesh_(std::move(mesh)),
          field_(field),
          error_(error),
          tolerance_(tolerance)
    {
        points_ = point_count(mesh_);
        take_places(0);
        open_.resize(mesh_.face_count());
        std::iota(open_.begin(), open_.end(), 0u);
    }
    // Returns whether any edge is to be split.
    bool mark()
    {
        std::vector<std::vector<VertexEdge>> found(open_.size() / triangles_per_block + 1);
        std::vector<double> most(found.size(), 0);
        const Box reach = field_.reach();
        const std::size_t openings = field_.openings.size();
        parallel_blocks(open_.size(), triangles_per_block, [&](std::size_t begin, std::size_t end) {
            std::vector<VertexEdge>& out = found[begin / triangles_per_block];
            double worst = 0;
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t f = open_[k];
                const std::array<glm::dvec3, 3> p{uvw_[corner(f, 0)], uvw_[corner(f, 1)],
                                                  uvw_[corner(f, 2)]};
                Box box;
                for (const glm::dvec3& each : p) box.add(each);
                if (box.apart(reach)) continue;
                const std::array<double, 3> off = error_.edges(
                    p, {&heights_[openings * corner(f, 0)], &heights_[openings * corner(f, 1)],
                        &heights_[openings * corner(f, 2)]});
                worst = std::max({worst, off[0], off[1], off[2]});
                for (std::size_t i = 0; i < 3; ++i)
                    if (off[i] > tolerance_) out.push_back(ordered(corner(f, i), corner(f, i + 1)));
            }
            most[begin / triangles_per_block] = worst;
        });
        // Those that are not open any more are within the tolerance
        off_ = std::ranges::max(most);
        fine_off_ = std::max(fine_off_, std::min(off_, tolerance_));
        std::size_t about = 0;
        for (const std::vector<VertexEdge>& each : found) about += each.size();
        if (about == 0) return false;
        marked_ = EdgeNumbers(about);
        touched_.assign(mesh_.vertex_count(), 0);
        for (const std::vector<VertexEdge>& each : found)
            for (const VertexEdge& e : each) {
                const std::uint32_t a = mesh_.point(e.a), b = mesh_.point(e.b);
                marked_.add(a, b);
                touched_[a] = touched_[b] = 1;
            }
        return true;
    }
    void split()
    {
        std::vector<Split> splits = splits_of_marked();
        // By edge of points, the first edge of vertices on it; others are on seams
        std::vector<std::uint32_t> first_born(marked_.count(), EdgeNumbers::none);
        EdgeNumbers others(16);
        std::vector<std::uint32_t> born_of_other;
        std::vector<BornVertex> born;
        born.reserve(marked_.count() + 64);
        const auto first_point = static_cast<std::uint32_t>(points_);
        std::size_t more = 0;
        for (Split& each : splits)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t marked = each.middles[i];
                if (marked == EdgeNumbers::none) continue;
                ++more;
                const VertexEdge e = ordered(corner(each.face, i), corner(each.face, i + 1));
                const auto next = static_cast<std::uint32_t>(born.size());
                std::uint32_t* known = &first_born[marked];
                if (*known != EdgeNumbers::none &&
                    (born[*known].a != e.a || born[*known].b != e.b)) {
                    const std::uint32_t other = others.add(e.a, e.b);
                    if (other == born_of_other.size()) born_of_other.push_back(EdgeNumbers::none);
                    known = &born_of_other[other];
                }
                if (*known == EdgeNumbers::none) {
                    *known = next;
                    born.push_back({e.a, e.b, 0.5f, first_point + marked});
                }
                each.middles[i] = *known;
            }
        const auto first_vertex = static_cast<std::uint32_t>(mesh_.vertex_count());
        add_vertices(mesh_, born);
        points_ += marked_.count();
        take_places(first_vertex);
        open_.clear();
        open_.reserve(splits.size() + more);
        for (const Split& each : splits) put_parts(each, first_vertex);
    }
    FineMesh take() { return {std::move(mesh_), std::move(heights_), std::max(off_, fine_off_)}; }
    std::size_t triangle_count() const { return mesh_.face_count(); }

private:
    struct Split {
        std::uint32_t face;
        std::array<std::uint32_t, 3> middles; // by edge, among those that are split
    };
    // The triangles with marked edges, and the numbers of these.
    std::vector<Split> splits_of_marked() const
    {
        std::vector<std::vector<Split>> found(mesh_.face_count() / triangles_per_block + 1);
        parallel_blocks(
            mesh_.face_count(), triangles_per_block, [&](std::size_t begin, std::size_t end) {
                std::vector<Split>& out = found[begin / triangles_per_block];
                for (std::size_t f = begin; f < end; ++f) {
                    if (touched(f, 0) + touched(f, 1) + touched(f, 2) < 2) continue;
                    Split each{static_cast<std::uint32_t>(f), {}};
                    bool any = false;
                    for (std::size_t i = 0; i < 3; ++i) {
                        each.middles[i] = touched(f, i) && touched(f, i + 1)
                                              ? marked_.number(mesh_.point(corner(f, i)),
                                                               mesh_.point(corner(f, i + 1)))
                                              : EdgeNumbers::none;
                        any |= each.middles[i] != EdgeNumbers::none;
                    }
                    if (any) out.push_back(each);
                }
            });
        std::vector<Split> all;
        for (const std::vector<Split>& each : found)
            all.insert(all.end(), each.begin(), each.end());
        return all;
    }
    void put_parts(const Split& each, std::uint32_t first_vertex)
    {
        const std::size_t f = each.face;
        const auto split_at = [&](std::size_t i) {
            return each.middles[i % 3] != EdgeNumbers::none;
        };
        const auto middle = [&](std::size_t i) { return first_vertex + each.middles[i % 3]; };
        const int count = split_at(0) + split_at(1) + split_at(2);
        // Turned so that the split edges are the first ones
        std::size_t turn = 0;
        while (!split_at(turn) || (count == 2 && !split_at(turn + 1))) ++turn;
        const std::array<std::uint32_t, 3> c{corner(f, turn), corner(f, turn + 1),
                                             corner(f, turn + 2)};
        const std::uint32_t m0 = middle(turn);
        if (count == 1) {
            put(f, {c[0], m0, c[2]}, true);
            put(f, {m0, c[1], c[2]}, false);
            return;
        }
        const std::uint32_t m1 = middle(turn + 1);
        if (count == 2) {
            put(f, {m0, c[1], m1}, true);
            if (glm::distance(uvw_[m0], uvw_[c[2]]) < glm::distance(uvw_[c[0]], uvw_[m1])) {
                put(f, {m0, m1, c[2]}, false);
                put(f, {c[0], m0, c[2]}, false);
            } else {
                put(f, {c[0], m0, m1}, false);
                put(f, {c[0], m1, c[2]}, false);
            }
            return;
        }
        const std::uint32_t m2 = middle(turn + 2);
        put(f, {m0, m1, m2}, true);
        put(f, {c[0], m0, m2}, false);
        put(f, {m0, c[1], m1}, false);
        put(f, {m2, m1, c[2]}, false);
    }
    std::uint32_t corner(std::size_t f, std::size_t i) const
    {
        return mesh_.corners[3 * f + i % 3];
    }
    bool touched(std::size_t f, std::size_t i) const { return touched_[mesh_.point(corner(f, i))]; }
    VertexEdge ordered(std::uint32_t a, std::uint32_t b) const
    {
        return mesh_.point(a) < mesh_.point(b) ? VertexEdge{a, b} : VertexEdge{b, a};
    }
    void take_places(std::size_t first)
    {
        uvw_.resize(mesh_.vertex_count());
        parallel_blocks(uvw_.size() - first, vertices_per_turn,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t v = first + begin; v < first + end; ++v)
                                uvw_[v] = field_.frame.uvw(glm::dvec3(mesh_.positions[v]));
                        });
        add_heights(heights_, mesh_, field_);
    }
    // In place of triangle f, or as another one of the same face.
    void put(std::size_t f, const std::array<std::uint32_t, 3>& vertices, bool in_place)
    {
        if (in_place) {
            std::ranges::copy(vertices, mesh_.corners.begin() + static_cast<long>(3 * f));
            open_.push_back(static_cast<std::uint32_t>(f));
            return;
        }
        open_.push_back(static_cast<std::uint32_t>(mesh_.face_count()));
        add_face(mesh_, vertices);
        if (!mesh_.face_material.empty()) mesh_.face_material.push_back(mesh_.face_material[f]);
        if (!mesh_.face_group.empty()) mesh_.face_group.push_back(mesh_.face_group[f]);
    }

    Mesh mesh_;
    const SplitField& field_;
    const SplitError& error_;
    double tolerance_;
    std::vector<glm::dvec3> uvw_;     // #V
    std::vector<double> heights_;     // #V x #openings
    double off_ = 0;                  // of the last round
    double fine_off_ = 0;             // of triangles that were fine enough before
    std::vector<std::uint32_t> open_; // faces that are not yet known to be fine enough
    std::size_t points_ = 0;
    EdgeNumbers marked_;        // by points
    std::vector<char> touched_; // by point: ends of these
};

} // namespace

void add_heights(std::vector<double>& heights, const Mesh& mesh, const SplitField& field)
{
    const std::size_t openings = field.openings.size(), first = heights.size() / openings;
    heights.resize(openings * mesh.vertex_count());
    parallel_blocks(mesh.vertex_count() - first, vertices_per_turn,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t v = first + begin; v < first + end; ++v) {
                            const glm::dvec3 uvw = field.frame.uvw(glm::dvec3(mesh.positions[v]));
                            for (std::size_t i = 0; i < openings; ++i)
                                heights[openings * v + i] = field.openings[i].height(uvw);
                        }
                    });
}

FineMesh fine_enough(Mesh mesh, const SplitField& field, const SplitError& error, double tolerance,
                     std::size_t most_triangles)
{
    assert(mesh.points.size() == mesh.vertex_count());
    Rounds rounds(as_triangles(std::move(mesh)), field, error, tolerance);
    for (int round = 0; rounds.mark(); ++round) {
        if (round >= most_rounds || rounds.triangle_count() >= most_triangles) break;
        rounds.split();
    }
    return rounds.take();
}

} // namespace trivar
