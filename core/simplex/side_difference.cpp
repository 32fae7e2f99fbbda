// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/side_difference.h"

#include <algorithm>
#include <optional>

namespace trivar {
namespace {

using Edges = std::vector<SidePiece>;

void add(Edges& edges, const SidePlace& from, const SidePlace& to)
{
    if (!(from == to)) edges.push_back({from, to});
}

void add_edge(Edges& edges, const SidePiece& here, const SidePiece& there)
{
    const bool both = !here.empty() && !there.empty();
    if (both && here.from == there.from)
        add(edges, there.to, here.to);
    else if (both && here.to == there.to)
        add(edges, here.from, there.from);
    else {
        add(edges, here.from, here.to);
        add(edges, there.to, there.from);
    }
}

// Across the triangle, from where the body's part of its border ends to where it begins again.
std::optional<SidePiece> chord(const TriangleSide& side)
{
    std::optional<SidePlace> from, to;
    for (std::size_t i = 0; i < 3; ++i)
        if (side.in[i] != side.in[(i + 1) % 3]) (side.in[i] ? from : to) = side.roots[i];
    if (!from || !to) return std::nullopt;
    return SidePiece{*from, *to};
}

// Removes pairs of edges that are the same in both directions.
void cancel(Edges& edges)
{
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j)
            if (edges[i].from == edges[j].to && edges[i].to == edges[j].from) {
                edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(j));
                edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
                --i;
                break;
            }
}

} // namespace

SidePiece piece(const TriangleSide& side, std::size_t i)
{
    const std::size_t j = (i + 1) % 3;
    if (side.in[i] && side.in[j]) return {side.corners[i], side.corners[j]};
    if (side.in[i]) return {side.corners[i], side.roots[i]};
    if (side.in[j]) return {side.roots[i], side.corners[j]};
    return {side.corners[i], side.corners[i]};
}

std::vector<std::vector<SidePlace>> side_difference(const TriangleSide& here,
                                                    const TriangleSide& there)
{
    Edges edges;
    for (std::size_t i = 0; i < 3; ++i) add_edge(edges, piece(here, i), piece(there, i));
    if (const auto c = chord(here)) add(edges, c->from, c->to);
    if (const auto c = chord(there)) add(edges, c->to, c->from);
    cancel(edges);
    std::vector<std::vector<SidePlace>> out;
    while (!edges.empty()) {
        std::vector<SidePlace>& loop = out.emplace_back(1, edges.back().from);
        SidePlace at = edges.back().to;
        edges.pop_back();
        while (!(at == loop.front())) {
            loop.push_back(at);
            // The search succeeds: as many edges begin at a place as end there.
            const auto next = std::find_if(edges.begin(), edges.end(),
                                           [&](const SidePiece& e) { return e.from == at; });
            at = next->to;
            edges.erase(next);
        }
    }
    return out;
}

} // namespace trivar
