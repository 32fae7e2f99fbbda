// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace trivar {

// The purposes of random numbers of tiles; a new purpose does not change the numbers of the others.
// Strokes have further ones of their own, below 100.
namespace random_purpose {
inline constexpr std::uint32_t wave = 100, mix = 101, phase = 102, cover_height = 200,
                               texture_height = 201, density = 300;
}

// Mixes the bits of a seed and a number.
std::uint32_t random_bits(std::uint32_t seed, std::uint32_t number);

// Gives a number of [0, 1) for the seed of a tile and a purpose: the same for ever.
double random_share(std::uint32_t seed, std::uint32_t purpose);

// Returns the seed of a tile from the seed of its stroke or cover, and numbers of the tile there;
// random_share mixes its bits.
inline std::uint32_t seed_of(int seed, std::int64_t x, std::int64_t y = 0, std::size_t piece = 0)
{
    return static_cast<std::uint32_t>(seed) * 0x9E3779B9u +
           static_cast<std::uint32_t>(x) * 0x85EBCA6Bu +
           static_cast<std::uint32_t>(y) * 0xC2B2AE35u + static_cast<std::uint32_t>(piece);
}

} // namespace trivar
