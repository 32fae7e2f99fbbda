// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/finer.h"

#include "core/base/parallel.h"
#include "core/refinement/born_vertices.h"
#include "core/split/edge_numbers.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

constexpr int most_rounds = 16;
constexpr std::size_t triangles_per_block = 1 << 12, vertices_per_turn = 1 << 12;

// An edge between two vertices; that with the smaller point is the first.
struct VertexEdge {
    std::uint32_t a, b;
};

Mesh as_triangles(const Mesh& mesh)
{
    if (mesh.corners.size() == 3 * mesh.face_count()) return mesh;
    Mesh out = mesh;
    const std::vector<glm::uvec3> all = triangles(mesh);
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
        take_places(0);
        open_.resize(mesh_.face_count(), 1);
    }
    // Returns whether any edge is to be split.
    bool mark()
    {
        const std::size_t faces = mesh_.face_count();
        std::vector<std::vector<VertexEdge>> found(faces / triangles_per_block + 1);
        std::vector<double> most(found.size(), 0);
        const Box reach = field_.reach();
        const std::size_t openings = field_.openings.size();
        parallel_blocks(faces, triangles_per_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                if (!open_[f]) continue;
                const std::array<glm::dvec3, 3> p{uvw_[corner(f, 0)], uvw_[corner(f, 1)],
                                                  uvw_[corner(f, 2)]};
                Box box;
                for (const glm::dvec3& each : p) box.add(each);
                open_[f] = 0;
                if (box.apart(reach)) continue;
                const std::array<double, 3> off = error_.edges(
                    p, {&heights_[openings * corner(f, 0)], &heights_[openings * corner(f, 1)],
                        &heights_[openings * corner(f, 2)]});
                double& worst = most[begin / triangles_per_block];
                worst = std::max({worst, off[0], off[1], off[2]});
                for (std::size_t i = 0; i < 3; ++i)
                    if (off[i] > tolerance_)
                        found[begin / triangles_per_block].push_back(
                            ordered(corner(f, i), corner(f, (i + 1) % 3)));
            }
        });
        // Those that are not open any more are within the tolerance
        off_ = std::ranges::max(most);
        fine_off_ = std::max(fine_off_, std::min(off_, tolerance_));
        std::size_t about = 0;
        for (const std::vector<VertexEdge>& each : found) about += each.size();
        marked_ = EdgeNumbers(about);
        touched_.assign(point_count(mesh_), 0);
        for (const std::vector<VertexEdge>& each : found)
            for (const VertexEdge& e : each) {
                const std::uint32_t a = mesh_.point(e.a), b = mesh_.point(e.b);
                marked_.add(a, b);
                touched_[a] = touched_[b] = 1;
            }
        return marked_.count() > 0;
    }
    void split()
    {
        struct Split {
            std::uint32_t face;
            std::array<std::uint32_t, 3> middles; // by edge, among those that are split
        };
        std::vector<Split> splits;
        EdgeNumbers edges(marked_.count()); // by vertices
        std::vector<BornVertex> born;
        const auto first_point = static_cast<std::uint32_t>(point_count(mesh_));
        for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
            if (touched(f, 0) + touched(f, 1) + touched(f, 2) < 2) continue;
            Split each{static_cast<std::uint32_t>(f), {}};
            bool any = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = corner(f, i), b = corner(f, i + 1);
                const std::uint32_t marked = marked_.number(mesh_.point(a), mesh_.point(b));
                each.middles[i] = EdgeNumbers::none;
                if (marked == EdgeNumbers::none) continue;
                any = true;
                each.middles[i] = edges.add(a, b);
                if (each.middles[i] < born.size()) continue;
                const VertexEdge e = ordered(a, b);
                born.push_back({e.a, e.b, 0.5f, first_point + marked});
            }
            if (any) splits.push_back(each);
        }
        const auto first_vertex = static_cast<std::uint32_t>(mesh_.vertex_count());
        add_vertices(mesh_, born);
        take_places(first_vertex);
        for (const Split& each : splits) {
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
            } else {
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
                } else {
                    const std::uint32_t m2 = middle(turn + 2);
                    put(f, {m0, m1, m2}, true);
                    put(f, {c[0], m0, m2}, false);
                    put(f, {m0, c[1], m1}, false);
                    put(f, {m2, m1, c[2]}, false);
                }
            }
        }
    }
    FineMesh take() { return {std::move(mesh_), std::move(heights_), std::max(off_, fine_off_)}; }
    std::size_t triangle_count() const { return mesh_.face_count(); }

private:
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
            open_[f] = 1;
            return;
        }
        add_face(mesh_, vertices);
        if (!mesh_.face_material.empty()) mesh_.face_material.push_back(mesh_.face_material[f]);
        if (!mesh_.face_group.empty()) mesh_.face_group.push_back(mesh_.face_group[f]);
        open_.push_back(1);
    }

    Mesh mesh_;
    const SplitField& field_;
    const SplitError& error_;
    double tolerance_;
    std::vector<glm::dvec3> uvw_; // #V
    std::vector<double> heights_; // #V x #openings
    double off_ = 0;              // of the last round
    double fine_off_ = 0;         // of triangles that were fine enough before
    std::vector<char> open_;      // #F: not yet known to be fine enough
    EdgeNumbers marked_;          // by points
    std::vector<char> touched_;   // #points: ends of these
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

FineMesh fine_enough(const Mesh& mesh, const SplitField& field, const SplitError& error,
                     double tolerance, std::size_t most_triangles)
{
    Mesh start = as_triangles(mesh);
    if (start.points.empty()) {
        start.points.resize(start.vertex_count());
        std::iota(start.points.begin(), start.points.end(), 0u);
    }
    Rounds rounds(std::move(start), field, error, tolerance);
    for (int round = 0; rounds.mark(); ++round) {
        if (round >= most_rounds || rounds.triangle_count() >= most_triangles) break;
        rounds.split();
    }
    return rounds.take();
}

} // namespace trivar
