// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/texture.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "gpu/context.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <utility>

namespace trivar::gpu {
namespace {

// The unit on which textures are made and filled: no pass reads from it, so that none loses its
// binding when another texture is made halfway.
constexpr unsigned spare_unit = 13;

} // namespace

Texture2D::Texture2D(unsigned format, glm::ivec2 size_px, bool linear, int levels)
    : size_px_(size_px)
{
    while (glGetError() != GL_NO_ERROR) // what was before is not ours
        ;
    glGenTextures(1, &name_);
    bind(spare_unit);
    glTexStorage2D(GL_TEXTURE_2D, levels, format, size_px.x, size_px.y);
    if (glGetError() != GL_NO_ERROR) {
        glDeleteTextures(1, &name_);
        throw Rejected(fmt::format("The graphics card has no room for a picture of {} x {} pixels.",
                                   size_px.x, size_px.y));
    }
    const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture2D::Texture2D(Texture2D&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      size_px_(std::exchange(other.size_px_, glm::ivec2(0)))
{
}

Texture2D& Texture2D::operator=(Texture2D&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(size_px_, other.size_px_);
    return *this;
}

Texture2D::~Texture2D()
{
    if (name_) glDeleteTextures(1, &name_);
}

Texture2D Texture2D::view(unsigned format) const
{
    Texture2D result;
    result.size_px_ = size_px_;
    glGenTextures(1, &result.name_);
    glTextureView(result.name_, GL_TEXTURE_2D, name_, format, 0, 1, 0, 1);
    result.bind(spare_unit);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return result;
}

Texture2D Texture2D::row_of(std::span<const glm::vec4> texels)
{
    Texture2D result(GL_RGBA32F, {static_cast<int>(texels.size()), 1}, true);
    result.write({0, 0}, result.size_px_, texels);
    return result;
}

void Texture2D::write(glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const glm::vec4> rgba) const
{
    bind(spare_unit);
    glTexSubImage2D(GL_TEXTURE_2D, 0, lo_px.x, lo_px.y, count_px.x, count_px.y, GL_RGBA, GL_FLOAT,
                    rgba.data());
}

void Texture2D::write(glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const float> red) const
{
    bind(spare_unit);
    glTexSubImage2D(GL_TEXTURE_2D, 0, lo_px.x, lo_px.y, count_px.x, count_px.y, GL_RED, GL_FLOAT,
                    red.data());
}

void Texture2D::write_rgba(std::span<const std::uint8_t> rgba)
{
    ensure(rgba.size() == static_cast<std::size_t>(size_px_.x) * size_px_.y * 4,
           "pixels are not of this size");
    bind(spare_unit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_UNSIGNED_BYTE,
                    rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void Texture2D::bind(unsigned unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name_);
}

Texels::Texels()
{
    glGenTextures(1, &name_);
}

Texels::~Texels()
{
    glDeleteTextures(1, &name_);
}

void Texels::bind(unsigned unit, const Buffer& buffer) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, name_);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.name());
}

Sampler::Sampler(Edge u, Edge v, bool smooth, bool compare)
{
    const auto wrap = [](Edge edge) {
        return edge == Edge::repeat  ? GL_REPEAT
               : edge == Edge::clamp ? GL_CLAMP_TO_EDGE
                                     : GL_CLAMP_TO_BORDER;
    };
    const std::array<float, 4> white{1, 1, 1, 1};
    const bool mipmapped = smooth && !compare && u != Edge::white_border;
    glGenSamplers(1, &name_);
    glSamplerParameteri(name_, GL_TEXTURE_WRAP_S, wrap(u));
    glSamplerParameteri(name_, GL_TEXTURE_WRAP_T, wrap(v));
    glSamplerParameterfv(name_, GL_TEXTURE_BORDER_COLOR, white.data());
    glSamplerParameteri(name_, GL_TEXTURE_MIN_FILTER,
                        mipmapped ? GL_LINEAR_MIPMAP_LINEAR
                        : smooth  ? GL_LINEAR
                                  : GL_NEAREST);
    glSamplerParameteri(name_, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
    if (mipmapped && is_software())
        // Anisotropic reads take ten times as long there. Pictures are averaged over samples, which
        // affords half a level more of sharpness instead.
        glSamplerParameterf(name_, GL_TEXTURE_LOD_BIAS, -0.5f);
    else if (mipmapped && epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        glSamplerParameterf(name_, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    if (compare) {
        glSamplerParameteri(name_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glSamplerParameteri(name_, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
}

Sampler::Sampler(Sampler&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

Sampler& Sampler::operator=(Sampler&& other) noexcept
{
    std::swap(name_, other.name_);
    return *this;
}

Sampler::~Sampler()
{
    if (name_) glDeleteSamplers(1, &name_);
}

void Sampler::bind(unsigned unit) const
{
    glBindSampler(unit, name_);
}

int largest_texture_px()
{
    constexpr GLint enough = 16384; // what OpenGL 4.3 promises
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return std::min(largest, enough);
}

} // namespace trivar::gpu
