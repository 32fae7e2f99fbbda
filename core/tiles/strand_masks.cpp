// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand_masks.h"

#include <algorithm>

namespace trivar {
namespace {

// Cells whose scale is less are not there, and strands are never thinner than that.
constexpr double thinnest_masked = 1e-3;

} // namespace

void mask_strands(StrandLayout& layout, std::span<const MaskFactors> factors)
{
    for (StrandCell& cell : layout.cells) {
        const MaskFactors &a = factors[cell.stations[1]], &b = factors[cell.stations[2]];
        cell.gone = cell.gone || (a.scale + b.scale) / 2 < thinnest_masked ||
                    !is_there(cell.seed, (a.density + b.density) / 2);
        cell.morph_factor *= (a.morph + b.morph) / 2;
    }
    for (std::size_t s = 0; s < layout.stations.size(); ++s) {
        const double scale = std::max(factors[s].scale, thinnest_masked);
        layout.stations[s].width *= scale;
        layout.stations[s].height *= scale * factors[s].height;
    }
}

} // namespace trivar
