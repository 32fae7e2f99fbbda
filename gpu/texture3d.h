// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace trivar::gpu {

// A Texture3D is a three-dimensional GL texture with one channel. Bytes and words are read as 0..1,
// linear in between; numbers are whole numbers, read as they are.
class Texture3D {
public:
    enum class Texels { bytes, words, numbers };
    Texture3D() = default;
    // Throws Rejected where the graphics card has no room for it.
    Texture3D(Texels texels, const glm::ivec3& size);
    Texture3D(Texture3D&& other) noexcept;
    Texture3D& operator=(Texture3D&& other) noexcept;
    ~Texture3D();

    // The layers from z on, x fastest; their number follows from the size of the data.
    void write(int z, std::span<const std::uint8_t> bytes_or_numbers);
    void write(int z, std::span<const std::uint16_t> words);
    void bind(unsigned unit) const;
    const glm::ivec3& size() const { return size_; }
    std::size_t bytes() const;

private:
    void write(int z, std::size_t count, unsigned format, unsigned type, const void* data);
    unsigned name_ = 0;
    Texels texels_ = Texels::bytes;
    glm::ivec3 size_{0};
};

} // namespace trivar::gpu
