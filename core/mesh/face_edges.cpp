// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_edges.h"

#include "core/base/joined_sets.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <span>

namespace trivar {
namespace {

// The sides of all faces, by the edges along which they run.
class SortedSides {
public:
    // The larger point of the edge, the face, and whether it has the edge from the smaller point.
    // One number, which is sorted at once.
    struct Side {
        std::uint64_t all;
        Side() = default;
        Side(std::uint32_t other, std::uint32_t face, bool upward)
            : all(std::uint64_t{other} << 32 | face << 1 | (upward ? 1u : 0u))
        {
        }
        std::uint32_t other() const { return static_cast<std::uint32_t>(all >> 32); }
        std::uint32_t face() const { return static_cast<std::uint32_t>(all) >> 1; }
        bool upward() const { return (all & 1) != 0; }
    };

    explicit SortedSides(const Mesh& mesh)
    {
        // Every side is filed under its smaller point.
        const auto each_side = [&](auto use) {
            for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
                const std::uint32_t end = mesh.face_begin[f + 1];
                std::uint32_t a = mesh.point(mesh.corners[end - 1]);
                for (std::uint32_t c = mesh.face_begin[f]; c < end; ++c) {
                    const std::uint32_t b = mesh.point(mesh.corners[c]);
                    use(std::min(a, b), Side(std::max(a, b), f, a < b));
                    a = b;
                }
            }
        };
        const std::size_t points = mesh.vertex_count() == 0 ? 0 : point_count(mesh);
        begin_.assign(points + 1, 0);
        each_side([&](std::uint32_t low, const Side&) { ++begin_[low + 1]; });
        for (std::size_t p = 0; p < points; ++p) begin_[p + 1] += begin_[p];
        sides_.resize(mesh.corners.size());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        each_side([&](std::uint32_t low, const Side& side) { sides_[next[low]++] = side; });
        parallel_blocks(points, 1 << 14, [&](std::size_t first, std::size_t last) {
            for (std::size_t p = first; p < last; ++p)
                std::sort(sides_.begin() + begin_[p], sides_.begin() + begin_[p + 1],
                          [](const Side& x, const Side& y) { return x.all < y.all; });
        });
    }

    // Calls use(smaller point, sides, which ascend by their faces) for every edge.
    template <class Use> void each_edge(Use use) const
    {
        for (std::uint32_t p = 0; p + 1 < begin_.size(); ++p)
            for (std::uint32_t i = begin_[p], end; i < begin_[p + 1]; i = end) {
                end = i + 1;
                while (end < begin_[p + 1] && sides_[end].other() == sides_[i].other()) ++end;
                use(p, std::span(sides_.data() + i, sides_.data() + end));
            }
    }

private:
    std::vector<std::uint32_t> begin_;
    std::vector<Side> sides_;
};

} // namespace

FaceEdges::FaceEdges(const Mesh& mesh)
{
    using Side = SortedSides::Side;
    std::vector<std::uint32_t> on_border; // faces
    bool against = false;                 // whether two faces have an edge in the same direction
    JoinedSets joined(mesh.face_count());
    const SortedSides sorted(mesh);
    const auto are_neighbours = [](std::span<const Side> sides) {
        return sides.size() == 2 && sides[0].face() != sides[1].face();
    };
    sorted.each_edge([&](std::uint32_t low, std::span<const Side> sides) {
        if (are_neighbours(sides)) {
            joined.join(sides[1].face(), sides[0].face());
            if (sides[0].upward() == sides[1].upward())
                crowded.insert(crowded.end(), {sides[0].face(), sides[1].face()}), against = true;
            return;
        }
        if (sides.size() == 1) border.insert(border.end(), {low, sides[0].other()});
        const auto up = std::ranges::count(sides, true, &Side::upward);
        for (const Side& side : sides) {
            on_border.push_back(side.face());
            if ((side.upward() ? up : std::ssize(sides) - up) > 1) crowded.push_back(side.face());
        }
    });
    if (against)
        sorted.each_edge([&](std::uint32_t, std::span<const Side> sides) {
            if (are_neighbours(sides))
                neighbours.push_back(
                    {sides[0].face(), sides[1].face(), sides[0].upward() == sides[1].upward()});
        });
    constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> part_of_root(mesh.face_count(), none);
    part_of.resize(mesh.face_count());
    for (std::uint32_t f = 0; f < part_of.size(); ++f) {
        std::uint32_t& part = part_of_root[joined.root(f)];
        if (part == none) part = static_cast<std::uint32_t>(parts++);
        part_of[f] = part;
    }
    open.assign(parts, false);
    for (const std::uint32_t f : on_border) open[part_of[f]] = true;
}

} // namespace trivar
