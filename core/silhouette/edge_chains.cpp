// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/edge_chains.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <bit>

namespace trivar {
namespace {

constexpr std::int32_t none = -1;

// EdgeSlots finds the number of an edge, among edges that know theirs.
class EdgeSlots {
public:
    explicit EdgeSlots(std::size_t most)
        : slots_(std::bit_ceil(2 * most + 16), none),
          shift_(64 - std::countr_zero(slots_.size()))
    {
    }
    // The number of an edge: this one if it has none yet. `edge_of` tells the edge of a number.
    std::int32_t number_of(std::uint64_t edge, std::int32_t number, auto&& edge_of)
    {
        std::size_t i = edge * 0x9E3779B97F4A7C15 >> shift_; // Fibonacci hashing [Knuth 1973]
        while (slots_[i] != none && edge_of(slots_[i]) != edge) i = (i + 1) & (slots_.size() - 1);
        if (slots_[i] == none) slots_[i] = number;
        return slots_[i];
    }

private:
    std::vector<std::int32_t> slots_;
    int shift_;
};

// A node of chains, and those before and after it.
struct ChainNode {
    std::int32_t next = none, other = none;

    void join(std::int32_t node)
    {
        ensure(next == none || other == none, "three lines meet in a node");
        (next == none ? next : other) = node;
    }
    bool is_end() const { return other == none; }
};

// Calls begin(), add(node) for each node of a chain in turn, and end(closed): first for the open
// chains, then for the closed ones.
void for_chains(std::span<const ChainNode> nodes, auto&& begin, auto&& add, auto&& end)
{
    std::vector<char> seen(nodes.size(), 0);
    const auto walk = [&](std::size_t from) {
        begin();
        std::int32_t before = none, at = static_cast<std::int32_t>(from);
        bool closed = false;
        while (at != none) {
            const ChainNode& node = nodes[static_cast<std::size_t>(at)];
            seen[static_cast<std::size_t>(at)] = 1;
            add(static_cast<std::size_t>(at));
            const std::int32_t next =
                before == none || node.next != before ? node.next : node.other;
            before = at;
            at = next;
            if (at == none || !seen[static_cast<std::size_t>(at)]) continue;
            closed = at == static_cast<std::int32_t>(from);
            break;
        }
        end(closed);
    };
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!seen[i] && nodes[i].is_end()) walk(i);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!seen[i]) walk(i);
}

void end_chain(EdgeChains& out, bool closed)
{
    out.closed.push_back(closed);
    out.first.push_back(static_cast<std::uint32_t>(out.edges.size()));
}

// The chains of one part.
EdgeChains chains_of_part(std::span<const CrossedTriangle> triangles)
{
    EdgeSlots slots(triangles.size() + triangles.size() / 8);
    std::vector<std::uint64_t> edges;
    std::vector<ChainNode> nodes;
    edges.reserve(triangles.size() + triangles.size() / 8);
    nodes.reserve(edges.capacity());
    const auto node_of = [&](std::uint64_t edge) {
        const auto next = static_cast<std::int32_t>(nodes.size());
        const std::int32_t number = slots.number_of(
            edge, next, [&](std::int32_t i) { return edges[static_cast<std::size_t>(i)]; });
        if (number == next) {
            edges.push_back(edge);
            nodes.emplace_back();
        }
        return number;
    };
    for (const CrossedTriangle& triangle : triangles) {
        const std::int32_t a = node_of(triangle.in), b = node_of(triangle.out);
        nodes[static_cast<std::size_t>(a)].join(b);
        nodes[static_cast<std::size_t>(b)].join(a);
    }
    EdgeChains out;
    out.edges.reserve(edges.size());
    for_chains(
        nodes, [] {}, [&](std::size_t i) { out.edges.push_back(edges[i]); },
        [&](bool closed) { end_chain(out, closed); });
    return out;
}

std::span<const std::uint64_t> chain(const EdgeChains& chains, std::size_t c)
{
    return std::span(chains.edges).subspan(chains.first[c], chains.first[c + 1] - chains.first[c]);
}

// Joins the open chains of parts where they end in the same edge. Both ends of each are a node.
EdgeChains joined(std::span<const EdgeChains> parts)
{
    EdgeChains out;
    std::vector<std::span<const std::uint64_t>> open;
    for (const EdgeChains& part : parts)
        for (std::size_t c = 0; c < part.count(); ++c) {
            const std::span<const std::uint64_t> edges = chain(part, c);
            if (!part.closed[c]) {
                open.push_back(edges);
                continue;
            }
            out.edges.insert(out.edges.end(), edges.begin(), edges.end());
            end_chain(out, true);
        }
    std::vector<ChainNode> ends(2 * open.size());
    EdgeSlots slots(ends.size());
    for (std::size_t n = 0; n < ends.size(); ++n) ends[n].join(static_cast<std::int32_t>(n ^ 1));
    const auto edge_of = [&](auto n) {
        const std::span<const std::uint64_t>& edges = open[static_cast<std::size_t>(n) / 2];
        return n % 2 == 0 ? edges.front() : edges.back();
    };
    for (std::size_t n = 0; n < ends.size(); ++n) {
        const auto here = static_cast<std::int32_t>(n);
        const std::int32_t there = slots.number_of(edge_of(n), here, edge_of);
        if (there == here) continue;
        ends[n].join(there);
        ends[static_cast<std::size_t>(there)].join(here);
    }
    std::size_t nodes = 0; // of the present chain
    for_chains(
        ends, [&] { nodes = 0; },
        [&](std::size_t n) {
            if (nodes++ % 2 == 1) return; // the other end of the one before
            const std::span<const std::uint64_t> edges = open[n / 2];
            if (nodes > 1) out.edges.pop_back();
            if (n % 2 == 0)
                out.edges.insert(out.edges.end(), edges.begin(), edges.end());
            else
                out.edges.insert(out.edges.end(), edges.rbegin(), edges.rend());
        },
        [&](bool closed) {
            if (closed) out.edges.pop_back();
            end_chain(out, closed);
        });
    return out;
}

// The edges of a chain from where it begins, whichever way it was found.
void add_from_its_begin(std::span<const std::uint64_t> edges, bool closed,
                        std::vector<std::uint64_t>& out)
{
    if (!closed) {
        if (edges.front() < edges.back())
            out.insert(out.end(), edges.begin(), edges.end());
        else
            out.insert(out.end(), edges.rbegin(), edges.rend());
        return;
    }
    const auto least = std::ranges::min_element(edges);
    const std::uint64_t next = least + 1 == edges.end() ? edges.front() : least[1],
                        before = least == edges.begin() ? edges.back() : least[-1];
    if (next < before) {
        out.insert(out.end(), least, edges.end());
        out.insert(out.end(), edges.begin(), least);
    } else {
        out.insert(out.end(), std::reverse_iterator(least + 1), edges.rend());
        out.insert(out.end(), edges.rbegin(), std::reverse_iterator(least + 1));
    }
}

std::uint64_t first_edge(std::span<const std::uint64_t> edges, bool closed)
{
    return closed ? std::ranges::min(edges) : std::min(edges.front(), edges.back());
}

} // namespace

EdgeChains edge_chains(std::span<const std::vector<CrossedTriangle>> parts)
{
    std::vector<EdgeChains> of_part(parts.size());
    parallel_blocks(parts.size(), 1,
                    [&](std::size_t p, std::size_t) { of_part[p] = chains_of_part(parts[p]); });
    const EdgeChains all = joined(of_part);
    struct Place {
        bool closed;
        std::uint64_t first;
        std::size_t chain;
        auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> order(all.count());
    for (std::size_t c = 0; c < order.size(); ++c)
        order[c] = {all.closed[c] != 0, first_edge(chain(all, c), all.closed[c] != 0), c};
    std::ranges::sort(order);
    EdgeChains out;
    out.edges.reserve(all.edges.size());
    for (const Place& place : order) {
        add_from_its_begin(chain(all, place.chain), place.closed, out.edges);
        end_chain(out, place.closed);
    }
    return out;
}

} // namespace trivar
