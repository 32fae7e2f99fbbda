// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_mix.h"

#include "core/tiles/layout.h"

#include <numeric>

namespace trivar {
namespace {

} // namespace

std::size_t kind_of(std::uint32_t seed, std::span<const double> weights)
{
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(all > 0)) return 0;
    double left = all * random_share(seed, random_purpose::mix);
    std::size_t last = 0;
    for (std::size_t kind = 0; kind < weights.size(); ++kind) {
        if (!(weights[kind] > 0)) continue;
        last = kind;
        if (left < weights[kind]) break;
        left -= weights[kind];
    }
    return last;
}

} // namespace trivar
