// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_reach.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace trivar {
namespace {

constexpr std::size_t faces_per_look = 4096, points_per_look = 4096;

// FaceBits combines the bits of the vertices of a face.
struct FaceBits {
    int all = 0xff, any = 0; // bits of its vertices

    bool out_of_reach() const { return (all & VertexPlaces::beyond_any) != 0; }
    bool cut() const { return ((all ^ any) & ~VertexPlaces::beyond_any) != 0; }
};

} // namespace

void find_places(const Mesh& mesh, const SplitField& field, VertexPlaces& out)
{
    const Box reach = field.reach();
    const std::size_t openings = field.openings.size();
    struct Extent {
        double least, most; // of a cut surface, by its control points
    };
    std::vector<Extent> extents;
    for (const Opening& o : field.openings) {
        const auto [least, most] = std::ranges::minmax(o.surface.points);
        const double rounding = 1e-9 * (1 + std::abs(least) + std::abs(most));
        extents.push_back({least - rounding, most + rounding});
    }
    const std::size_t others = openings - std::min<std::size_t>(openings, out.surfaces_in_bits);
    out.bits.resize(mesh.vertex_count());
    out.above.resize(others * mesh.vertex_count());
    out.blocks.assign(mesh.vertex_count() / out.vertices_per_block + 1, {});
    const glm::dmat3 to_uvw = glm::transpose(field.frame.axes);
    parallel_blocks(
        mesh.vertex_count(), out.vertices_per_block, [&](std::size_t begin, std::size_t end) {
            VertexPlaces::Block block;
            glm::dvec3 lo = block.box.lo, hi = block.box.hi;
            for (std::size_t v = begin; v < end; ++v) {
                const glm::dvec3 uvw =
                    to_uvw * (glm::dvec3(mesh.positions[v]) - field.frame.origin);
                int bits = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    lo[axis] = uvw[axis] < lo[axis] ? uvw[axis] : lo[axis];
                    hi[axis] = uvw[axis] > hi[axis] ? uvw[axis] : hi[axis];
                    bits |= int{uvw[axis] < reach.lo[axis]} << (2 * axis);
                    bits |= int{uvw[axis] > reach.hi[axis]} << (2 * axis + 1);
                }
                for (std::size_t i = 0; i < openings; ++i) {
                    const bool above =
                        uvw.x > extents[i].most ||
                        (uvw.x >= extents[i].least && field.openings[i].height(uvw) >= 0);
                    if (i < out.surfaces_in_bits)
                        bits |= int{above} << (out.first_above + static_cast<int>(i));
                    else
                        out.above[others * v + i - out.surfaces_in_bits] = above;
                }
                out.bits[v] = static_cast<std::uint8_t>(bits);
            }
            block.box.lo = lo;
            block.box.hi = hi;
            if (mesh.points.empty()) {
                block.least_point = static_cast<std::uint32_t>(begin);
                block.greatest_point = static_cast<std::uint32_t>(end - 1);
            }
            for (std::size_t v = begin; v < end && !mesh.points.empty(); ++v) {
                block.least_point = std::min(block.least_point, mesh.points[v]);
                block.greatest_point = std::max(block.greatest_point, mesh.points[v]);
            }
            out.blocks[begin / out.vertices_per_block] = block;
        });
    out.box = {};
    std::uint32_t greatest = 0;
    for (const VertexPlaces::Block& each : out.blocks) {
        out.box.add(each.box);
        greatest = std::max(greatest, each.greatest_point);
    }
    out.points = mesh.points.empty() ? mesh.vertex_count() : greatest + std::size_t{1};
}

void find_changes(const Mesh& mesh, const VertexPlaces& places, const SplitField& field,
                  const SplitError& error, double tolerance, ToChange& out)
{
    out.faces.clear();
    out.moves = false;
    out.off = 0;
    out.free.assign(places.points, 0); // corners of faces that may be too coarse
    std::vector<char>& near = out.free;
    std::vector<char> near_block(places.points / points_per_look + 1, 0);
    struct FaceBlock {
        std::uint32_t least = 0xffffffff, most = 0; // of its vertices
        bool cut = false, moves = false;
        double off = 0;
    };
    std::vector<FaceBlock> blocks(mesh.face_count() / faces_per_look + 1);
    const std::size_t others = places.above.size() / std::max<std::size_t>(1, mesh.vertex_count());
    const auto bits_of = [&](const std::uint32_t* corner, const std::uint32_t* end) {
        FaceBits out_bits;
        for (; corner != end; ++corner) {
            out_bits.all &= places.bits[*corner];
            out_bits.any |= places.bits[*corner];
        }
        return out_bits;
    };
    const auto is_cut = [&](const FaceBits& bits, const std::uint32_t* corner,
                            const std::uint32_t* end) {
        if (bits.cut()) return true;
        if (others == 0) return false;
        const std::uint8_t* const above = places.above.data();
        const std::uint32_t first = *corner;
        for (++corner; corner != end; ++corner)
            if (!std::equal(above + others * first, above + others * (first + std::size_t{1}),
                            above + others * *corner))
                return true;
        return false;
    };
    const auto mark = [](char& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); };
    const glm::dmat3 to_uvw = glm::transpose(field.frame.axes);
    parallel_blocks(mesh.face_count(), faces_per_look, [&](std::size_t begin, std::size_t end) {
        FaceBlock block;
        for (std::size_t f = begin; f < end; ++f) {
            const std::uint32_t* const first = mesh.corners.data() + mesh.face_begin[f];
            const std::uint32_t* const last = mesh.corners.data() + mesh.face_begin[f + 1];
            for (const std::uint32_t* c = first; c != last; ++c) {
                block.least = std::min(block.least, *c);
                block.most = std::max(block.most, *c);
            }
            const FaceBits bits = bits_of(first, last);
            const bool cut_through = is_cut(bits, first, last);
            block.cut = block.cut || cut_through;
            const bool moved = !bits.out_of_reach();
            if (!moved && !cut_through) continue;
            block.moves = block.moves || moved;
            Box box;
            for (const std::uint32_t* c = first; c != last; ++c)
                box.add(to_uvw * (glm::dvec3(mesh.positions[*c]) - field.frame.origin));
            // A face that is cut counts with both sides.
            const double off = moved ? (cut_through ? 2 / share_of_cut : 1) * error.within(box) : 0;
            const bool near_surface =
                !cut_through || error.surfaces_within(box) <=
                                    far_from_surface * share_of_cut * share_of_whole * tolerance;
            if (off <= tolerance && near_surface) {
                block.off = std::max(block.off, off);
                continue;
            }
            for (const std::uint32_t* c = first; c != last; ++c) {
                mark(near[mesh.point(*c)]);
                mark(near_block[mesh.point(*c) / points_per_look]);
            }
        }
        blocks[begin / faces_per_look] = block;
    });
    // Blocks of vertices among whose points some may be near
    std::vector<char> near_vertices;
    for (const VertexPlaces::Block& each : places.blocks) {
        const std::size_t from = each.least_point / points_per_look;
        const std::size_t to = each.greatest_point / points_per_look;
        const auto at = near_block.begin() + static_cast<long>(std::min(from, to));
        near_vertices.push_back(std::find(at, near_block.begin() + static_cast<long>(to + 1), 1) !=
                                near_block.begin() + static_cast<long>(to + 1));
    }
    std::vector<std::vector<std::uint32_t>> found(blocks.size());
    parallel_blocks(mesh.face_count(), faces_per_look, [&](std::size_t begin, std::size_t end) {
        const FaceBlock& block = blocks[begin / faces_per_look];
        const auto first = near_vertices.begin() + block.least / places.vertices_per_block;
        const auto last = near_vertices.begin() + block.most / places.vertices_per_block + 1;
        const bool may_touch = std::find(first, last, 1) != last;
        if (!block.cut && !may_touch) return;
        for (std::size_t f = begin; f < end; ++f) {
            const std::uint32_t* const corners = mesh.corners.data() + mesh.face_begin[f];
            const std::uint32_t* const corners_end = mesh.corners.data() + mesh.face_begin[f + 1];
            int touched = 0;
            for (const std::uint32_t* c = corners; may_touch && c != corners_end; ++c)
                touched |= near[mesh.point(*c)];
            if (touched != 0 ||
                (block.cut && is_cut(bits_of(corners, corners_end), corners, corners_end)))
                found[begin / faces_per_look].push_back(static_cast<std::uint32_t>(f));
        }
    });
    for (const std::vector<std::uint32_t>& each : found)
        out.faces.insert(out.faces.end(), each.begin(), each.end());
    for (const FaceBlock& block : blocks) {
        out.moves = out.moves || block.moves;
        out.off = std::max(out.off, block.off);
    }
}

} // namespace trivar
