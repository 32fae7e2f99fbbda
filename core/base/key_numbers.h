// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace trivar {

// KeyNumbers finds numbers by keys: a hash table of one array, O(1) a key. It is for regions of a
// mesh that are small beside the mesh; its cost depends on the number of keys alone.
class KeyNumbers {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF; // no number

    KeyNumbers() = default;
    // Reserves room for so many keys.
    explicit KeyNumbers(std::size_t about) : slots_(std::bit_ceil(2 * about + 16)) {}

    std::uint32_t find(std::uint64_t key) const
    {
        if (slots_.empty()) return none;
        std::size_t i = place(key);
        while (slots_[i].number != none && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
        return slots_[i].number;
    }
    bool contains(std::uint64_t key) const { return find(key) != none; }

    // The number kept for the key: `number` if it is new, which `second` says.
    std::pair<std::uint32_t, bool> insert(std::uint64_t key, std::uint32_t number)
    {
        if (2 * (count_ + 1) > slots_.size()) grow();
        std::size_t i = place(key);
        while (slots_[i].number != none) {
            if (slots_[i].key == key) return {slots_[i].number, false};
            i = (i + 1) & (slots_.size() - 1);
        }
        slots_[i] = {key, number};
        ++count_;
        return {number, true};
    }
    // The number of a key when keys are numbered from 0 in the order in which they came.
    std::pair<std::uint32_t, bool> number(std::uint64_t key)
    {
        return insert(key, static_cast<std::uint32_t>(count_));
    }
    std::size_t size() const { return count_; }
    // Calls use(key, number) for every key, in no order that counts.
    void for_each(auto&& use) const
    {
        for (const Slot& slot : slots_)
            if (slot.number != none) use(slot.key, slot.number);
    }

private:
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t number = none;
    };
    std::size_t place(std::uint64_t key) const // [Knuth, multiplicative hashing]
    {
        return (key * 0x9E3779B97F4A7C15u >> 32) & (slots_.size() - 1);
    }
    void grow()
    {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        count_ = 0;
        for (const Slot& slot : old)
            if (slot.number != none) insert(slot.key, slot.number);
    }

    std::vector<Slot> slots_; // a power of two; at most half are taken
    std::size_t count_ = 0;
};

inline std::uint64_t pair_key(std::uint32_t a, std::uint32_t b)
{
    return std::uint64_t{a} << 32 | b;
}

} // namespace trivar
