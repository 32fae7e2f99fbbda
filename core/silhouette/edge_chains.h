// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// A mesh edge as one number: its lower vertex, then the other.
inline std::uint64_t edge_key(std::uint32_t i, std::uint32_t j)
{
    return i < j ? std::uint64_t{i} << 32 | j : std::uint64_t{j} << 32 | i;
}

// A CrossedTriangle is one that a curve crosses, by the two edges through which it does.
struct CrossedTriangle {
    std::uint64_t in, out;
};

// EdgeChains are curves on a triangle mesh as the edges that they cross, one after the other.
struct EdgeChains {
    std::vector<std::uint64_t> edges;
    std::vector<std::uint32_t> first{0}; // of each chain, and the end of the last
    std::vector<char> closed;            // by chain
    std::size_t count() const { return closed.size(); }
};

// EdgeChainer joins crossed triangles to chains, and keeps its memory from call to call. Each edge
// may be in at most two of the triangles, as those of a manifold are that change sides: then no
// chain has a branch. Open chains come first. O(#triangles); about 60 ns each.
class EdgeChainer {
public:
    EdgeChains operator()(std::span<const std::vector<CrossedTriangle>> triangles);

private:
    struct Node {
        std::uint64_t edge;
        std::int32_t next, other; // nodes; -1: none
    };
    std::int32_t node_of(std::uint64_t edge);
    void walk(std::size_t from, EdgeChains& out);

    std::vector<std::uint64_t> slots_; // edges; a power of two, at most a third is taken
    std::vector<std::int32_t> numbers_;
    std::size_t slot_mask_ = 0;
    std::vector<Node> nodes_;
    std::vector<char> seen_; // by node
};

} // namespace trivar
