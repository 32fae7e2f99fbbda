// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trivar::testing {

// Random numbers that are the same on every machine: those of one case follow from the seed and the
// number of the case. Source: Steele, Lea, Flood 2014, SplitMix64.
class Dice {
public:
    Dice(std::uint64_t seed, int number)
        : state_(seed * 0xd1342543de82ef95u + static_cast<std::uint64_t>(number))
    {
        state_ = next();
    }
    std::uint64_t next()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return z ^ z >> 31;
    }
    std::size_t below(std::size_t count) { return next() % count; } // count at least 1
    // Mostly 1, at most 3: what is damaged too much is refused for its first damage.
    std::size_t few() { return below(2) == 0 ? 1 : 1 + below(3); }
    template <class T> const T& one_of(const std::vector<T>& all) { return all[below(all.size())]; }

private:
    std::uint64_t state_;
};

} // namespace trivar::testing
