// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/shared_points.h"

#include "core/base/joined_sets.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/multi_index.h"

#include <algorithm>

namespace trivar {
namespace {

// The number of knots, from the first on, that lie on their vertex, less one.
template <int S> int stacked(const SimplexDomain<S>& domain, int vertex)
{
    int out = 0;
    while (out < domain.degree && domain.knot(vertex, out + 1) == domain.vertex(vertex)) ++out;
    return out;
}

// The multi-index of another cell that takes the same knots beyond the first.
template <int S>
MultiIndex<S> same_knots(const std::array<int, S + 1>& from, const MultiIndex<S>& index,
                         const std::array<int, S + 1>& to)
{
    MultiIndex<S> out{};
    for (std::size_t i = 0; i <= S; ++i)
        for (std::size_t k = 0; k <= S; ++k)
            if (from[i] == to[k]) out[k] = index[i];
    return out;
}

} // namespace

template <int S>
std::vector<int> shared_points(const SimplexDomain<S>& domain, PointSharing sharing)
{
    const auto indices = multi_indices<S>(domain.degree);
    std::vector<int> depth;
    for (std::size_t v = 0; v < domain.vertex_count(); ++v)
        depth.push_back(sharing == PointSharing::all ? domain.degree
                                                     : stacked(domain, static_cast<int>(v)));
    JoinedSets sets(domain.cells.size() * indices.size());
    const std::vector<CellFace<S>> faces = sorted_faces(domain);
    std::vector<std::array<int, S>> cuts = domain.cuts;
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::array<int, S>> seams = domain.seams;
    std::sort(seams.begin(), seams.end());
    for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
        const CellFace<S>&a = faces[f], &b = faces[f + 1];
        if (a.vertices != b.vertices || std::binary_search(cuts.begin(), cuts.end(), a.vertices))
            continue;
        const bool seam = std::binary_search(seams.begin(), seams.end(), a.vertices);
        const auto &from = domain.cells[a.cell], &to = domain.cells[b.cell];
        for (std::size_t i = 0; i < indices.size(); ++i) {
            bool shared = indices[i][a.opposite] == 0;
            for (std::size_t k = 0; k <= S && !seam; ++k)
                shared = shared && indices[i][k] <= depth[static_cast<std::size_t>(from[k])];
            if (!shared) continue;
            const MultiIndex<S> same = same_knots<S>(from, indices[i], to);
            const auto there = std::find(indices.begin(), indices.end(), same) - indices.begin();
            sets.join(static_cast<std::uint32_t>(b.cell * indices.size() +
                                                 static_cast<std::size_t>(there)),
                      static_cast<std::uint32_t>(a.cell * indices.size() + i));
        }
    }
    std::vector<int> out(domain.cells.size() * indices.size(), -1);
    std::vector<int> number(out.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        int& of_set = number[sets.root(static_cast<std::uint32_t>(i))];
        if (of_set < 0) of_set = count++;
        out[i] = of_set;
    }
    return out;
}

template std::vector<int> shared_points(const SimplexDomain<2>&, PointSharing);
template std::vector<int> shared_points(const SimplexDomain<3>&, PointSharing);

} // namespace trivar
