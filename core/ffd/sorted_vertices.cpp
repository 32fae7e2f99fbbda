// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/sorted_vertices.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

using CellKey = SortedVertices::CellKey;

struct PlacedVertex {
    CellKey key;
    std::array<float, 3> t{};
};

// Says whether a parameter must be mapped into the domain of an axis. Most lie in it, and this test
// is cheaper than the mapping.
bool goes_round(double t, const Knots& axis)
{
    return !(t >= axis.begin() && t < axis.end()) && axis.closure() != Closure::open &&
           std::isfinite(t);
}

PlacedVertex place(glm::dvec3 uvw, const std::array<Knots, 3>& axes,
                   const std::array<AxisCells, 3>& cells)
{
    PlacedVertex out;
    for (std::size_t a = 0; a < 3; ++a) {
        double& t = uvw[static_cast<int>(a)];
        if (!goes_round(t, axes[a])) continue;
        const Knots::InDomain in = axes[a].into_domain(t);
        t = in.t;
        if (!in.odd) continue;
        for (std::size_t other = 0; other < 3; ++other) {
            if (other == a) continue;
            double& s = uvw[static_cast<int>(other)];
            s = axes[other].begin() + axes[other].end() - s;
            out.key.mirrored ^= 1u << other;
        }
    }
    for (std::size_t a = 0; a < 3; ++a) {
        double t = uvw[static_cast<int>(a)];
        if (goes_round(t, axes[a]))
            t = axes[a].into_domain(t).t; // again, because a later axis may have mirrored it
        const AxisCells::Place at = cells[a].place(t);
        out.key.cell[a] = at.cell;
        out.t[a] = at.t;
    }
    return out;
}

// Sorts `order` stably by a digit of the elements that it refers to.
template <class Digit>
std::vector<std::uint32_t> counting_sort(const std::vector<std::uint32_t>& order,
                                         std::uint32_t digits, const Digit& digit)
{
    std::vector<std::uint32_t> start(digits + std::size_t{1}, 0);
    for (const std::uint32_t i : order) ++start[digit(i) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::uint32_t> sorted(order.size());
    for (const std::uint32_t i : order) sorted[start[digit(i)]++] = i;
    return sorted;
}

std::vector<std::uint32_t> order_by_cell(const std::vector<PlacedVertex>& placed,
                                         const std::array<AxisCells, 3>& cells)
{
    std::vector<std::uint32_t> order(placed.size());
    std::iota(order.begin(), order.end(), 0u);
    for (const std::size_t a : {2, 1, 0})
        order = counting_sort(order, cells[a].count(),
                              [&](std::uint32_t i) { return placed[i].key.cell[a]; });
    const bool mirrored = std::any_of(placed.begin(), placed.end(),
                                      [](const PlacedVertex& p) { return p.key.mirrored != 0; });
    return mirrored
               ? counting_sort(order, 8, [&](std::uint32_t i) { return placed[i].key.mirrored; })
               : order;
}

// Returns a chunk length at which a cell of a solid model has several registers of vertices in a
// chunk, while the results of a chunk fit a second-level cache.
std::size_t chunk_length(const std::array<AxisCells, 3>& cells)
{
    double count = 1;
    for (const AxisCells& axis : cells) count *= axis.count() - 2;
    return std::bit_ceil(static_cast<std::size_t>(std::clamp(32 * count, 16384.0, 32768.0)));
}

template <class T> void resize(std::array<std::vector<T>, 3>& arrays, std::size_t count)
{
    for (std::vector<T>& a : arrays) a.resize(count);
}

// Compares two keys. This runs once per vertex, and the library's comparison of arrays is a
// function call.
bool same_cell(const CellKey& a, const CellKey& b)
{
    return a.cell[0] == b.cell[0] && a.cell[1] == b.cell[1] && a.cell[2] == b.cell[2] &&
           a.mirrored == b.mirrored;
}

struct KeyedRun {
    CellKey key;
    std::uint32_t begin, end;
};

// Sorts the vertices from `begin` on, fills in their part of the arrays and returns their runs.
std::vector<KeyedRun> fill_chunk(SortedVertices& out, std::size_t begin,
                                 const std::vector<PlacedVertex>& placed,
                                 const std::vector<std::uint32_t>& order, const Mesh& mesh,
                                 const Embedding& embedding)
{
    std::vector<KeyedRun> runs;
    const bool identity = embedding.to_rest == glm::dmat4(1);
    const bool normals = !out.normal[0].empty(), tangents = !out.tangent[0].empty();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t to = begin + i, v = begin + order[i];
        const PlacedVertex& p = placed[order[i]];
        const auto place_in_order = static_cast<std::uint32_t>(to);
        if (i == 0 || !same_cell(runs.back().key, p.key))
            runs.push_back({p.key, place_in_order, place_in_order});
        runs.back().end = place_in_order + 1;
        out.place[v] = place_in_order;
        // A product with the identity would turn -0 into 0.
        const glm::dvec4 from(mesh.positions[v], 1),
            rest = identity ? from : embedding.to_rest * from;
        for (std::size_t a = 0; a < 3; ++a) {
            const int axis = static_cast<int>(a);
            out.t[a][to] = p.t[a];
            out.rest[a][to] = static_cast<float>(rest[axis]);
            if (normals) out.normal[a][to] = mesh.normals[v][axis];
            if (tangents) out.tangent[a][to] = mesh.tangents[v][axis];
        }
    }
    return runs;
}

} // namespace

SortedVertices sort_by_cell(const Mesh& mesh, const Embedding& embedding,
                            const std::array<Knots, 3>& axes, const std::array<AxisCells, 3>& cells)
{
    SortedVertices out;
    const std::size_t count = mesh.vertex_count(), padded = count + SortedVertices::slack;
    out.place.resize(count);
    resize(out.t, padded);
    resize(out.rest, padded);
    if (!mesh.normals.empty()) resize(out.normal, padded);
    if (!mesh.normals.empty() && !mesh.tangents.empty()) resize(out.tangent, padded);

    const std::size_t length = chunk_length(cells);
    std::vector<std::vector<KeyedRun>> runs((count + length - 1) / length);
    parallel_blocks(count, length, [&](std::size_t begin, std::size_t end) {
        std::vector<PlacedVertex> placed(end - begin);
        for (std::size_t v = begin; v < end; ++v)
            placed[v - begin] =
                place(glm::dvec3(embedding.to_uvw * glm::dvec4(mesh.positions[v], 1)), axes, cells);
        runs[begin / length] =
            fill_chunk(out, begin, placed, order_by_cell(placed, cells), mesh, embedding);
    });

    for (const auto& chunk : runs)
        for (const KeyedRun& run : chunk) out.cells.push_back(run.key);
    std::sort(out.cells.begin(), out.cells.end());
    out.cells.erase(std::unique(out.cells.begin(), out.cells.end()), out.cells.end());
    out.chunk_begin.push_back(0);
    for (const auto& chunk : runs) {
        for (const KeyedRun& run : chunk) {
            const auto cell = std::lower_bound(out.cells.begin(), out.cells.end(), run.key);
            out.runs.push_back(
                {run.begin, run.end, static_cast<std::uint32_t>(cell - out.cells.begin())});
        }
        out.chunk_begin.push_back(static_cast<std::uint32_t>(out.runs.size()));
    }
    return out;
}

} // namespace trivar
