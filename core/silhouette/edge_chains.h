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

// Joins crossed triangles to chains: those of each part on their own and in parallel, then the
// parts.
//   parts  each edge may be in at most two triangles, as on a manifold: then no chain has a branch
// Open chains come first, ordered by their first edge, the least of a closed chain and the lesser
// end of an open one; so the parts, and the order of triangles in them, make no difference.
// O(#triangles); about 20 ns each on one core.
EdgeChains edge_chains(std::span<const std::vector<CrossedTriangle>> parts);

} // namespace trivar
