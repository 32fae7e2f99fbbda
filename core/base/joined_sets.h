// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace trivar {

// JoinedSets are sets of the numbers below a count, each one alone at first, that are joined one
// after another. Which member stands for a set follows from the order of the joins alone. Nearly
// O(1) a call. [Tarjan, van Leeuwen, Worst-case analysis of set union algorithms, 1984: halving]
class JoinedSets {
public:
    explicit JoinedSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    // Returns the member that stands for the set of a number.
    std::uint32_t root(std::uint32_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        parent_[root(a)] = root(b);
    } // b's stands for both

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace trivar
