// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// What random numbers of tiles are for; a new purpose does not change the numbers of the others.
// Strokes have further ones of their own, below 100.
namespace random_purpose {
inline constexpr std::uint32_t wave = 100, mix = 101, phase = 102, cover_height = 200,
                               texture_height = 201, density = 300;
}

// Gives a number of [0, 1) for the seed of a tile and a purpose: the same for ever.
double random_share(std::uint32_t seed, std::uint32_t purpose);

} // namespace trivar
