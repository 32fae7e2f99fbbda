// SPDX-License-Identifier: GPL-3.0-or-later
// Compares values of simplex splines with the recursion in rational numbers. Arguments: how many
// points, the seed, the least share of a cell that a simplex of its knots may have.
#include "tests/simplex/recursion_campaign.h"

#include <cstdlib>
#include <fmt/format.h>

int main(int argc, char** argv)
{
    const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
    const auto seed = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 1);
    const double least_share = argc > 3 ? std::atof(argv[3]) : 0.05;
    for (const trivar::CampaignClass& each : trivar::recursion_campaign(count, seed, least_share))
        fmt::print("{} variables, degree {}: {} points, {} missed; values to {:.1e}, {};\n"
                   "    sums at {} to {:.1e}, {}\n",
                   each.variables, each.degree, each.points, each.missed, each.worst_value,
                   each.worst_value_at, each.inside, each.worst_sum, each.worst_sum_at);
}
