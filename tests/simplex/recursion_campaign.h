// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace trivar {

// A CampaignClass counts the findings at the points of one dimension and degree.
struct CampaignClass {
    int variables = 3, degree = 1;
    std::size_t points = 0;          // at which values were compared
    std::size_t inside = 0;          // of those, where the sum was looked at
    double worst_value = 0;          // greatest difference of a value to the exact one
    double worst_sum = 0;            // greatest difference of a sum to 1
    std::string worst_value_at = {}; // in words
    std::string worst_sum_at = {};
    std::size_t missed =
        0; // points with a value off by more than 1e-10 or a sum by more than 1e-12
};

// Compares values of simplex splines with the recursion in rational numbers at `count` points,
// random and special ones of domains as special as can be, in turn of two and three variables and
// degree 1 to 3. The same for any number of threads. About 1 ms per point.
std::vector<CampaignClass> recursion_campaign(std::size_t count, std::uint32_t seed,
                                              double least_share = 0.05);

} // namespace trivar
