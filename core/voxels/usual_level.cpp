// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/usual_level.h"

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

} // namespace trivar
