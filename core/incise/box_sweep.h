// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// A BoxSweep finds the pairs of boxes that are not apart, and now and then one that nearly is not:
// it rounds boxes to steps of the box of all. Boxes lie in strips across the second longest of the
// three axes and are sorted along the longest. Costs O(#boxes + #pairs) where boxes are of like
// size and those over one place are few.
class BoxSweep {
public:
    // Takes finite boxes. With marks, pairs without a marked one are left out.
    BoxSweep(std::span<const Box> boxes, std::span<const char> marked);

    // A box in a strip. The work is that of the entries, which may be done in any order.
    std::size_t entry_count() const { return entries_.size() - 1; }
    // Calls visit(a, b) for the pairs of some entries with later ones: each pair once of all.
    void pairs(std::size_t begin, std::size_t end, auto&& visit) const
    {
        for (std::size_t i = begin; i < end; ++i) {
            const Entry& a = entries_[i];
            for (const Entry* b = &a + 1; b->from <= a.to; ++b)
                if ((((b->most | tops) - a.least) & tops) == tops) visit(a.box, b->box);
        }
    }

private:
    // An entry of a begins before one of b, and `least` of a is nowhere above `most` of b, field by
    // field: the boxes meet across the longest axis, one is marked, and in one it is the first
    // strip. Each field has a bit above it, which stays where nothing was borrowed from it.
    struct Entry {
        std::uint64_t least, most;
        std::uint32_t from, to; // strip, then steps along the longest axis
        std::uint32_t box;
    };
    static constexpr std::uint32_t most_steps = (1 << 14) - 1, along_bits = 12;
    static constexpr std::uint64_t tops =
        1ull << 63 | 1ull << 48 | 1ull << 33 | 1ull << 18 | 1ull << 3 | 1ull << 1;
    static std::uint64_t fields(const std::array<std::uint32_t, 4>& wide, bool x, bool y);

    std::vector<Entry> entries_; // ascending by `from`; the last one ends them
};

} // namespace trivar
