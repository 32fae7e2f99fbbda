// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace trivar {

// Chooses one of several kinds for a tile of that seed, each as often as its weight says beside the
// others', so that painting more changes no tile that is there. Weights are not negative; where all
// are 0 it is the first. O(#weights).
std::size_t kind_of(std::uint32_t seed, std::span<const double> weights);

} // namespace trivar
