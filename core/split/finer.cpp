// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/finer.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/split/halve_edges.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

constexpr int most_rounds = 16;
constexpr std::size_t triangles_per_block = 1 << 10, vertices_per_turn = 1 << 11;

using PointEdge = std::array<std::uint32_t, 2>;

// The worst bounds of triangles that are whole and of those that are cut.
struct Worst {
    double whole = 0, cut = 0;

    void add(double off, bool is_cut)
    {
        (is_cut ? cut : whole) = std::max(is_cut ? cut : whole, off);
    }
    void add(const Worst& other)
    {
        whole = std::max(whole, other.whole);
        cut = std::max(cut, other.cut);
    }
};

// Splits triangles round by round.
class Rounds {
public:
    Rounds(Mesh mesh, std::vector<char> free, const SplitField& field, const SplitError& error,
           double tolerance)
        : mesh_(std::move(mesh)),
          free_(std::move(free)),
          field_(field),
          error_(error),
          tolerance_(tolerance)
    {
        points_ = free_.size();
        take_places(0);
        open_.resize(mesh_.face_count());
        std::iota(open_.begin(), open_.end(), 0u);
    }
    // Returns whether any edge is to be split.
    bool mark()
    {
        struct Block {
            std::vector<PointEdge> edges;
            Worst of_all, of_settled;
        };
        std::vector<Block> blocks(open_.size() / triangles_per_block + 1);
        const Box reach = field_.reach();
        const std::size_t openings = field_.openings.size();
        parallel_blocks(open_.size(), triangles_per_block, [&](std::size_t begin, std::size_t end) {
            Block& block = blocks[begin / triangles_per_block];
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t f = open_[k];
                const std::array<glm::dvec3, 3> p{uvw_[corner(f, 0)], uvw_[corner(f, 1)],
                                                  uvw_[corner(f, 2)]};
                Box box;
                for (const glm::dvec3& each : p) box.add(each);
                const std::array<const double*, 3> heights{&heights_[openings * corner(f, 0)],
                                                           &heights_[openings * corner(f, 1)],
                                                           &heights_[openings * corner(f, 2)]};
                const bool cut = is_cut(heights);
                if (!cut && box.apart(reach)) continue;
                EdgeErrors off = error_.edges(p, heights);
                const double whole = whole_error(off);
                const double allowed = cut ? share_of_cut * tolerance_ : tolerance_;
                block.of_all.add(whole, cut);
                const std::size_t before = block.edges.size();
                if (cut) keep_near(p, heights, off);
                const double coarse = cut ? whole_error(off) : whole;
                // All edges that are too coarse, or else the coarsest
                const double least = std::min(allowed, 0.999 * std::ranges::max(off));
                for (std::size_t i = 0; i < 3 && coarse > allowed; ++i) {
                    if (off[i] <= least) continue;
                    const std::uint32_t a = mesh_.point(corner(f, i));
                    const std::uint32_t b = mesh_.point(corner(f, i + 1));
                    if (free_[a] || free_[b]) block.edges.push_back({a, b});
                }
                if (block.edges.size() == before) block.of_settled.add(whole, cut);
            }
        });
        off_ = {};
        std::size_t about = 0;
        for (const Block& each : blocks) {
            off_.add(each.of_all);
            settled_off_.add(each.of_settled);
            about += each.edges.size();
        }
        if (about == 0) return false;
        marked_ = EdgeNumbers(about);
        for (const Block& each : blocks)
            for (const auto& [a, b] : each.edges) marked_.add(a, b);
        return true;
    }
    void split()
    {
        const std::size_t first_vertex = mesh_.vertex_count();
        open_ = halve_edges(mesh_, points_, marked_);
        points_ += marked_.count();
        free_.resize(points_, 1);
        take_places(first_vertex);
    }
    FineMesh take()
    {
        off_.add(settled_off_);
        return {std::move(mesh_), std::move(heights_), off_.whole, off_.cut};
    }
    std::size_t triangle_count() const { return mesh_.face_count(); }

private:
    std::uint32_t corner(std::size_t f, std::size_t i) const
    {
        return mesh_.corners[3 * f + i % 3];
    }
    static bool is_cut_by(std::size_t i, const std::array<const double*, 3>& heights)
    {
        const bool above = heights[0][i] >= 0;
        return (heights[1][i] >= 0) != above || (heights[2][i] >= 0) != above;
    }
    bool is_cut(const std::array<const double*, 3>& heights) const
    {
        for (std::size_t i = 0; i < field_.openings.size(); ++i)
            if (is_cut_by(i, heights)) return true;
        return false;
    }
    // Beside the walls, too, the rim is to be near the cut surface, so that the cap can be.
    void keep_near(const std::array<glm::dvec3, 3>& uvw,
                   const std::array<const double*, 3>& heights, EdgeErrors& edges) const
    {
        for (std::size_t i = 0; i < field_.openings.size(); ++i) {
            if (!is_cut_by(i, heights)) continue;
            const EdgeErrors bends =
                error_.surface(i, {glm::dvec2(uvw[0].y, uvw[0].z), glm::dvec2(uvw[1].y, uvw[1].z),
                                   glm::dvec2(uvw[2].y, uvw[2].z)});
            for (std::size_t k = 0; k < 3; ++k)
                edges[k] = std::max(edges[k], bends[k] / far_from_surface);
        }
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

    Mesh mesh_;
    std::vector<char> free_; // by point
    const SplitField& field_;
    const SplitError& error_;
    double tolerance_;
    std::vector<glm::dvec3> uvw_;     // #V
    std::vector<double> heights_;     // #V x #openings
    Worst off_;                       // of the last round
    Worst settled_off_;               // of triangles that were not to be split
    std::vector<std::uint32_t> open_; // faces that are not yet known to be fine enough
    std::size_t points_ = 0;
    EdgeNumbers marked_; // by points
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

FineMesh fine_enough(Mesh mesh, std::vector<char> free, const SplitField& field,
                     const SplitError& error, double tolerance, std::size_t most_triangles)
{
    ensure(mesh.points.size() == mesh.vertex_count(), "vertices have no points");
    Rounds rounds(triangulated(std::move(mesh)), std::move(free), field, error, tolerance);
    for (int round = 0; rounds.mark(); ++round) {
        if (round >= most_rounds || rounds.triangle_count() >= most_triangles) break;
        rounds.split();
    }
    return rounds.take();
}

} // namespace trivar
