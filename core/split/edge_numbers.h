// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace trivar {

// EdgeNumbers gives edges, pairs of two different numbers in either order, numbers from 0 in the
// order in which they came first. A hash table of one array; O(1) an edge.
class EdgeNumbers {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    explicit EdgeNumbers(std::size_t about = 16)
        : slots_(std::bit_ceil(2 * about + 16), Slot{0, none})
    {
    }
    std::uint32_t count() const { return count_; }
    std::uint32_t add(std::uint32_t a, std::uint32_t b)
    {
        if (2 * (count_ + 1) > slots_.size()) grow();
        Slot& slot = slots_[find(key(a, b))];
        if (slot.number == none) slot = {key(a, b), count_++};
        return slot.number;
    }
    std::uint32_t number(std::uint32_t a, std::uint32_t b) const // none: it has not come
    {
        return slots_[find(key(a, b))].number;
    }
    // Calls use(a, b) for every edge, a < b, in no order that counts.
    void for_each(auto&& use) const
    {
        for (const Slot& slot : slots_)
            if (slot.number != none)
                use(static_cast<std::uint32_t>(slot.key >> 32),
                    static_cast<std::uint32_t>(slot.key));
    }

private:
    struct Slot {
        std::uint64_t key;
        std::uint32_t number;
    };
    static std::uint64_t key(std::uint32_t a, std::uint32_t b)
    {
        return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
    }
    std::size_t find(std::uint64_t key) const // its slot, or the free one where it belongs
    {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
        while (slots_[at].number != none && slots_[at].key != key) at = (at + 1) & mask;
        return at;
    }
    void grow()
    {
        std::vector<Slot> old(2 * slots_.size(), Slot{0, none});
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.number != none) slots_[find(slot.key)] = slot;
    }

    std::vector<Slot> slots_;
    std::uint32_t count_ = 0;
};

} // namespace trivar
