// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/texture3d.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <utility>

namespace trivar::gpu {
namespace {

constexpr unsigned spare_unit_3d = 13; // no pass reads from it; see texture.cpp

} // namespace

Texture3D::Texture3D(Texels texels, const glm::ivec3& size) : texels_(texels), size_(size)
{
    GLint longest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest);
    while (glGetError() != GL_NO_ERROR) // what was before is not ours
        ;
    bool room = std::max({size.x, size.y, size.z}) <= longest;
    if (room) {
        glGenTextures(1, &name_);
        bind(spare_unit_3d);
        const GLenum format = texels == Texels::bytes   ? GL_R8
                              : texels == Texels::words ? GL_R16
                                                        : GL_R8UI;
        glTexStorage3D(GL_TEXTURE_3D, 1, format, size.x, size.y, size.z);
        room = glGetError() == GL_NO_ERROR;
    }
    if (!room) {
        glDeleteTextures(1, &name_);
        throw Rejected(fmt::format("The graphics card has no room for {} x {} x {} voxels.", size.x,
                                   size.y, size.z));
    }
    const GLint filter = texels == Texels::numbers ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, filter);
    for (const GLenum edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, edge, GL_CLAMP_TO_EDGE);
}

Texture3D::Texture3D(Texture3D&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      texels_(other.texels_),
      size_(other.size_)
{
}

Texture3D& Texture3D::operator=(Texture3D&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(texels_, other.texels_);
    std::swap(size_, other.size_);
    return *this;
}

Texture3D::~Texture3D()
{
    if (name_) glDeleteTextures(1, &name_);
}

void Texture3D::write(int z, std::size_t count, unsigned format, unsigned type, const void* data)
{
    const std::size_t layer = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    bind(spare_unit_3d);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, size_.x, size_.y, static_cast<int>(count / layer),
                    format, type, data);
}

void Texture3D::write(int z, std::span<const std::uint8_t> bytes_or_numbers)
{
    write(z, bytes_or_numbers.size(), texels_ == Texels::numbers ? GL_RED_INTEGER : GL_RED,
          GL_UNSIGNED_BYTE, bytes_or_numbers.data());
}

void Texture3D::write(int z, std::span<const std::uint16_t> words)
{
    write(z, words.size(), GL_RED, GL_UNSIGNED_SHORT, words.data());
}

void Texture3D::bind(unsigned unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_3D, name_);
}

std::size_t Texture3D::bytes() const
{
    return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
           static_cast<std::size_t>(size_.z) * (texels_ == Texels::words ? 2 : 1);
}

} // namespace trivar::gpu
