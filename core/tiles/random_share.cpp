// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/random_share.h"

namespace trivar {

std::uint32_t random_bits(std::uint32_t a, std::uint32_t b)
{
    std::uint64_t x = (static_cast<std::uint64_t>(a) << 32 | b) + 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return static_cast<std::uint32_t>(x ^ (x >> 31));
}

double random_share(std::uint32_t seed, std::uint32_t purpose)
{
    return random_bits(seed, purpose) * 0x1p-32;
}

} // namespace trivar
