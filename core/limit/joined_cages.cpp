// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/joined_cages.h"

#include <algorithm>

namespace trivar {

std::size_t JoinedCages::piece_of(std::uint32_t chart) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(first_chart, chart) -
                                    first_chart.begin() - 1);
}

JoinedCages joined(std::span<const Cage> cages, int smallest_chart, int largest_chart)
{
    const bool faces = std::ranges::all_of(cages, [&](const Cage& cage) {
        return std::ranges::all_of(
            cage.face_sizes, [&](int n) { return n >= smallest_chart && n <= largest_chart; });
    });
    JoinedCages out;
    out.first_chart.push_back(0);
    for (const Cage& cage : cages) {
        const std::size_t charts = faces ? cage.face_sizes.size() : cage.corners.size();
        out.first_chart.push_back(out.first_chart.back() + static_cast<std::uint32_t>(charts));
        append(out.cage, cage);
    }
    return out;
}

} // namespace trivar
