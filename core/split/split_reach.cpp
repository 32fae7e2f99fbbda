// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_reach.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace trivar {
namespace {

constexpr std::size_t vertices_per_look = 2048, faces_per_look = 4096, points_per_look = 4096;

} // namespace

VertexPlaces places_of(const Mesh& mesh, const SplitField& field)
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
    VertexPlaces out;
    const std::size_t others = openings - std::min<std::size_t>(openings, out.surfaces_in_bits);
    out.bits.resize(mesh.vertex_count());
    out.above.resize(others * mesh.vertex_count());
    struct Block {
        Box box;
        std::uint32_t greatest_point = 0;
    };
    std::vector<Block> blocks(mesh.vertex_count() / vertices_per_look + 1);
    parallel_blocks(
        mesh.vertex_count(), vertices_per_look, [&](std::size_t begin, std::size_t end) {
            Block block;
            const glm::dmat3 to_uvw = glm::transpose(field.frame.axes);
            for (std::size_t v = begin; v < end; ++v) {
                const glm::dvec3 uvw =
                    to_uvw * (glm::dvec3(mesh.positions[v]) - field.frame.origin);
                block.box.add(uvw);
                int bits = 0;
                for (int axis = 0; axis < 3; ++axis) {
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
            if (!mesh.points.empty())
                block.greatest_point =
                    *std::max_element(mesh.points.begin() + static_cast<long>(begin),
                                      mesh.points.begin() + static_cast<long>(end));
            blocks[begin / vertices_per_look] = block;
        });
    std::uint32_t greatest = 0;
    for (const Block& each : blocks) {
        out.box.add(each.box);
        greatest = std::max(greatest, each.greatest_point);
    }
    out.points = mesh.points.empty() ? mesh.vertex_count() : greatest + std::size_t{1};
    return out;
}

ToChange to_change(const Mesh& mesh, const VertexPlaces& places, const SplitField& field,
                   const SplitError& error, double tolerance)
{
    ToChange out;
    out.free.resize(places.points, 0); // corners of faces that may be too coarse
    std::vector<char>& near = out.free;
    std::vector<char> near_block(places.points / points_per_look + 1, 0);
    struct FaceBlock {
        std::uint32_t least = 0xffffffff, most = 0; // of its points
        bool cut = false, moves = false;
        double off = 0;
    };
    std::vector<FaceBlock> blocks(mesh.face_count() / faces_per_look + 1);
    const auto corners_of = [&](std::size_t f) {
        return std::span(mesh.corners.data() + mesh.face_begin[f],
                         mesh.corners.data() + mesh.face_begin[f + 1]);
    };
    const std::size_t others = places.above.size() / std::max<std::size_t>(1, mesh.vertex_count());
    const auto is_cut = [&](std::span<const std::uint32_t> corners) {
        int all = 0xff, any = 0;
        for (const std::uint32_t v : corners) {
            all &= places.bits[v];
            any |= places.bits[v];
        }
        if (((all ^ any) & ~VertexPlaces::beyond_any) != 0) return true;
        if (others == 0) return false;
        const auto first = places.above.begin() + static_cast<long>(others * corners[0]);
        for (const std::uint32_t v : corners)
            if (!std::equal(first, first + static_cast<long>(others),
                            places.above.begin() + static_cast<long>(others * v)))
                return true;
        return false;
    };
    const auto mark = [](char& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); };
    parallel_blocks(mesh.face_count(), faces_per_look, [&](std::size_t begin, std::size_t end) {
        FaceBlock block;
        const glm::dmat3 to_uvw = glm::transpose(field.frame.axes);
        for (std::size_t f = begin; f < end; ++f) {
            const std::span<const std::uint32_t> corners = corners_of(f);
            int beyond = VertexPlaces::beyond_any;
            for (const std::uint32_t v : corners) {
                const std::uint32_t p = mesh.point(v);
                block.least = std::min(block.least, p);
                block.most = std::max(block.most, p);
                beyond &= places.bits[v];
            }
            const bool cut_through = is_cut(corners);
            block.cut = block.cut || cut_through;
            if (beyond != 0) continue;
            block.moves = true;
            Box box;
            for (const std::uint32_t v : corners)
                box.add(to_uvw * (glm::dvec3(mesh.positions[v]) - field.frame.origin));
            // Of what is cut both sides count
            const double off = (cut_through ? 2 / share_of_cut : 1) * error.within(box);
            if (off <= tolerance) {
                block.off = std::max(block.off, off);
                continue;
            }
            for (const std::uint32_t v : corners) {
                mark(near[mesh.point(v)]);
                mark(near_block[mesh.point(v) / points_per_look]);
            }
        }
        blocks[begin / faces_per_look] = block;
    });
    std::vector<std::vector<std::uint32_t>> found(blocks.size());
    parallel_blocks(mesh.face_count(), faces_per_look, [&](std::size_t begin, std::size_t end) {
        const FaceBlock& block = blocks[begin / faces_per_look];
        const auto first = near_block.begin() + block.least / points_per_look;
        const auto last = near_block.begin() + block.most / points_per_look + 1;
        if (!block.cut && std::find(first, last, 1) == last) return;
        for (std::size_t f = begin; f < end; ++f) {
            const std::span<const std::uint32_t> corners = corners_of(f);
            int touched = 0;
            for (const std::uint32_t v : corners) touched += near[mesh.point(v)];
            if (touched > 0 || (block.cut && is_cut(corners)))
                found[begin / faces_per_look].push_back(static_cast<std::uint32_t>(f));
        }
    });
    for (const std::vector<std::uint32_t>& each : found)
        out.faces.insert(out.faces.end(), each.begin(), each.end());
    for (const FaceBlock& block : blocks) {
        out.moves = out.moves || block.moves;
        out.off = std::max(out.off, block.off);
    }
    return out;
}

} // namespace trivar
