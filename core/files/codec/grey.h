// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// One number for a pixel of any channels, as they are stored: the luminance of Rec. 709, which of
// equal channels is their value to the last bit.
template <class T> float grey_of(const T* pixel, std::size_t channels, float full)
{
    const auto r = static_cast<float>(pixel[0]) / full;
    if (channels < 3) return r;
    const auto g = static_cast<float>(pixel[1]) / full, b = static_cast<float>(pixel[2]) / full;
    return g + 0.2126f * (r - g) + 0.0722f * (b - g);
}

// The numbers of pixels as the bytes of floats.
template <class T>
std::vector<std::uint8_t> grey_bytes(std::span<const T> pixels, std::size_t channels, float full)
{
    std::vector<float> grey(pixels.size() / channels);
    for (std::size_t i = 0; i < grey.size(); ++i)
        grey[i] = grey_of(pixels.data() + i * channels, channels, full);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(grey.data());
    return {bytes, bytes + sizeof(float) * grey.size()};
}

} // namespace trivar
