// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/key_numbers.h"

namespace trivar {

// EdgeNumbers gives edges, pairs of two different numbers in either order, numbers from 0 in the
// order in which they came first. O(1) an edge.
class EdgeNumbers {
public:
    static constexpr std::uint32_t none = KeyNumbers::none;

    explicit EdgeNumbers(std::size_t about = 16) : numbers_(about) {}
    std::uint32_t count() const { return static_cast<std::uint32_t>(numbers_.size()); }
    std::uint32_t add(std::uint32_t a, std::uint32_t b) { return numbers_.number(key(a, b)).first; }
    std::uint32_t number(std::uint32_t a, std::uint32_t b) const // none: it has not come
    {
        return numbers_.find(key(a, b));
    }
    // Calls use(a, b) for every edge, a < b, in no order that counts.
    void for_each(auto&& use) const
    {
        numbers_.for_each([&](std::uint64_t key, std::uint32_t) {
            use(static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key));
        });
    }

private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b)
    {
        return a < b ? pair_key(a, b) : pair_key(b, a);
    }

    KeyNumbers numbers_;
};

} // namespace trivar
