// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/incision.h"

#include <algorithm>
#include <array>

namespace trivar {

// A Narrowing is the share of its opening that an incision is admitted, along its length: 1
// everywhere at first. x is the share of the length.
class Narrowing {
public:
    double at(double x) const;
    bool any() const { return least() < 1; }
    double least() const;
    // Limits the opening to `most` at x, rising with the distance to its former value at `radius`.
    // For a loop it goes `round` the ends.
    void narrow(double x, double most, double radius, bool round = false);
    // Multiplies it by `factor` where another is half or less, and by less than that where it is
    // more.
    void lower_where_narrowed(const Narrowing& other, double factor);
    // Returns the greatest opening of a part between two shares of the length, as a share of the
    // greatest of a profile along the part.
    double widest(const IncisionProfile& profile, double from = 0, double to = 1) const;

private:
    static constexpr std::size_t steps = 256; // along the incision
    std::array<double, steps + 1> share_ = filled();
    static constexpr std::array<double, steps + 1> filled()
    {
        std::array<double, steps + 1> out{};
        out.fill(1);
        return out;
    }
};

// An Admitted is the share of its opening that an incision is admitted: in the skin, and, as a
// further share, at half the depth of its floor and below.
struct Admitted {
    Narrowing opening, below;
    // Returns the share at x, at a depth given as a share of the floor's.
    double at(double x, double depth) const
    {
        const double whole = opening.at(x);
        return depth > 0 ? whole * (1 - std::min(1.0, 2 * depth) * (1 - below.at(x))) : whole;
    }
};

// An Admission is what an incision is admitted beside the older ones, as far as these open, and
// while all others are shut.
struct Admission {
    Admitted with_others, alone;
    std::vector<std::uint32_t> held_by; // incisions without which it is as if it were alone
};

} // namespace trivar
