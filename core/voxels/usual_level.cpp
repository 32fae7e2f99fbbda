// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/usual_level.h"

#include <algorithm>
#include <cmath>

namespace trivar {

double usual_level(const VolumeSummary& summary, const VoxelGrid& grid)
{
    double count = 0, sum = 0;
    for (std::size_t i = 0; i < summary.histogram.size(); ++i) {
        count += static_cast<double>(summary.histogram[i]);
        sum += static_cast<double>(i) * static_cast<double>(summary.histogram[i]);
    }
    double below = 0, sum_below = 0, best = -1;
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < summary.histogram.size(); ++i) {
        below += static_cast<double>(summary.histogram[i]);
        sum_below += static_cast<double>(i) * static_cast<double>(summary.histogram[i]);
        if (below == 0 || below == count) continue;
        const double apart = sum_below / below - (sum - sum_below) / (count - below);
        if (const double between = below * (count - below) * apart * apart; between > best) {
            best = between;
            at = i + 1;
        }
    }
    const double value = summary.least + (summary.greatest - summary.least) *
                                             static_cast<double>(at) /
                                             static_cast<double>(summary.histogram.size());
    if (std::holds_alternative<std::vector<float>>(grid.samples)) return value;
    return grid.value(std::floor(grid.sample(value)) + 0.5);
}

std::array<double, 2> usual_levels(const VolumeSummary& summary, const VoxelGrid& grid)
{
    const double lower = usual_level(summary, grid), range = summary.greatest - summary.least;
    VolumeSummary dense = summary; // what is above the level
    for (std::size_t i = 0; i < dense.histogram.size(); ++i)
        if (summary.least + range * static_cast<double>(i) / 256 < lower) dense.histogram[i] = 0;
    return {lower, std::max(usual_level(dense, grid), lower + range / 16)};
}

} // namespace trivar
