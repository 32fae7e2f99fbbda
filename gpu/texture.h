// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/buffer.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace trivar::gpu {

// A Texture2D is a two-dimensional GL texture with fixed storage.
class Texture2D {
public:
    Texture2D() = default;
    // `format` is a sized internal format; sampled linearly or by the nearest texel, clamped.
    Texture2D(unsigned format, glm::ivec2 size_px, bool linear = false, int levels = 1);
    Texture2D(Texture2D&& other) noexcept;
    Texture2D& operator=(Texture2D&& other) noexcept;
    ~Texture2D();

    // One row of floats, four a texel, sampled linearly.
    static Texture2D row_of(std::span<const glm::vec4> texels);
    // The same texels seen through another format of the same size.
    Texture2D view(unsigned format) const;
    // 8-bit RGBA, first row first; makes the smaller levels.
    void write_rgba(std::span<const std::uint8_t> rgba);
    // A rectangle of float texels, the lowest row first.
    void write(glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const glm::vec4> rgba) const;
    void write(glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const float> red) const;
    void bind(unsigned unit) const;
    unsigned name() const { return name_; }
    glm::ivec2 size_px() const { return size_px_; }

private:
    unsigned name_ = 0;
    glm::ivec2 size_px_{0};
};

// Texels are a buffer that is read as texels of four floats. Every binding names the buffer again,
// because writing may give it another storage.
class Texels {
public:
    Texels();
    Texels(const Texels&) = delete;
    Texels& operator=(const Texels&) = delete;
    ~Texels();
    void bind(unsigned unit, const Buffer& buffer) const;

private:
    unsigned name_ = 0;
};

// A Sampler says how a texture is read, apart from the texture.
class Sampler {
public:
    enum class Edge { repeat, clamp, white_border };
    // `smooth`: linear between texels and levels, anisotropic on a GPU; `compare`: depth comparison
    // (<=).
    Sampler(Edge u, Edge v, bool smooth, bool compare = false);
    Sampler(Sampler&& other) noexcept;
    Sampler& operator=(Sampler&& other) noexcept;
    ~Sampler();
    void bind(unsigned unit) const;

private:
    unsigned name_ = 0;
};

// The longest side of a texture, by the current context and by the limit for pictures here.
int largest_texture_px();

} // namespace trivar::gpu
