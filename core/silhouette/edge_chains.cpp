// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/edge_chains.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace trivar {
namespace {

constexpr std::uint64_t free_slot = ~std::uint64_t{0};

} // namespace

// Slots follow the lower vertex, so that neighbours share cache lines.
std::int32_t EdgeChainer::node_of(std::uint64_t edge)
{
    const std::uint64_t lower = edge >> 32, higher = edge & 0xFFFFFFFF;
    std::size_t i = (2 * lower + (higher - lower) % 7) & slot_mask_;
    while (slots_[i] != free_slot && slots_[i] != edge) i = (i + 1) & slot_mask_;
    if (slots_[i] == free_slot) {
        slots_[i] = edge;
        numbers_[i] = static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back({edge, -1, -1});
    }
    return numbers_[i];
}

void EdgeChainer::walk(std::size_t from, EdgeChains& out)
{
    std::int32_t before = -1, at = static_cast<std::int32_t>(from);
    bool closed = false;
    while (at >= 0) {
        const Node& node = nodes_[static_cast<std::size_t>(at)];
        seen_[static_cast<std::size_t>(at)] = 1;
        out.edges.push_back(node.edge);
        const std::int32_t next = before < 0 || node.next != before ? node.next : node.other;
        if (next >= 0 && seen_[static_cast<std::size_t>(next)]) {
            closed = static_cast<std::size_t>(next) == from;
            break;
        }
        before = at;
        at = next;
    }
    out.closed.push_back(closed);
    out.first.push_back(static_cast<std::uint32_t>(out.edges.size()));
}

EdgeChains EdgeChainer::operator()(std::span<const std::vector<CrossedTriangle>> triangles)
{
    std::size_t count = 0;
    for (const std::vector<CrossedTriangle>& part : triangles) count += part.size();
    const std::size_t slots = std::bit_ceil(3 * count + 64);
    if (slots_.size() < slots) {
        slots_.resize(slots);
        numbers_.resize(slots);
    }
    slot_mask_ = slots - 1;
    std::fill_n(slots_.begin(), slots, free_slot);
    nodes_.clear();
    nodes_.reserve(count + count / 8);
    const auto link = [&](std::int32_t a, std::int32_t b) {
        Node& node = nodes_[static_cast<std::size_t>(a)];
        assert(node.next < 0 || node.other < 0);
        (node.next < 0 ? node.next : node.other) = b;
    };
    for (const std::vector<CrossedTriangle>& part : triangles)
        for (const CrossedTriangle& triangle : part) {
            const std::int32_t a = node_of(triangle.in), b = node_of(triangle.out);
            link(a, b);
            link(b, a);
        }
    EdgeChains out;
    out.edges.reserve(nodes_.size());
    seen_.assign(nodes_.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (!seen_[i] && nodes_[i].other < 0) walk(i, out);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (!seen_[i]) walk(i, out);
    return out;
}

} // namespace trivar
